/// Which tasks crash on which hosts, and when that speaks against a host.
///
/// A task is not to blame for a bad host, nor a host for bad tasks: only a task that crashed on one
/// host and was then done on another tells which of the two it was. Enough different tasks are
/// proof, of more than one job: nobody takes a host out of the farm with a job made for it.
/// Invariants, checked by validate():
///  1. A host is listed only with tasks that crashed there, each at least once.
/// Cost: O(hosts on which tasks crashed), or of the tasks of one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

class HostCrashes {
 public:
  using IsAtHand = std::function<bool(TaskId)>;

  /// The task crashed there. Tasks that are not at hand any more, and prove nothing, are forgotten.
  void note_crash(const std::string& host, const TaskRow& task, const std::string& message,
                  const IsAtHand& is_at_hand);
  /// The task is done there: nothing that crashed on the host speaks against it any more. If the
  /// task crashed on one other host, it speaks against that one, which comes back.
  std::optional<std::string> note_done(const std::string& host, TaskId task);
  /// The host starts anew.
  void forget(const std::string& host) { host2crashes_.erase(host); }

  bool crashed_on(const std::string& host, TaskId task) const;
  std::size_t hosts_where_it_crashed(TaskId task) const;

  struct Proof {
    std::string reason;
    std::map<TaskId, std::uint32_t> crashes;  ///< that were the host's fault
  };
  /// What speaks against the host, when at least `least_tasks` tasks do, of two jobs or more.
  std::optional<Proof> proof_against(const std::string& host, std::size_t least_tasks) const;

  /// The broken invariants, in words; empty when all is well.
  std::vector<std::string> validate() const;

 private:
  struct CrashesOfTask {
    JobId job;
    std::uint32_t count = 0;
    bool was_done_elsewhere = false;  ///< and crashed nowhere else
  };
  /// Since a task was last done there.
  struct Crashes {
    std::map<TaskId, CrashesOfTask> tasks;
    std::string last_message;
  };
  std::map<std::string, Crashes> host2crashes_;
};

}  // namespace tetfarm
