/// The signals that end a coordinator, and the one that must not.
#pragma once

#include <array>
#include <csignal>

namespace tetfarm {

/// While it lives, SIGTERM and SIGINT are only noted, and a limit on the size of files (SIGXFSZ)
/// makes writes fail instead of ending the process. One at a time in a process.
class StopSignals {
 public:
  /// Does nothing, and notes nothing, unless `wanted`.
  explicit StopSignals(bool wanted);
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether one has come.
  bool stopped() const;

 private:
  bool wanted_;
  std::array<struct sigaction, 3> old_{};
};

}  // namespace tetfarm
