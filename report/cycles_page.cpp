#include "report/cycles_page.h"

#include "report/html_page.h"
#include "report/html_table.h"
#include "report/html_text.h"

namespace tetfarm {
namespace {

std::string pictures_of(const std::vector<ReportedCycle>& cycles,
                        ReportPicture ReportedCycle::*picture) {
  std::vector<ReportPicture> row;
  for (const ReportedCycle& cycle : cycles) row.push_back(cycle.*picture);
  return pictures_row(row);
}

std::string chart_of(const std::string& svg) {
  if (svg.empty()) return {};
  return "<h2>Along the walls</h2>\n<figure><img alt=\"The first field along the walls\" "
         "src=\"data:image/svg+xml;base64," +
         base64(svg) + "\"></figure>\n";
}

std::string words_of(const std::vector<ReportedCycle>& cycles) {
  std::vector<std::vector<std::string>> rows;
  for (const ReportedCycle& cycle : cycles) {
    if (!cycle.last_words.empty()) {
      rows.push_back({"cycle " + std::to_string(cycle.number) + ": " + cycle.last_words});
    }
  }
  if (rows.empty()) return {};
  return "<h2>What the solver said last</h2>\n<div class=\"scroll\">" + html_table({""}, rows) +
         "</div>\n";
}

std::string introduction(const CyclesContent& content) {
  std::string text = "<p>" + std::to_string(content.cycles) +
                     (content.cycles == 1 ? " cycle" : " cycles") + " of an adaptation loop";
  const auto shown = static_cast<std::int64_t>(content.shown.size());
  if (shown < content.cycles) text += ", of which " + std::to_string(shown) + " are shown";
  return text + ". All pictures show the same part of the plane, in the same colours.</p>\n";
}

}  // namespace

std::string cycles_page(const CyclesContent& content) {
  return html_page(content.name,
                   introduction(content) + "<h2>Meshes</h2>\n" +
                       pictures_of(content.shown, &ReportedCycle::mesh) + "<h2>Solutions</h2>\n" +
                       pictures_of(content.shown, &ReportedCycle::solution) +
                       chart_of(content.chart) + "<h2>Figures</h2>\n<div class=\"scroll\">" +
                       html_table(content.head, content.rows) + "</div>\n" +
                       words_of(content.shown));
}

}  // namespace tetfarm
