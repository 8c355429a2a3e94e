#include "mesh/formats/count_limit.h"

#include "base/error.h"

namespace tetfarm {

void require_32_bits(std::int64_t count, const std::string& what, const std::string& format,
                     const std::string& instead) {
  if (count <= most_of_32_bits) return;
  throw Error(ExitCode::failed, "the mesh is too large for " + format +
                                    ", whose counts end at 2147483647: " + std::to_string(count) +
                                    " " + what + "; " + instead);
}

}  // namespace tetfarm
