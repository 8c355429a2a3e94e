/// Numbers of things, as one would say them.
#pragma once

#include <cstdint>
#include <string>

namespace tetfarm {

/// "1 worker", "3 workers". @param plural as far as it is not `thing` with an s at its end.
inline std::string counted(std::uint64_t count, const std::string& thing,
                           const std::string& plural = "") {
  const std::string things = plural.empty() ? thing + "s" : plural;
  return std::to_string(count) + " " + (count == 1 ? thing : things);
}

}  // namespace tetfarm
