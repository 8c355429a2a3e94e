/// The signals that ask a worker to drain, as a file descriptor.
#pragma once

namespace tetfarm {

class DrainSignals {
 public:
  /// Blocks SIGTERM, SIGINT, SIGHUP, SIGUSR1 and SIGUSR2 in this thread when `wanted`.
  explicit DrainSignals(bool wanted);
  ~DrainSignals();
  DrainSignals(const DrainSignals&) = delete;
  DrainSignals& operator=(const DrainSignals&) = delete;

  /// Whether one has come since the last call.
  bool take_one() const;
  /// To wait for; -1 when they are not wanted.
  int fd() const { return fd_; }

 private:
  int fd_ = -1;
};

}  // namespace tetfarm
