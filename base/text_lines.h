/// The lines of a text.
#pragma once

#include <string_view>
#include <vector>

namespace tetfarm {

/// Without their ends; the last need not have one. Views into the text. Cost: O(length).
std::vector<std::string_view> lines_of_text(std::string_view text);

}  // namespace tetfarm
