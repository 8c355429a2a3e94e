// What is said of small meshes, whose figures are worked out by hand: all of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mesh/quality/mesh_check.h"
#include "mesh/quality/mesh_figures.h"
#include "tests/mesh/formats/every_kind_mesh.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(SmallMeshFigures, count_and_sum_each_type_sub_domain_and_region) {
  const MeshFigures figures = figures_of(EveryKindMesh());
  EXPECT_EQ(figures.nodes, 24);
  EXPECT_EQ(figures.tets, 3);
  EXPECT_EQ(figures.boundary_triangles, 20);
  EXPECT_EQ(figures.boundary_quads, 13);
  EXPECT_EQ(figures.cells(), 8);
  const double flat = 1e-7 / 6;
  EXPECT_NEAR(figures.volume, HybridMesh::volume + 1.0 / 6 + flat, 1e-12);
  const CellFigures& hexes = figures.others[ElementType::hex];
  EXPECT_EQ(hexes.cells, 2);
  EXPECT_DOUBLE_EQ(hexes.volume, 2);
  EXPECT_DOUBLE_EQ(hexes.least_scaled_jacobian, 1);
  EXPECT_DOUBLE_EQ(hexes.mean_scaled_jacobian(), 1);
  const CellFigures& pyramids = figures.others[ElementType::pyramid];
  EXPECT_EQ(pyramids.cells, 2);
  EXPECT_NEAR(pyramids.volume, 2.0 / 3, 1e-12);
  EXPECT_NEAR(pyramids.mean_scaled_jacobian(), pyramids.least_scaled_jacobian, 1e-12);
  EXPECT_GT(pyramids.least_scaled_jacobian, 0.5);
  EXPECT_EQ(figures.others[ElementType::prism].cells, 1);
  EXPECT_EQ(CellFigures().mean_scaled_jacobian(), 0);
  ASSERT_EQ(figures.regions.size(), 3U);
  EXPECT_NEAR(figures.regions[0].volume, 2.5 + 1.0 / 6, 1e-12);
  EXPECT_NEAR(figures.regions[1].volume, 1.0 / 3 + 5.0 / 24, 1e-12);
  EXPECT_NEAR(figures.regions[2].volume, 1.0 / 3 + flat, 1e-12);
  EXPECT_EQ(figures.regions[2].shapes.tets, 1);
  EXPECT_THAT(figures.volumes, ElementsAre(Pair(-26, 1), Pair(-3, 2)));
  ASSERT_EQ(figures.subdomains.size(), 3U);
  EXPECT_EQ(figures.subdomains[1].cells, 3);
  EXPECT_EQ(figures.subdomains[1].nodes, 11);
  EXPECT_EQ(figures.subdomains[1].boundary_triangles, 10);
  EXPECT_NEAR(figures.subdomains[1].volume, 2.0 / 3 + 5.0 / 24, 1e-12);
  EXPECT_EQ(figures.subdomains[0].min_dihedral_deg, 180) << "it has no tets";
  EXPECT_EQ(figures.largest_over_mean(), 3 * 3.0 / 8);
  EXPECT_EQ(MeshFigures().largest_over_mean(), 1);
}

TEST(SmallMeshFigures, name_the_flattest_tet_first) {
  const MeshFigures figures = figures_of(EveryKindMesh());
  ASSERT_EQ(figures.worst.size(), 3U);
  const WorstTet& worst = figures.worst[0];
  EXPECT_EQ(worst.tet, 2);
  EXPECT_EQ(worst.subdomain, 2U);
  EXPECT_FALSE(worst.is_near_cut);
  EXPECT_NEAR(worst.height, 1e-7, 1e-10);
  EXPECT_LT(worst.min_dihedral_deg, 1e-4);
  EXPECT_NEAR(worst.max_dihedral_deg, 90, 1e-4) << "it stands over a corner of its base";
  EXPECT_LT(worst.radius_ratio, 1e-6);
  EXPECT_EQ(worst.centroid, figures.all.lowest_at);
  EXPECT_NEAR(worst.centroid.x, 5.25, 1e-12);
  EXPECT_EQ(figures.time_step(), worst.height);
  EXPECT_EQ(figures.steps_beside_away(), 1);
  // Three right angles, and three of arccos(1 / sqrt 3) = 54.7 degrees.
  const double corner = std::acos(1 / std::sqrt(3.0)) * 180 / 3.14159265358979324;
  const WorstTet& unit = figures.worst[1].tet == 1 ? figures.worst[1] : figures.worst[2];
  EXPECT_NEAR(unit.min_dihedral_deg, corner, 1e-9);
  EXPECT_NEAR(unit.max_dihedral_deg, 90, 1e-9);
  EXPECT_NEAR(figures.subdomains[2].min_dihedral_deg, worst.min_dihedral_deg, 1e-12);
  EXPECT_EQ(figures.all.radius_ratio.counts[0], 1);
}

TEST(SmallMeshFigures, measure_each_edge_of_a_part_once) {
  int asked = 0;
  const MeshFigures figures = figures_of(EveryKindMesh(), [&asked](const Vec3&) {
    ++asked;
    return 0.5;
  });
  EXPECT_EQ(figures.edges.edges, 25 + 19 + 12);
  EXPECT_EQ(asked, 56);
  EXPECT_DOUBLE_EQ(figures.edges.shortest, 2e-7);
  EXPECT_EQ(figures.edges.over_spacing.counts[0], 1);
  EXPECT_DOUBLE_EQ(figures.edges.mean(), figures.edges.sum / 56);
  EXPECT_EQ(EdgeFigures().mean(), 0);
}

TEST(SmallMeshFigures, show_each_part_as_it_passes) {
  std::vector<std::int32_t> seen;
  figures_of(EveryKindMesh(), {},
             [&seen](const NumberedPart& part) { seen.push_back(part.number); });
  EXPECT_THAT(seen, ElementsAre(0, 1, 2));
}

using Change = std::function<void(std::vector<NumberedPart>&)>;

std::vector<std::string> said_after(const Change& change, bool faces = true) {
  TetsMesh mesh;
  // The face between the regions belongs to the boundary, once for each.
  NumberedPart& part = mesh.parts[0];
  part.faces.push_back({1, 2, 3});
  part.faces.push_back({1, 3, 2});
  part.patch_of_face.insert(part.patch_of_face.end(), {0, 0});
  set_regions_of_faces(part);
  change(mesh.parts);
  MeshCheckOptions options;
  options.faces = faces;
  return check_mesh(mesh, options).complaints;
}

using Parts = std::vector<NumberedPart>;

TEST(SmallMeshCheck, has_nothing_to_say_of_right_meshes) {
  EXPECT_THAT(said_after([](Parts&) {}), IsEmpty());
  const MeshCheckResult result = check_mesh(EveryKindMesh());
  EXPECT_THAT(result.complaints, IsEmpty());
  EXPECT_EQ(result.nodes, 24);
  EXPECT_NEAR(result.volume, HybridMesh::volume + 1.0 / 6 + 1e-7 / 6, 1e-12);
  EXPECT_NEAR(result.enclosed_volume, result.volume, 1e-12);
}

TEST(SmallMeshCheck, names_a_turned_tet_and_the_faces_that_do_not_fit_it) {
  const auto turn = [](Parts& parts) { std::swap(parts[1].tets[0][0], parts[1].tets[0][1]); };
  EXPECT_THAT(said_after(turn, false),
              ElementsAre("tet 2 of sub-domain 1, nodes (2, 1, 4, 5) at (0.75, 0.75, 0.21875), has "
                          "the volume -0.1875",
                          "the tets fill 0.3125 but the boundary encloses 0.6875"));
  EXPECT_THAT(
      said_after(turn),
      ElementsAre(
          "tet 2 of sub-domain 1, nodes (2, 1, 4, 5) at (0.75, 0.75, 0.21875), has the volume "
          "-0.1875",
          "face (1, 2, 4) at (0.666666667, 0.666666667, 0.333333333) has 2 tets (2 from one side, "
          "0 "
          "from the other) and 0 boundary triangles (0, 0): tet 1 of sub-domain 0, tet 2 of "
          "sub-domain 1",
          "face (1, 2, 5) at (0.666666667, 0.666666667, -0.0416666667) has 1 tet (0 from one side, "
          "1 from the other) and 1 boundary triangle (1, 0): tet 2 of sub-domain 1, boundary "
          "triangle 9 of sub-domain 1",
          "face (1, 4, 5) at (1, 0.666666667, 0.291666667) has 1 tet (1 from one side, 0 from the "
          "other) and 1 boundary triangle (0, 1): tet 2 of sub-domain 1, boundary triangle 8 of "
          "sub-domain 1",
          "face (2, 4, 5) at (0.666666667, 1, 0.291666667) has 1 tet (0 from one side, 1 from the "
          "other) and 1 boundary triangle (1, 0): tet 2 of sub-domain 1, boundary triangle 7 of "
          "sub-domain 1",
          "the tets fill 0.3125 but the boundary encloses 0.6875"));
}

TEST(SmallMeshCheck, names_nodes_that_are_in_no_tet_or_not_finite) {
  EXPECT_THAT(said_after([](Parts& parts) {
                parts[1].nodes.insert(parts[1].nodes.end(), {{7, 8, 9}, {7, 8, 10}});
                parts[1].local2global.insert(parts[1].local2global.end(), {6, 7});
              }),
              ElementsAre("node 6 at (7, 8, 9) is in no tet of sub-domain 1; such nodes: 2"));
  EXPECT_THAT(said_after(
                  [](Parts& parts) {
                    parts[1].nodes.push_back({0, HUGE_VAL, 0});
                    parts[1].local2global.push_back(6);
                  },
                  false),
              ElementsAre("node 6 is not finite",
                          "node 6 at (0, inf, 0) is in no tet of sub-domain 1; such nodes: 1"));
}

TEST(SmallMeshCheck, says_no_more_than_twenty_things) {
  EXPECT_EQ(said_after([](Parts& parts) {
              for (int i = 0; i < 30; ++i) parts[0].tets.push_back({0, 2, 1, 3});
              parts[0].region_of_tet.resize(32, 2);
            }).size(),
            20U);
}

TEST(SmallMeshCheck, digests_patches_and_places_of_nodes) {
  const auto digest = [](const Change& change) {
    TetsMesh mesh;
    change(mesh.parts);
    return check_mesh(mesh).digest;
  };
  const Hash128 right = digest([](Parts&) {});
  EXPECT_EQ(digest([](Parts&) {}), right);
  EXPECT_NE(digest([](Parts& p) { p[1].patch_of_face[0] = 0; }), right);
  EXPECT_NE(digest([](Parts& p) { p[1].nodes[3].x = 2; }), right);
  EXPECT_NE(digest([](Parts& p) { std::swap(p[0].tets[0], p[0].tets[1]); }), right);
  EXPECT_NE(digest([](Parts& p) {
              p[1].faces[0] = {p[1].faces[0][1], p[1].faces[0][0], p[1].faces[0][2]};
            }),
            right);
}

TEST(SmallMeshFigures, of_flat_tets_count_no_volume_and_no_steps_beside_cuts) {
  TetsMesh mesh;
  mesh.parts[0].nodes[3] = {0, 0, 0};  // at node 0
  const MeshFigures figures = figures_of(mesh);
  EXPECT_EQ(figures.all.shapes.smallest_height, 0);
  int volumes = 0;
  for (const auto& [exponent, tets] : figures.volumes) volumes += static_cast<int>(tets);
  EXPECT_EQ(volumes, 2);
  EXPECT_EQ(figures.steps_beside_away(), 1);
  mesh = TetsMesh();
  mesh.parts[1].nodes[3] = mesh.parts[1].nodes[0];  // beside the cut
  const MeshFigures beside = figures_of(mesh);
  EXPECT_GT(beside.away_from_cuts.shapes.smallest_height, 0);
  EXPECT_EQ(beside.all.shapes.smallest_height, 0);
  EXPECT_EQ(beside.steps_beside_away(), 1);
}

TEST(SmallMeshFigures, name_the_first_of_tets_that_are_alike_first) {
  TetsMesh mesh;
  mesh.parts[1] = mesh.parts[0];
  mesh.parts[1].number = 1;
  const MeshFigures figures = figures_of(mesh);
  ASSERT_EQ(figures.worst.size(), 4U);
  EXPECT_EQ(figures.worst[0].min_dihedral_deg, figures.worst[1].min_dihedral_deg);
  EXPECT_LT(figures.worst[0].tet, figures.worst[1].tet);
  EXPECT_LT(figures.worst[2].tet, figures.worst[3].tet);
}

TEST(SmallMeshCheck, counts_cells_of_each_type_through_all_parts) {
  ScatteredMesh mesh;
  mesh.parts[3].blocks[ElementType::quad].nodes[0] = 10;  // of the prism
  MeshCheckOptions options;
  options.faces = true;
  std::string all;
  for (const std::string& line : check_mesh(mesh, options).complaints) all += line + "\n";
  EXPECT_THAT(all, testing::HasSubstr("hex 2 of sub-domain 3"));
}

}  // namespace
}  // namespace tetfarm
