/// Grid Engine: qsub, qstat, qdel. Jobs are tasks of arrays: one submission makes many.
/// Source: the manual pages submit(1), qstat(1), qdel(1), sge_types(1) of Son of Grid Engine 8.1.9.
#pragma once

#include "pool/batch_system.h"

namespace tetfarm {

class GridEngine : public BatchSystem {
 public:
  explicit GridEngine(PoolSettings settings) : settings_(std::move(settings)) {}

  std::vector<ShellCommand> submit(const WorkerOrder& order,
                                   const std::vector<PoolJob>& jobs) const override;
  std::vector<std::string> submitted(const WorkerOrder& order,
                                     const CommandOutcome& outcome) const override;
  std::vector<ShellCommand> list() const override;
  std::optional<std::vector<PoolJob>> listed(const CommandOutcome& outcome) const override;
  std::vector<ShellCommand> cancel(const std::vector<std::string>& jobs) const override;

 private:
  PoolSettings settings_;
};

}  // namespace tetfarm
