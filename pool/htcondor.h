/// HTCondor: condor_submit, condor_q, condor_rm.
/// Source: the manual of HTCondor 23 (condor_submit, job ClassAd attributes).
#pragma once

#include "pool/batch_system.h"

namespace tetfarm {

class HTCondor : public BatchSystem {
 public:
  explicit HTCondor(PoolSettings settings) : settings_(std::move(settings)) {}

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
