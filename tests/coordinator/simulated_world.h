// What can go wrong with a farm, the messages that travel in it, and its disk.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>

#include "coordinator/decisions/job_state.h"
#include "proto/messages.pb.h"
#include "tests/coordinator/simulation_random.h"

namespace tetfarm::simulation {

/// Chances: for each message, each attempt, or each step, as said.
struct Trouble {
  double lost = 0;  // messages
  double doubled = 0;
  std::int64_t latest_ms = 20;  // which also reorders them
  double break_off = 0;         // step: a connection breaks, and what travels on it is lost
  double death = 0;             // worker and step: kill -9
  double stop = 0;              // worker and step: SIGSTOP, for a while; its messages wait for it
  double vacate = 0;            // worker and step: SIGTERM from the batch system
  double walltime = 0;          // new worker: it knows when it will be ended
  double blind = 0;             // new worker: it does not see the store
  double absent = 0;            // a Hello: nobody is at the other end of the connection
  double swept = 0;             // a Welcome: what the worker left in the store is gone
  double power = 0;             // step: a host loses power, and what it had not synced
  double crash = 0;             // attempts: an error
  double kill = 0;              // attempts: ended from outside
  double hang = 0;              // attempts: never ends by itself
  double hungry = 0;            // attempts that need more room than they were given: out of memory
  double full_disk = 0;         // attempts: no room for the result
  double no_process = 0;        // attempts: their process does not start
  double bad_files = 0;         // files that go over the connection: full or damaged disk
  double vanish = 0;            // step: a file of the store vanishes
  double restart = 0;           // turn of the coordinator, at each of several points: kill -9
  double blackout = 0;          // of these: its host loses power, and what is not synced
  double commit_full = 0;       // commits: SQLITE_FULL
  double commit_busy = 0;       // commits: SQLITE_BUSY
  double commit_broken = 0;     // commits: SQLITE_IOERR, which ends the coordinator
  double leap = 0;              // step: the coordinator's host sleeps, all of a sudden it is later
  double wall_jump = 0;         // step: somebody sets the wall clock, forward or back
  double forgery = 0;           // step: a process speaks of another one's attempt
  double whim = 0;              // step: a client cancels, drains, submits again
  bool has_bad_host = false;    // every task crashes on one host for a while
  bool is_strict = false;       // limits of tries as in a real farm, and a person who says retry
};

/// What workers say and hear are the messages of the wire; copies of a message are one.
using Message = std::shared_ptr<const wire::Envelope>;

template <class Fill>
Message message_of(const Fill& fill) {
  auto envelope = std::make_shared<wire::Envelope>();
  fill(*envelope);
  return envelope;
}

struct SubmitSaid {
  int job = 0;
};
struct CancelSaid {
  JobId job;
};
struct RetrySaid {
  JobId job;
  TaskId task;
};
struct LetGoSaid {
  std::string host;
};
struct DrainSaid {
  WorkerId worker;
};
using ToCoordinator =
    std::variant<Message, SubmitSaid, CancelSaid, RetrySaid, LetGoSaid, DrainSaid>;

/// A shared folder under hashes. A file becomes visible whole (rename) and is durable a moment
/// later (fsync of the folder), which is when its writer may speak of it.
class Disk {
 public:
  void publish_input(const ArtifactRef& file) { files_[file.hash] = {file.size, "", true}; }
  void rename(const ArtifactRef& file, const std::string& host) {
    files_.try_emplace(file.hash, File{file.size, host, false});
  }
  void sync(const ArtifactRef& file) {
    const auto found = files_.find(file.hash);
    if (found != files_.end()) found->second.is_durable = true;
  }
  bool has(const ArtifactRef& file) const {
    const auto found = files_.find(file.hash);
    return found != files_.end() && found->second.size == file.size;
  }
  /// Whether it was made durable: what the disk lost after that is not the farm's fault.
  bool was_durable(const ArtifactRef& file) const {
    const auto found = files_.find(file.hash);
    const bool is_durable = found != files_.end() && found->second.is_durable;
    return is_durable || lost_.contains(file.hash);
  }
  void lose_power(const std::string& host) {
    std::erase_if(files_, [&host](const auto& entry) {
      return entry.second.host == host && !entry.second.is_durable;
    });
  }
  /// Whoever removes a file says that nobody needs it; it may be gone already.
  void remove(const std::string& hash) { files_.erase(hash); }
  std::set<std::string> hashes() const {
    std::set<std::string> all;
    for (const auto& [hash, file] : files_) all.insert(hash);
    return all;
  }
  /// Any file but those that a client gave; none when the lot falls on one of those.
  void lose_one(Random& random) {
    if (files_.empty()) return;
    auto file = files_.begin();
    std::advance(file, random.pick(static_cast<std::int64_t>(files_.size())));
    if (file->second.host.empty()) return;
    if (file->second.is_durable) lost_.insert(file->first);
    files_.erase(file);
  }

 private:
  struct File {
    std::uint64_t size = 0;
    std::string host;  // that wrote it; "": a client
    bool is_durable = false;
  };
  std::map<std::string, File> files_;
  std::set<std::string> lost_;  // that were durable
};

}  // namespace tetfarm::simulation
