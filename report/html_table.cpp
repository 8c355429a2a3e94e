#include "report/html_table.h"

#include "base/check.h"
#include "report/html_text.h"

namespace tetfarm {
namespace {

std::string row_of(const std::vector<std::string>& cells, const char* kind) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) {
    html += std::string("<") + kind + ">" + escaped(cell) + "</" + kind + ">";
  }
  return html + "</tr>\n";
}

}  // namespace

std::string html_table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<table>\n";
  if (!head.empty()) html += "<thead>" + row_of(head, "th") + "</thead>\n";
  html += "<tbody>\n";
  for (const auto& row : rows) {
    TF_CHECK(head.empty() || row.size() == head.size());
    html += row_of(row, "td");
  }
  return html + "</tbody></table>\n";
}

}  // namespace tetfarm
