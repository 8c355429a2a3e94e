#include <cstdio>

#include "report/html_table.h"
#include "report/html_text.h"
#include "report/report_page.h"
#include "report/svg_charts.h"

namespace tetfarm {
namespace {

constexpr const char* colour_of_layers = "#d9902b";

std::string share_text(std::int64_t count, std::int64_t all) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f %%",
                100 * static_cast<double>(count) / static_cast<double>(all));
  return text;
}

std::string coverage(const ReportedLayers& layers, std::int64_t wall) {
  std::vector<std::vector<std::string>> rows = {
      {"all layers", std::to_string(layers.full), share_text(layers.full, wall)}};
  for (const auto& [reason, count] : layers.by_reason) {
    rows.push_back({"fewer: " + reason, std::to_string(count), share_text(count, wall)});
  }
  return html_table({"", "triangles of the wall", "share"}, rows);
}

std::string layers_chart(const ReportedLayers& layers) {
  BarChart chart{.title = "Layers, % of the triangles of the wall",
                 .unit = "layers all over the triangle",
                 .series = {{"", colour_of_layers, shares(layers.by_layers)}}};
  for (std::size_t i = 0; i < layers.by_layers.size(); ++i)
    chart.names.push_back(std::to_string(i));
  return svg_of(chart);
}

std::string first_heights_chart(const Histogram& heights) {
  BarChart chart{.title = "First height over what was asked for, % of triangles",
                 .unit = "1: as asked; the first and the last hold all beyond them",
                 .series = {{"", colour_of_layers, shares(heights.counts)}},
                 .is_logarithmic = true};
  for (std::size_t i = 0; i < heights.counts.size(); ++i) {
    char text[16];
    std::snprintf(text, sizeof text, "%.3f", (heights.end_of(i) + heights.end_of(i + 1)) / 2);
    chart.names.emplace_back(text);
  }
  return svg_of(chart);
}

}  // namespace

std::string pictures_row(const std::vector<ReportPicture>& pictures) {
  std::string html = "<div class=\"pair\">\n";
  for (const ReportPicture& picture : pictures) {
    const std::string caption = escaped(picture.caption);
    html += "<figure><img src=\"" + png_address(picture.png) + "\" alt=\"" + caption +
            "\"><figcaption>" + caption + "</figcaption></figure>\n";
  }
  return html + "</div>\n";
}

std::string layers_section(const ReportedLayers& layers) {
  std::int64_t wall = layers.full;
  for (const auto& [reason, count] : layers.by_reason) wall += count;
  if (wall == 0) return {};
  std::string html = "<h2>Boundary layers</h2>\n" + coverage(layers, wall);
  if (!layers.shapes.empty()) html += html_table({}, layers.shapes);
  html += "<div class=\"pair\">" + layers_chart(layers) +
          first_heights_chart(layers.first_heights) + "</div>\n";
  return html + (layers.pictures.empty() ? "" : pictures_row(layers.pictures));
}

}  // namespace tetfarm
