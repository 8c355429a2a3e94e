/// Who holds which running attempt, since when, until when, and what was heard of its work.
///
/// An attempt runs until its lease is over; whatever is heard from its worker renews the lease.
/// Nothing is ended here: whoever asks is told what has run out. Invariants, checked by validate():
///  1. Every running attempt has a lease, and every lease is of one.
///  2. A process holds at most one attempt, and only one that runs.
///  3. A lease does not end before its attempt began.
/// Units: times in milliseconds, of a clock that may leap ahead. Cost: O(log attempts), where it is
/// not said.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "coordinator/decisions/attempt_work.h"
#include "coordinator/decisions/worker_process.h"
#include "store/rows.h"

namespace tetfarm {

class Leases {
 public:
  explicit Leases(std::int64_t lease_ms) : lease_ms_(lease_ms) {}

  /// The attempt runs from now on; after a restart of the coordinator: it ran already.
  /// @pre it has no lease.
  void begin(const AttemptRow& attempt, std::int64_t now_ms);
  /// @pre it has a lease.
  void renew(AttemptId attempt, std::int64_t now_ms);
  /// What is known of its work is forgotten with it. @pre it has a lease.
  void end(const AttemptRow& attempt);

  bool has(AttemptId attempt) const { return leases_.contains(attempt); }
  /// @pre it has a lease.
  std::int64_t started_ms(AttemptId attempt) const { return leases_.at(attempt).started_ms; }
  /// The attempt that the process holds; nothing when there is none, or it cannot be told apart
  /// from others for want of a nonce.
  std::optional<AttemptId> held_by(const WorkerProcess& process) const;

  /// Those that are over, by their numbers. Cost: O(attempts).
  std::vector<AttemptId> run_out(std::int64_t now_ms) const;
  /// When the first of them is over; nothing when none runs. Cost: O(attempts).
  std::optional<std::int64_t> first_end_ms() const;

  /// What its worker says of it, see AttemptWork::note. @pre it has a lease.
  void note_work(AttemptId attempt, const WorkCount& count, double share);
  /// Null when nothing was heard of it. Good until it is heard again.
  const AttemptWork* work_of(AttemptId attempt) const;

  /// The broken invariants, in words; empty when all is well. Cost: O(attempts).
  std::vector<std::string> validate(const std::map<AttemptId, AttemptRow>& running) const;

 private:
  struct Lease {
    std::int64_t started_ms = 0;  ///< after a restart: since then
    std::int64_t ends_ms = 0;
    std::optional<AttemptWork> work = {};
  };

  std::int64_t lease_ms_;
  std::map<AttemptId, Lease> leases_;
  std::map<WorkerProcess, AttemptId> process2attempt_;
};

}  // namespace tetfarm
