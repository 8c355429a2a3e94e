#include "worker/cycle_figures.h"

#include <array>
#include <charconv>

namespace tetfarm {
namespace {

std::string number_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::general, 6)
                           .ptr};
}

std::string counts_of(const PlaneMesh& mesh) {
  return std::to_string(mesh.points.size()) + "," + std::to_string(mesh.triangles.size());
}

}  // namespace

std::string cycle_figures_head() {
  return "cycle,vertices,triangles,unit_edges_percent,edge_length_min,edge_length_max,quality_min,"
         "quality_mean,max_angle_deg,integral_gain\n";
}

std::string cycle_figures(const PlaneMesh& mesh) { return counts_of(mesh) + ",,,,,,,"; }

std::string cycle_figures(const PlaneMesh& mesh, const MetricQuality& quality, double gain) {
  std::string row = counts_of(mesh);
  for (const double value :
       {quality.unit_edges_percent, quality.edge_length_min, quality.edge_length_max,
        quality.quality_min, quality.quality_mean, quality.max_angle_deg, gain}) {
    row += "," + number_text(value);
  }
  return row;
}

}  // namespace tetfarm
