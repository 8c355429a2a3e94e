/// LSF: bsub, bjobs, bkill. Jobs are elements of arrays: one submission makes many.
/// Source: the command reference of IBM Spectrum LSF 10.1 (bsub, bjobs, bkill).
#pragma once

#include "pool/batch_system.h"

namespace tetfarm {

class Lsf : public BatchSystem {
 public:
  explicit Lsf(PoolSettings settings) : settings_(std::move(settings)) {}

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
