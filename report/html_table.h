/// Tables of a page.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// Cells are text, and escaped. The first column is of words, the others of numbers.
std::string html_table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows);

}  // namespace tetfarm
