// What `quality` says of meshes, called as main calls it.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

class QualityOf : public ::testing::Test {
 protected:
  std::string write(const MeshSource& mesh, const std::string& name = "mesh.vtkhdf") const {
    const std::filesystem::path file = folder_.path() / name;
    export_mesh(mesh, find_mesh_format("", file), file);
    return file.string();
  }
  Said quality(const std::string& input, bool as_json = false) const {
    QualityOptions options;
    options.input = input;
    options.json = as_json;
    return said_by([&] { return quality_command(options); });
  }

  const TempFolder folder_;
};

/// Without the digest, which other tests are about.
std::string without_digest(std::string text) {
  const std::string before = "\ndigest          ";
  const std::size_t at = text.find(before);
  if (at != std::string::npos) text.erase(at, before.size() + 32);
  return text;
}

/// The lines of a histogram of angles, of which these shares in percent lie in these bins.
std::string angle_lines(const std::map<int, std::pair<std::string, std::size_t>>& bins) {
  std::string lines = "dihedral angles\n";
  for (int bin = 0; bin < 18; ++bin) {
    const auto number = [](int degrees) { return std::to_string(degrees); };
    const auto found = bins.find(bin);
    const auto [share, length] =
        found == bins.end() ? std::pair(std::string(" 0.0000"), std::size_t{0}) : found->second;
    lines += std::string(bin == 0   ? "    "
                         : bin < 10 ? "   "
                                    : "  ") +
             number(10 * bin) + "-" + (bin < 9 ? " " : "") + number(10 * bin + 10) + "  " + share +
             " % " + std::string(length, '#') + "\n";
  }
  return lines;
}

/// The same near the cuts, and nothing away from them.
std::string angle_lines_near_cuts(const std::map<int, std::string>& bins) {
  std::string lines;
  for (int bin = 0; bin < 18; ++bin) {
    const auto found = bins.find(bin);
    char line[80];
    std::snprintf(line, sizeof line, "  %3d-%3d       %14s %%        0.0000 %%\n", 10 * bin,
                  10 * bin + 10, found == bins.end() ? "0.0000" : found->second.c_str());
    lines += line;
  }
  return lines;
}

TEST_F(QualityOf, a_grid_of_tets_is_told_in_full) {
  const Said said = quality(write(GridSource(cut_grid(2))));
  EXPECT_EQ(said.code, ExitCode::ok);
  // Of each tet two angles are of 45 degrees, one of 60 and three of 90.
  EXPECT_THAT(
      without_digest(said.out),
      StartsWith("tets            48\nnodes           27\nboundary        48 triangles\n"
                 "sub-domains     3\nvolume          1, enclosed 1\n"
                 "dihedral        45.000 to 90.000 deg; worst at (0.375, 0.25, 0.125)\n"
                 "radius ratio    0.7174 mean, 0.7174 smallest\nsmallest height 0.353553\n" +
                 angle_lines({{4, {"33.3333", 33}}, {6, {"16.6667", 16}}, {9, {"50.0000", 50}}}) +
                 "                       near cuts       elsewhere\n"
                 "tets                          48               0\n"
                 "min dihedral                  45             180\n"
                 "max dihedral                  90               0\n"
                 "smallest height         0.353553               0\n"
                 "radius ratio            0.717439               0\n" +
                 angle_lines_near_cuts({{4, "33.3333"}, {6, "16.6667"}, {9, "50.0000"}}) +
                 "time step       0.353553 / wave speed, limited by the height at (0.375, 0.25, "
                 "0.125)\nradius ratio\n  0.70-0.75           100.0000 % "));
}

TEST_F(QualityOf, a_grid_of_tets_is_told_to_programs) {
  const std::string file = write(GridSource(cut_grid(2)));
  const Json json = Json::parse(quality(file, true).out);
  EXPECT_EQ(json["type"], "quality");
  EXPECT_EQ(json["file"], file);
  EXPECT_EQ(json["valid"], true);
  EXPECT_EQ(json["nodes"], 27);
  EXPECT_EQ(json["boundary_triangles"], 48);
  EXPECT_EQ(json["subdomains"], 3);
  EXPECT_NEAR(json["volume"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(json["enclosed_volume"].get<double>(), 1, 1e-12);
  EXPECT_EQ(json["digest"].get<std::string>().size(), 32U);
  EXPECT_NEAR(json["forced_dihedral_deg"].get<double>(), 45, 1e-9);
  EXPECT_EQ(json["forced_at"], Json({0.25, 0.0, 1.0}));
  EXPECT_TRUE(json["complaints"].empty());
  EXPECT_NEAR(json["time_step"].get<double>(), std::sqrt(0.125), 1e-12);
  const auto expect_shapes = [](const Json& shapes) {
    EXPECT_EQ(shapes["elements"], 48);
    EXPECT_NEAR(shapes["min_dihedral_deg"].get<double>(), 45, 1e-9);
    EXPECT_NEAR(shapes["max_dihedral_deg"].get<double>(), 90, 1e-9);
    EXPECT_NEAR(shapes["mean_radius_ratio"].get<double>(), 0.717439, 1e-6);
    EXPECT_NEAR(shapes["min_radius_ratio"].get<double>(), 0.717439, 1e-6);
    EXPECT_NEAR(shapes["smallest_height"].get<double>(), std::sqrt(0.125), 1e-12);
    EXPECT_EQ(shapes["worst_at"], Json({0.375, 0.25, 0.125}));
    EXPECT_EQ(shapes["dihedral_histogram"],
              Json({0, 0, 0, 0, 96, 0, 48, 0, 0, 144, 0, 0, 0, 0, 0, 0, 0, 0}));
  };
  expect_shapes(json);
  expect_shapes(json["near_cuts"]);
  EXPECT_EQ(json["away_from_cuts"]["elements"], 0);
  ASSERT_EQ(json["regions"].size(), 1U);
  EXPECT_EQ(json["regions"][0]["number"], 1);
  EXPECT_EQ(json["regions"][0]["name"], "domain");
  EXPECT_NEAR(json["regions"][0]["volume"].get<double>(), 1, 1e-12);
  expect_shapes(json["regions"][0]["shapes"]);
}

TEST_F(QualityOf, a_mesh_of_all_cells_tells_of_each_type) {
  const std::string file = write(HybridGrid(3, 2));
  EXPECT_THAT(
      quality(file).out,
      StartsWith(
          "tets            16\nnodes           76\nboundary        12 triangles\n"
          "pyramids        64, volume 10.6666666667, scaled Jacobian 0.8165 mean, 0.8165 smallest\n"
          "prisms          10, volume 5, scaled Jacobian 0.8165 mean, 0.8165 smallest\n"
          "hexes           10, volume 10, scaled Jacobian 1.0000 mean, 1.0000 smallest\n"
          "boundary        48 quads\nsub-domains     2\nvolume          27, enclosed 27\n"));
  const Json json = Json::parse(quality(file, true).out);
  EXPECT_EQ(json["boundary_quads"], 48);
  EXPECT_EQ(json["hexes"]["count"], 10);
  EXPECT_NEAR(json["pyramids"]["volume"].get<double>(), 32.0 / 3, 1e-9);
  EXPECT_NEAR(json["prisms"]["least_scaled_jacobian"].get<double>(), 0.8165, 1e-4);
  EXPECT_NEAR(json["prisms"]["mean_scaled_jacobian"].get<double>(), 0.8165, 1e-4);
}

TEST_F(QualityOf, a_mesh_of_regions_tells_of_each) {
  const std::string file = write(HybridGrid(3, 2, true));
  const Json json = Json::parse(quality(file, true).out);
  ASSERT_EQ(json["regions"].size(), 2U);
  EXPECT_EQ(json["regions"][0]["name"], "domain");
  EXPECT_NEAR(json["regions"][0]["volume"].get<double>(), 18, 1e-9);
  EXPECT_EQ(json["regions"][1]["number"], 2);
  EXPECT_EQ(json["regions"][1]["name"], "domain 2");
  EXPECT_NEAR(json["regions"][1]["volume"].get<double>(), 9, 1e-9);
  const std::string text = quality(file).out;
  char line[100];
  const Json& shapes = json["regions"][1]["shapes"];
  std::snprintf(line, sizeof line, "domain 2        %16lld%16.6g%16.6g%16.6g\n",
                shapes["elements"].get<long long>(), 9.0, shapes["min_dihedral_deg"].get<double>(),
                shapes["mean_radius_ratio"].get<double>());
  EXPECT_THAT(text, HasSubstr("\nregion                      tets          volume    min dihedral"
                              "    radius ratio\ndomain  "));
  EXPECT_THAT(text, HasSubstr(line));
}

TEST_F(QualityOf, a_mesh_that_is_none_is_an_error_with_all_complaints) {
  GridSource grid(cut_grid(2));
  std::swap(grid.parts[0].tets[0][0], grid.parts[0].tets[0][1]);
  const std::string file = write(grid);
  const Said said = quality(file, true);
  EXPECT_EQ(said.code, ExitCode::gate);
  const Json json = Json::parse(said.out);
  EXPECT_EQ(json["valid"], false);
  EXPECT_FALSE(json.contains("time_step"));
  std::string expected = file + ": not a valid mesh";
  for (const Json& complaint : json["complaints"]) {
    expected += "\n  " + complaint.get<std::string>();
  }
  EXPECT_EQ(said.error, expected);
  EXPECT_EQ(json["complaints"].size(), 6U);
  EXPECT_THAT(quality(file).out, Not(HasSubstr("time step")));
}

TEST_F(QualityOf, faces_are_checked_unless_that_is_not_wanted) {
  GridSource grid(cut_grid(2));
  grid.parts[0].faces.pop_back();
  grid.parts[0].patch_of_face.pop_back();
  QualityOptions options;
  options.input = write(grid);
  const auto complaints = [&options] {
    return said_by([&] { return quality_command(options); }).error;
  };
  EXPECT_THAT(complaints(), HasSubstr("\n  face "));
  options.check_faces = false;
  EXPECT_THAT(complaints(), Not(HasSubstr("\n  face ")));
}

TEST_F(QualityOf, sizes_of_memory_are_to_be_sizes) {
  QualityOptions options;
  options.input = write(GridSource(cut_grid(2)));
  options.memory = "lots";
  const Said said = said_by([&] { return quality_command(options); });
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.error, "--memory: \"lots\" is not a size such as 256MiB");
}

}  // namespace
}  // namespace tetfarm
