/// Numbers of things, as one would say them.
#pragma once

#include <cstdint>
#include <string>

namespace tetfarm {

/// "1 worker", "3 workers". @pre the plural of `thing` has an s at its end.
inline std::string counted(std::uint64_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace tetfarm
