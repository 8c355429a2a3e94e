#include "cli/layers_report.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

LayerFigures wing() {
  return {.patches = {"upper", "lower"},
          .triangles = 8,
          .median_edge = 0.05,
          .layers = 20,
          .first_height = 1e-4,
          .last_height = 0.0031948,
          .total_height = 0.0186688,
          .isotropic_layer = 34};
}

TEST(LayersReport, tells_people_in_a_line) {
  EXPECT_EQ(layers_text(wing()),
            "\"upper\", \"lower\": 20 layers, 0.0001 to 0.003195 high, 0.01867 together; median "
            "edge 0.05, isotropic from layer 34");
  LayerFigures flat = wing();
  flat.layers = 1;
  flat.isotropic_layer = 0;
  EXPECT_EQ(layers_text(flat),
            "\"upper\", \"lower\": 1 layer, 0.0001 to 0.003195 high, 0.01867 together; median edge "
            "0.05, never isotropic");
  flat.in_tets = true;
  EXPECT_EQ(layers_text(flat),
            "\"upper\", \"lower\": 1 layer, 0.0001 to 0.003195 high, 0.01867 together, in tets; "
            "median edge 0.05, never isotropic");
  EXPECT_EQ(layers_json(std::vector{flat}).at(0).at("elements"), "tets");
  flat.triangles = 0;
  EXPECT_EQ(layers_text(flat), "\"upper\", \"lower\": no triangles");
}

TEST(LayersReport, tells_programs_all_figures) {
  EXPECT_EQ(layers_json(std::vector{wing()}).dump(),
            R"([{"patches":["upper","lower"],"triangles":8,"median_edge":0.05,"layers":20,)"
            R"("first_height":0.0001,"last_height":0.0031948,"total_height":0.0186688,)"
            R"("isotropic_layer":34,"elements":"prisms"}])");
}

}  // namespace
}  // namespace tetfarm
