// libFuzzer's way into a target: TETFARM_FUZZ_TARGET names it.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tetfarm::fuzz::TETFARM_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
