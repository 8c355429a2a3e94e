#include "cli/adapted_report.h"

#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/hash.h"
#include "json/json_line.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/metric_quality.h"

namespace tetfarm {
namespace {

/// Of coordinates, triangles, edges and their numbers, in their order.
Hash128 digest_of(const PlaneMesh& mesh) {
  Hasher hasher;
  const auto add = [&](const auto& list) {
    const std::uint64_t count = list.size();
    hasher.add(&count, sizeof count);
    hasher.add(list.data(), list.size() * sizeof list[0]);
  };
  add(mesh.points);
  add(mesh.triangles);
  add(mesh.regions);
  add(mesh.edges);
  add(mesh.patches);
  return hasher.finish();
}

/// What became of the nodes of each curve.
nlohmann::ordered_json curves_json(const CurvesOfMesh& curved) {
  nlohmann::ordered_json curves = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < curved.curves.size(); ++k) {
    const MovedNodes& moved = curved.moved[k];
    curves.push_back({{"patches", curved.curves[k].patches},
                      {"curve", curved.texts[k]},
                      {"nodes", moved.nodes},
                      {"moved", moved.moved},
                      {"farthest_move", moved.farthest}});
    if (moved.node < 0) continue;
    const Vec2& place = curved.mesh.points[static_cast<std::size_t>(moved.node)];
    curves.back()["farthest_at"] = {place.x, place.y};
  }
  return curves;
}

/// The lines in the file of the sources that ask nowhere for more than the background does.
std::vector<int> lines_without_effect(const PlaneSources& sources,
                                      const std::vector<std::uint8_t>& act) {
  TF_CHECK(act.size() == sources.sources.size());
  std::vector<int> lines;
  for (std::size_t k = 0; k < act.size(); ++k) {
    if (act[k] == 0) lines.push_back(sources.sources[k].line);
  }
  return lines;
}

void print_sources(const AdaptedTelling& telling, const AdaptedMesh& adapted) {
  if (telling.sources == nullptr) return;
  const std::vector<int> lines = lines_without_effect(*telling.sources, adapted.asked.sources_act);
  for (const int line : lines) {
    std::printf("%s:%d: this source has no effect: the mesh is as fine without it\n",
                telling.sources_file.c_str(), line);
  }
}

nlohmann::ordered_json adapted_result_json(const AdaptedTelling& telling,
                                           const AdaptedMesh& adapted, const MetricQuality& quality,
                                           double seconds) {
  const ScaledMetric& asked = adapted.asked;
  nlohmann::ordered_json result = {{"type", telling.command},
                                   {"file", telling.output},
                                   {"vertices", adapted.result.mesh.points.size()},
                                   {"triangles", adapted.result.mesh.triangles.size()},
                                   {"unit_edges_percent", quality.unit_edges_percent},
                                   {"edge_length_min", quality.edge_length_min},
                                   {"edge_length_max", quality.edge_length_max},
                                   {"longest_at", {quality.longest_at.x, quality.longest_at.y}},
                                   {"quality_min", quality.quality_min},
                                   {"quality_1percent", quality.quality_1percent},
                                   {"quality_mean", quality.quality_mean},
                                   {"worst_at", {quality.worst_at.x, quality.worst_at.y}},
                                   {"max_angle_deg", quality.max_angle_deg},
                                   {"complexity", asked.complexity},
                                   {"limited",
                                    {{"h_min", asked.at_h_min},
                                     {"h_max", asked.at_h_max},
                                     {"aspect", asked.at_aspect},
                                     {"gradation", asked.by_gradation}}},
                                   {"seconds", seconds},
                                   {"digest", digest_of(adapted.result.mesh).hex()}};
  if (adapted.result.mean_length_before > 0) {
    result["mean_length_before"] = adapted.result.mean_length_before;
    result["mean_length_after"] = adapted.result.mean_length_after;
  }
  if (telling.sources != nullptr) {
    result["sources"] = telling.sources->sources.size();
    result["sources_without_effect"] = lines_without_effect(*telling.sources, asked.sources_act);
  }
  if (!telling.curved->curves.empty()) result["curves"] = curves_json(*telling.curved);
  return result;
}

void print_curves(const CurvesOfMesh& curved) {
  for (std::size_t k = 0; k < curved.curves.size(); ++k) {
    const MovedNodes& moved = curved.moved[k];
    std::printf("%s: %s; ", curved.curves[k].name.c_str(), curved.texts[k].c_str());
    if (moved.node < 0) {
      std::printf("all %lld nodes lay on it\n", static_cast<long long>(moved.nodes));
      continue;
    }
    const Vec2& place = curved.mesh.points[static_cast<std::size_t>(moved.node)];
    std::printf("%lld of %lld nodes moved there, the farthest by %.3g (to %.6g, %.6g)\n",
                static_cast<long long>(moved.moved), static_cast<long long>(moved.nodes),
                moved.farthest, place.x, place.y);
  }
}

void print_result(const AdaptedTelling& telling, const AdaptedMesh& adapted,
                  const MetricQuality& quality, double seconds) {
  std::printf("%s: %zu vertices, %zu triangles, %.2f s\n", telling.output.c_str(),
              adapted.result.mesh.points.size(), adapted.result.mesh.triangles.size(), seconds);
  std::printf("unit edges      %.2f %%, lengths %.3f to %.3f (longest at %.6g, %.6g)\n",
              quality.unit_edges_percent, quality.edge_length_min, quality.edge_length_max,
              quality.longest_at.x, quality.longest_at.y);
  std::printf("quality         %.3f worst (at %.6g, %.6g), %.3f at 1 %%, %.3f mean\n",
              quality.quality_min, quality.worst_at.x, quality.worst_at.y, quality.quality_1percent,
              quality.quality_mean);
  std::printf("largest angle   %.2f degrees\n", quality.max_angle_deg);
  if (adapted.result.mean_length_before > 0) {
    std::printf("mean edge       %.4g before (the unit of the lengths above), %.4g after\n",
                adapted.result.mean_length_before, adapted.result.mean_length_after);
  }
  const ScaledMetric& asked = adapted.asked;
  const auto tell = [](const char* option, std::int64_t nodes) {
    if (nodes > 0) std::printf("%-16sheld at %lld nodes\n", option, static_cast<long long>(nodes));
  };
  tell("--h-min", asked.at_h_min);
  tell("--h-max", asked.at_h_max);
  tell("--aspect", asked.at_aspect);
  tell("--gradation", asked.by_gradation);
  print_sources(telling, adapted);
  print_curves(*telling.curved);
}

}  // namespace

void tell_adapted(const AdaptedTelling& telling, const AdaptedMesh& adapted) {
  TF_CHECK(telling.curved != nullptr);
  const double seconds = static_cast<double>(steady_ms() - telling.start_ms) / 1000;
  const MetricQuality quality =
      metric_quality(checked_complex(adapted.result.mesh), adapted.result.metrics);
  if (telling.json) {
    std::printf("%s\n", json_line(adapted_result_json(telling, adapted, quality, seconds)).c_str());
  } else {
    print_result(telling, adapted, quality, seconds);
  }
}

void check_that_sources_act(const AdaptedTelling& telling, const AdaptedMesh& adapted) {
  if (telling.sources == nullptr) return;
  const std::vector<std::uint8_t>& act = adapted.asked.sources_act;
  if (lines_without_effect(*telling.sources, act).size() < act.size()) return;
  throw InvalidInput(
      "no source has any effect: none is near the domain, or the mesh is as fine without them",
      telling.sources_file);
}

double gradation_of(const std::string& text, double otherwise) {
  if (text.empty()) return otherwise;
  double value = 0;  // stays where the text is "off"
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace tetfarm
