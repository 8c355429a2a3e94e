/// Plain hosts, without a batch system: workers are started over ssh, or on this machine, as
/// processes that outlive whoever started them. A file for each, in a folder of the user's under
/// /tmp of the host, tells its process; what that runs is checked before it is believed.
///
/// A host that does not answer counts as full: its workers may still be there.
#pragma once

#include "pool/batch_system.h"

namespace tetfarm {

class Hosts : public BatchSystem {
 public:
  /// Without hosts in `settings`: this machine, with `slots` of them. @throws UsageError for a host
  /// that is none.
  Hosts(PoolSettings settings, std::size_t slots);

  std::vector<ShellCommand> submit(const WorkerOrder& order,
                                   const std::vector<PoolJob>& jobs) const override;
  std::vector<std::string> submitted(const WorkerOrder& order,
                                     const CommandOutcome& outcome) const override;
  std::vector<ShellCommand> list() const override;
  std::optional<std::vector<PoolJob>> listed(const CommandOutcome& outcome) const override;
  std::vector<ShellCommand> cancel(const std::vector<std::string>& jobs) const override;

 private:
  struct Host {
    std::string name;
    std::size_t slots = 1;
    bool is_here = false;
  };
  std::string on(const Host& host, const std::string& script) const;

  PoolSettings settings_;
  std::vector<Host> hosts_;
};

}  // namespace tetfarm
