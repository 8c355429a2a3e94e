#include "cli/layers_report.h"

#include <array>
#include <cstdio>

#include "base/counted.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

std::string four_digits(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

}  // namespace

std::string layers_text(const LayerFigures& figures) {
  const std::string patches = patches_text(figures.patches);
  if (figures.triangles == 0) return patches + ": no triangles";
  const std::string isotropic =
      figures.isotropic_layer == 0
          ? "never isotropic"
          : "isotropic from layer " + std::to_string(figures.isotropic_layer);
  return patches + ": " + counted(static_cast<std::uint64_t>(figures.layers), "layer") + ", " +
         four_digits(figures.first_height) + " to " + four_digits(figures.last_height) + " high, " +
         four_digits(figures.total_height) + " together" + (figures.in_tets ? ", in tets" : "") +
         "; median edge " + four_digits(figures.median_edge) + ", " + isotropic;
}

nlohmann::ordered_json layers_json(std::span<const LayerFigures> all) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const LayerFigures& figures : all) {
    json.push_back({{"patches", figures.patches},
                    {"triangles", figures.triangles},
                    {"median_edge", figures.median_edge},
                    {"layers", figures.layers},
                    {"first_height", figures.first_height},
                    {"last_height", figures.last_height},
                    {"total_height", figures.total_height},
                    {"isotropic_layer", figures.isotropic_layer},
                    {"elements", figures.in_tets ? "tets" : "prisms"}});
  }
  return json;
}

std::string pml_text(const PmlFigures& figures) {
  const auto of = [](std::int64_t number, const char* what) {
    return counted(static_cast<std::uint64_t>(number), what);
  };
  return patches_text(figures.patches) + ": " + of(figures.layers, "layer") + ", " +
         four_digits(figures.height) + " high, " + four_digits(figures.thickness) + " together; " +
         of(figures.triangles, "triangle") + ", " +
         (figures.tets > 0 ? of(figures.tets, "tet") : of(figures.prisms, "prism"));
}

nlohmann::ordered_json pml_json(const PmlFigures& figures) {
  return {{"patches", figures.patches}, {"layers", figures.layers},
          {"height", figures.height},   {"thickness", figures.thickness},
          {"cells", figures.cells()},   {"tets", figures.tets},
          {"prisms", figures.prisms},   {"outer_triangles", figures.triangles}};
}

}  // namespace tetfarm
