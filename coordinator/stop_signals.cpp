#include "coordinator/stop_signals.h"

#include <atomic>

namespace tetfarm {
namespace {

std::atomic<bool> stop_signal{false};
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

StopSignals::StopSignals(bool wanted) : wanted_(wanted) {
  if (!wanted_) return;
  stop_signal = false;
  struct sigaction action {};
  action.sa_handler = [](int) { stop_signal = true; };
  sigemptyset(&action.sa_mask);
  sigaction(SIGTERM, &action, old_.data());
  sigaction(SIGINT, &action, &old_[1]);
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, &old_[2]);
}

StopSignals::~StopSignals() {
  if (!wanted_) return;
  sigaction(SIGTERM, old_.data(), nullptr);
  sigaction(SIGINT, &old_[1], nullptr);
  sigaction(SIGXFSZ, &old_[2], nullptr);
}

bool StopSignals::stopped() const { return wanted_ && stop_signal; }

}  // namespace tetfarm
