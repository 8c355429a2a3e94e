/// Failures of tasks that name damaged inputs, until it is known whether those are damaged.
///
/// Without I/O: failures go in, orders for the thread of files come out, and their answers bring
/// the failures back. Files may have gigabytes: whoever speaks meanwhile is answered. Nothing of
/// this is durable: a worker says its result again until it is accepted.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coordinator/decisions/job_state.h"
#include "coordinator/file_orders.h"

namespace tetfarm {

class DamageChecks {
 public:
  struct Failure {
    WorkerId worker;
    TaskId task;
    AttemptId attempt;
    TaskFailure what;
  };

  /// A failure of an attempt that the worker holds, and the inputs of its task that it names. Said
  /// again while they are looked at, it changes nothing but who said it. @pre there are such
  /// inputs.
  void take(Failure failure, const std::vector<ArtifactRef>& claimed);

  /// What is to be looked at and was not given out yet.
  std::vector<FileOrder> take_orders();

  /// The failure, when this was the last of its files, with those that are damaged; where none is,
  /// the attempt is as one that was killed. Nothing when others are not known yet, or when nobody
  /// asks any longer.
  std::optional<Failure> note(const CheckedFile& checked);

  /// Those who speak are unknown again.
  void forget();

 private:
  struct Pending {
    Failure failure;
    std::set<std::string> unknown;  ///< hashes
  };
  std::map<AttemptId, Pending> pending_;
  std::vector<FileOrder> orders_;
};

}  // namespace tetfarm
