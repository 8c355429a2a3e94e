/// Rows of text under each other, for people.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// Columns as wide as their longest text, two spaces apart; the last one as it is. Bytes that would
/// command a terminal are replaced. Empty without rows.
std::string table_text(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows);

/// What a stranger wrote, harmless to a terminal and at most `longest` bytes long.
std::string harmless(const std::string& text, std::size_t longest = 160);

}  // namespace tetfarm
