#include "base/thread_without_signals.h"

#include <csignal>
#include <utility>

namespace tetfarm {

std::thread thread_without_signals(std::function<void()> work) {
  // A new thread has its parent's mask.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(work));
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace tetfarm
