/// System calls that a signal may end before they did anything.
#pragma once

#include <sys/types.h>

#include <cerrno>

namespace tetfarm {

/// Makes the call until no signal interrupts it, and returns what it returns.
template <class Call>
ssize_t retry_on_eintr(const Call& call) {
  ssize_t n = -1;
  do {
    n = call();
  } while (n < 0 && errno == EINTR);
  return n;
}

}  // namespace tetfarm
