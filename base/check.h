/// Assertions for the programmer's own mistakes. They stay on in release builds.
///
/// TF_CHECK never tests user input or the outside world: bad input throws InvalidInput, a failing
/// disk or network throws IoError (base/error.h). A worker's child that dies on a TF_CHECK loses
/// its attempt, and the coordinator hands the task out again.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace tetfarm {

[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: check failed: %s\n", file, line, condition);
  std::abort();
}

}  // namespace tetfarm

#define TF_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::tetfarm::check_failed(#condition, __FILE__, __LINE__))
