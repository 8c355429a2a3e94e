// The coordinator's database with a disk that fails: the real JobDatabase over a file system in
// memory, or, for most schedules because it is a hundred times as cheap, a model of it.
//
// The model: a transaction is there wholly or not at all; one that was reported as failed by a
// broken disk, or during which the process died, may be found after a restart, until another is
// committed that changes something: SQLite writes nothing for rows that are as they were. The real
// one must agree with the model: after each restart it holds exactly what was
// committed, with or without the one that is in doubt.
#pragma once

#include <gtest/gtest.h>

#include <cerrno>
#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "store/job_database.h"
#include "tests/coordinator/durable_record.h"
#include "tests/coordinator/memory_vfs.h"

namespace tetfarm::simulation {

enum class Fault { none, full, busy, broken, killed };

inline bool same(const DurableState& a, const DurableState& b) {
  return a.jobs == b.jobs && a.subdomains == b.subdomains && a.tasks == b.tasks &&
         a.running_attempts == b.running_attempts && a.quarantined_hosts == b.quarantined_hosts &&
         a.last_task == b.last_task && a.last_attempt == b.last_attempt &&
         a.last_worker == b.last_worker;
}

class FarmDatabase {
 public:
  FarmDatabase(bool is_real, Random random) : random_(random) {
    if (is_real) real_ = std::make_unique<Real>();
  }

  const DurableRecord& record() const { return record_; }

  /// @throws IoError as JobDatabase does. After Fault::killed the process is gone in any case.
  void apply(const ChangeSet& changes, Fault fault) {
    if (changes.empty()) return;
    // A transaction for which there was no room, or that somebody's lock kept out, was never
    // written.
    const bool may_be_written = fault == Fault::broken || fault == Fault::killed;
    const bool may_leave_traces = may_be_written || (real_ && fault == Fault::full);
    if (may_leave_traces || (real_ && fault == Fault::busy && !in_doubt_)) in_doubt_ = changes;
    if (real_) {
      real_->apply(changes, fault, random_);
    } else if (fault == Fault::full) {
      throw IoError("no room", "database", ENOSPC);
    } else if (fault == Fault::busy) {
      throw IoError("locked", "database", EBUSY);
    } else if (fault == Fault::broken || fault == Fault::killed) {
      throw IoError("broken", "database", EIO);
    }
    const std::optional<DurableState> before =
        in_doubt_ ? std::optional(record_.state()) : std::nullopt;
    record_.apply(changes);
    if (before && (!same(*before, record_.state()) || !changes.events.empty())) in_doubt_.reset();
  }

  /// What a coordinator finds that starts.
  DurableState open(bool after_blackout) {
    if (!real_) {
      if (in_doubt_ && random_.chance(0.5)) keep_what_was_in_doubt();
      in_doubt_.reset();
      return record_.state();
    }
    real_->reopen(after_blackout, random_);
    DurableState found = compare(real_->database->load());
    in_doubt_.reset();
    return found;
  }

  /// The transaction that was in doubt and turned out to be there, if there was one.
  std::optional<ChangeSet> take_found() { return std::exchange(found_, std::nullopt); }

  /// What the same process finds after a commit that failed.
  DurableState load() { return real_ ? compare(real_->database->load()) : record_.state(); }

  // What is read of it, which the real one must read alike.
  DurableState load_unfinished() const {
    const DurableState part = record_.unfinished();
    EXPECT_TRUE(!real_ || same(part, real_->database->load_unfinished())) << "other rows";
    return part;
  }
  DurableState load_job(JobId job) const {
    const DurableState part = record_.rows_of(job);
    EXPECT_TRUE(!real_ || same(part, real_->database->load_job(job))) << "other rows";
    return part;
  }
  std::optional<TaskRow> find_task(TaskId task) const {
    const std::optional<TaskRow> row = record_.row_of(task);
    EXPECT_TRUE(!real_ || row == real_->database->find_task(task)) << "another row";
    return row;
  }

 private:
  struct Real {
    Real() {
      static const MemoryVfs::Files fresh = [] {
        MemoryVfs blank;
        JobDatabase(path).apply({});
        return blank.contents();
      }();
      disk = std::make_unique<MemoryVfs>();
      disk->restore(fresh);
      database = std::make_unique<JobDatabase>(path);
    }
    ~Real() { database.reset(); }
    Real(const Real&) = delete;
    Real& operator=(const Real&) = delete;

    void apply(const ChangeSet& changes, Fault fault, Random& random) {
      if (fault == Fault::busy) disk->lock_out();
      if (fault == Fault::full) disk->fail_after(random.pick(12), SQLITE_FULL);
      if (fault == Fault::broken) disk->fail_after(random.pick(40), SQLITE_IOERR_WRITE);
      if (fault == Fault::killed) disk->fail_after(random.pick(40), SQLITE_IOERR_FSYNC);
      try {
        database->apply(changes);
      } catch (...) {
        if (fault != Fault::killed) disk->heal();
        throw;
      }
      if (fault == Fault::killed) throw IoError("killed", path, EIO);
      disk->heal();
    }

    void reopen(bool after_blackout, Random& random) {
      disk->kill();
      database.reset();
      if (after_blackout) disk->lose_power(random);
      disk->heal();
      database = std::make_unique<JobDatabase>(path);
    }

    static constexpr const char* path = "/simulated.sqlite";
    std::unique_ptr<MemoryVfs> disk;
    std::unique_ptr<JobDatabase> database;
  };

  void keep_what_was_in_doubt() {
    record_.apply(*in_doubt_);
    found_ = std::exchange(in_doubt_, std::nullopt);
  }

  DurableState compare(DurableState found) {
    if (!same(found, record_.state()) && in_doubt_) {
      keep_what_was_in_doubt();
    }
    EXPECT_TRUE(same(found, record_.state())) << "the database lost or made up a transaction";
    return found;
  }

  Random random_;
  DurableRecord record_;
  std::optional<ChangeSet> in_doubt_;
  std::optional<ChangeSet> found_;
  std::unique_ptr<Real> real_;
};

}  // namespace tetfarm::simulation
