/// Rows of text under each other, for people.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// Columns as wide as their longest text, two spaces apart; the last one as it is. Each text is
/// made printable (base/printable_text.h). Empty without rows.
std::string table_text(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows);

/// What a stranger wrote, printable on one line, and cut to `longest` bytes.
std::string harmless(const std::string& text, std::size_t longest = 160);

}  // namespace tetfarm
