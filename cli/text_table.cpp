#include "cli/text_table.h"

#include <algorithm>

#include "base/check.h"
#include "base/printable_text.h"
#include "base/utf8.h"

namespace tetfarm {

std::string harmless(const std::string& text, std::size_t longest) {
  const std::string line = printable(text);
  return line.size() <= longest ? line : std::string(cut_utf8(line, longest)) + "…";
}

std::string table_text(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return {};
  std::vector<std::vector<std::string>> lines = {head};
  lines.insert(lines.end(), rows.begin(), rows.end());
  std::vector<std::size_t> widths(head.size(), 0);
  for (std::vector<std::string>& line : lines) {
    TF_CHECK(line.size() <= head.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      line[i] = harmless(line[i]);
      widths[i] = std::max(widths[i], line[i].size());
    }
  }
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      row += line[i];
      if (i + 1 < line.size()) row += std::string(widths[i] + 2 - line[i].size(), ' ');
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

}  // namespace tetfarm
