#include <cmath>
#include <cstdio>

#include "base/angle_text.h"
#include "mesh/core/element_block.h"
#include "report/html_table.h"
#include "report/html_text.h"
#include "report/report_page.h"
#include "report/svg_charts.h"

namespace tetfarm {
namespace {

constexpr const char* near_colour = "#d9822b";
constexpr const char* away_colour = "#3b7dbd";
constexpr const char* plain_colour = "#6a8f5f";

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

std::string count_text(std::int64_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, " ");
  return text;
}

std::string place_text(const Vec3& p) { return format("%.6g, %.6g, %.6g", p.x, p.y, p.z); }

bool has_cuts(const MeshFigures& figures) { return figures.near_cuts.shapes.tets > 0; }

/// The chart, and again with a logarithmic axis, which shows the few that are far out.
std::string two_charts(BarChart chart) {
  std::string html = "<div class=\"pair\">" + svg_of(chart);
  chart.is_logarithmic = true;
  chart.title += ", log";
  return html + svg_of(chart) + "</div>\n";
}

/// The same counts near the cuts and away from them, or of all where there are no cuts.
template <class CountsOf>
std::vector<BarChart::Series> side_by_side(const MeshFigures& figures, const CountsOf& counts_of) {
  if (!has_cuts(figures)) return {{"", plain_colour, shares(counts_of(figures.all))}};
  return {{"near the cuts", near_colour, shares(counts_of(figures.near_cuts))},
          {"away from them", away_colour, shares(counts_of(figures.away_from_cuts))}};
}

std::string dihedral_charts(const MeshFigures& figures) {
  BarChart chart{.title = "Dihedral angles, % of all",
                 .unit = "degrees, bins of 10",
                 .series = side_by_side(
                     figures, [](const TetFigures& of) { return of.shapes.dihedral_histogram; })};
  for (int i = 0; i < 18; ++i) chart.names.push_back(format("%d–%d", 10 * i, 10 * i + 10));
  return two_charts(std::move(chart));
}

std::string radius_ratio_charts(const MeshFigures& figures) {
  BarChart chart{
      .title = "Radius ratio, % of tets",
      .unit = "3 × inradius / circumradius; 1: regular",
      .series = side_by_side(figures, [](const TetFigures& of) { return of.radius_ratio.counts; })};
  const Histogram& bins = figures.all.radius_ratio;
  for (std::size_t i = 0; i < bins.counts.size(); ++i) {
    chart.names.push_back(format("%.2f", bins.end_of(i)));
  }
  return two_charts(std::move(chart));
}

std::string edge_charts(const EdgeFigures& edges) {
  if (edges.edges == 0) {
    return "<p class=\"note\">Edge lengths over the spacing are not shown: the spacing that the "
           "mesh was made with is not available.</p>\n";
  }
  BarChart chart{.title = "Edge length over spacing, % of edges",
                 .unit = format("%.3f to %.3f, mean %.3f; the last bin holds all that are longer",
                                edges.shortest, edges.longest, edges.mean()),
                 .series = {{"", plain_colour, shares(edges.over_spacing.counts)}}};
  for (std::size_t i = 0; i < edges.over_spacing.counts.size(); ++i) {
    chart.names.push_back(format("%.1f", edges.over_spacing.end_of(i)));
  }
  return two_charts(std::move(chart));
}

std::string volume_charts(const std::map<int, std::int64_t>& volumes) {
  if (volumes.empty()) return {};
  BarChart chart{.title = "Volume, % of tets", .unit = "lower end of bins of a factor of two"};
  std::vector<std::int64_t> counts;
  for (int power = volumes.begin()->first; power <= volumes.rbegin()->first; ++power) {
    const auto found = volumes.find(power);
    counts.push_back(found == volumes.end() ? 0 : found->second);
    chart.names.push_back(format("%.1e", std::ldexp(1.0, power)));
  }
  chart.series = {{"", plain_colour, shares(counts)}};
  return two_charts(std::move(chart));
}

std::string facts(const MeshFigures& figures) {
  const ShapeStatistics& shapes = figures.all.shapes;
  std::vector<std::vector<std::string>> rows = {
      {"tetrahedra", count_text(figures.tets)},
      {"nodes", count_text(figures.nodes)},
      {"boundary triangles", count_text(figures.boundary_triangles)},
      {"volume", format("%.10g", figures.volume)}};
  if (figures.tets > 0) {
    rows.push_back({"dihedral angles", angle_text(shapes.min_dihedral_deg) + "° to " +
                                           angle_text(shapes.max_dihedral_deg) + "°"});
    rows.push_back({"mean radius ratio", format("%.4f", shapes.mean_radius_ratio())});
    rows.push_back({"smallest height", format("%.6g", shapes.smallest_height)});
  }
  for (const ElementType type : cell_block_types) {
    const CellFigures& cells = figures.others[type];
    if (cells.cells == 0) continue;
    rows.insert(rows.begin() + 1, {std::string(element(type).plural), count_text(cells.cells)});
    rows.push_back({"scaled Jacobian of " + std::string(element(type).plural),
                    format("%.4f mean, %.4f smallest", cells.mean_scaled_jacobian(),
                           cells.least_scaled_jacobian)});
  }
  if (figures.boundary_quads > 0) {
    rows.push_back({"boundary quads", count_text(figures.boundary_quads)});
  }
  if (figures.knows_subdomains) {
    rows.insert(rows.begin() + 3, {"sub-domains", count_text(std::ssize(figures.subdomains))});
  }
  return html_table({}, rows);
}

std::string decomposition(const std::vector<ReportPicture>& pictures) {
  return pictures.empty() ? "" : "<h2>Decomposition</h2>\n" + pictures_row(pictures);
}

std::string near_and_away(const MeshFigures& figures) {
  if (!has_cuts(figures)) return {};
  const auto row = [&](const char* name, const char* pattern, const auto& value_of) {
    return std::vector<std::string>{name, format(pattern, value_of(figures.near_cuts)),
                                    format(pattern, value_of(figures.away_from_cuts)),
                                    format(pattern, value_of(figures.all))};
  };
  const auto angles = [&](const char* name, const auto& value_of) {
    const auto text = [&](const TetFigures& of) { return angle_text(value_of(of)) + "°"; };
    return std::vector<std::string>{name, text(figures.near_cuts), text(figures.away_from_cuts),
                                    text(figures.all)};
  };
  return "<h3>Near the cuts and away from them</h3>\n" +
         html_table({"", "near", "away", "all"},
                    {{"tetrahedra", count_text(figures.near_cuts.shapes.tets),
                      count_text(figures.away_from_cuts.shapes.tets), count_text(figures.tets)},
                     angles("smallest dihedral angle",
                            [](const TetFigures& of) { return of.shapes.min_dihedral_deg; }),
                     angles("largest dihedral angle",
                            [](const TetFigures& of) { return of.shapes.max_dihedral_deg; }),
                     row("mean radius ratio", "%.4f",
                         [](const TetFigures& of) { return of.shapes.mean_radius_ratio(); }),
                     row("smallest height = time step × wave speed", "%.6g",
                         [](const TetFigures& of) { return of.shapes.smallest_height; })}) +
         "<p class=\"note\">Near: within three layers of tetrahedra of a node on a cut.</p>\n";
}

std::string time_step(const MeshFigures& figures) {
  std::string html =
      "<p>An explicit solver's time step is limited by the smallest height divided by the wave "
      "speed c: <b>" +
      format("%.6g", figures.time_step()) + "</b> / c here, at (" +
      place_text(figures.all.lowest_at) + ").";
  if (has_cuts(figures)) {
    html += format(
        " That is %.2f times the number of steps that the mesh away from the cuts alone "
        "would need.",
        figures.steps_beside_away());
  }
  return html + "</p>\n";
}

std::string worst(const MeshFigures& figures) {
  std::vector<std::vector<std::string>> rows;
  for (const WorstTet& tet : figures.worst) {
    rows.push_back({angle_text(tet.min_dihedral_deg, 3) + "°",
                    angle_text(tet.max_dihedral_deg, 3) + "°", format("%.4f", tet.radius_ratio),
                    format("%.4g", tet.height), std::to_string(tet.subdomain),
                    tet.is_near_cut ? "yes" : "no", place_text(tet.centroid), count_text(tet.tet)});
  }
  return format("<h2>The worst %zu tetrahedra</h2>\n<div class=\"scroll\">", rows.size()) +
         html_table({"smallest angle", "largest", "radius ratio", "height", "sub-domain",
                     "near a cut", "centre at", "number"},
                    rows) +
         "</div>\n";
}

std::string balance(const ReportContent& content) {
  const MeshFigures& figures = content.figures;
  if (!figures.knows_subdomains || figures.subdomains.size() < 2) return {};
  BarChart chart{
      .title = "Elements of each sub-domain", .unit = "sub-domains in tree order", .is_wide = true};
  std::vector<double> made;
  for (const SubdomainFigures& subdomain : figures.subdomains) {
    chart.names.push_back(std::to_string(made.size()));
    made.push_back(static_cast<double>(subdomain.cells));
  }
  std::vector<double> estimated;
  if (content.work) estimated = estimated_elements_of_leaves(*content.work);
  if (estimated.size() == made.size()) {
    chart.series.push_back({"estimated beforehand", "#b9b9b9", std::move(estimated)});
  }
  chart.series.push_back({"made", away_colour, std::move(made)});
  return "<h2>Balance</h2>\n<p>The largest sub-domain has " +
         format("%.3f", figures.largest_over_mean()) + " times the mean number of elements.</p>\n" +
         svg_of(chart) + "\n";
}

}  // namespace

std::string mesh_sections(const ReportContent& content) {
  const MeshFigures& figures = content.figures;
  const std::string html = facts(figures) + decomposition(content.pictures) +
                           (content.layers ? layers_section(*content.layers) : "");
  if (figures.tets == 0) return html + edge_charts(figures.edges) + balance(content);
  return html + "<h2>Quality</h2>\n" + dihedral_charts(figures) + radius_ratio_charts(figures) +
         near_and_away(figures) + time_step(figures) + edge_charts(figures.edges) +
         volume_charts(figures.volumes) + worst(figures) + balance(content);
}

}  // namespace tetfarm
