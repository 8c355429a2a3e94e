#include "worker/drain_signals.h"

#include <sys/signalfd.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace tetfarm {

DrainSignals::DrainSignals(bool wanted) {
  if (!wanted) return;
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGUSR2}) ::sigaddset(&set, signal);
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
  fd_ = ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
}

DrainSignals::~DrainSignals() {
  if (fd_ >= 0) ::close(fd_);
}

bool DrainSignals::take_one() const {
  signalfd_siginfo info{};
  return fd_ >= 0 && ::read(fd_, &info, sizeof info) == sizeof info;
}

}  // namespace tetfarm
