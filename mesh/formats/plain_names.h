/// Names of patches and regions for formats that do not take every name.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// Letters, digits, `_`, `-` and `.` stay, anything else becomes `_`; at most `most` bytes; those
/// that would be equal then, or equal to one of `taken`, get a number at their end.
std::vector<std::string> plain_names(const std::vector<std::string>& names, std::size_t most,
                                     const std::vector<std::string>& taken = {});

}  // namespace tetfarm
