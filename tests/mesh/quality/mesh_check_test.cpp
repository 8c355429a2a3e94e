#include "mesh/quality/mesh_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

GridSource grid() { return GridSource(cut_grid(4)); }

std::vector<std::string> complaints_of(const GridSource& source, bool faces = true) {
  MeshCheckOptions options;
  options.faces = faces;
  return check_mesh(source, options).complaints;
}

/// The number in the whole mesh of a tet of a part.
std::string tet_name(const GridSource& source, std::size_t part, std::size_t tet) {
  for (std::size_t i = 0; i < part; ++i) tet += source.parts[i].tets.size();
  return "tet " + std::to_string(tet) + " of sub-domain " + std::to_string(part);
}

/// A tet of the part with all its faces inside.
std::size_t inner_tet(const NumberedPart& part) {
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    const bool is_inside = std::all_of(part.tets[t].begin(), part.tets[t].end(), [&](auto v) {
      const Vec3& p = part.nodes[at(v)];
      const auto inner = [](double x) { return x > 0 && x < 1; };
      return inner(p.x) && inner(p.y) && inner(p.z);
    });
    if (is_inside) return t;
  }
  return part.tets.size();
}

TEST(MeshCheck, a_right_mesh_has_its_counts_volume_and_no_complaint) {
  const MeshCheckResult result = check_mesh(grid());
  EXPECT_THAT(result.complaints, IsEmpty());
  EXPECT_EQ(result.nodes, 125);
  EXPECT_NEAR(result.volume, 1, 1e-12);
  EXPECT_NEAR(result.enclosed_volume, 1, 1e-12);
}

TEST(MeshCheck, a_missing_tet_leaves_faces_with_one_tet) {
  GridSource source = grid();
  NumberedPart& part = source.parts[2];
  part.tets.erase(part.tets.begin() + static_cast<long>(inner_tet(part)));
  const auto complaints = complaints_of(source);
  EXPECT_THAT(complaints,
              Contains(AllOf(HasSubstr("face ("), HasSubstr("has 1 tet ("), HasSubstr("tet "))));
  EXPECT_THAT(complaints, Contains(HasSubstr("boundary encloses 1")));
}

TEST(MeshCheck, a_tet_that_is_there_twice_is_named_with_the_other) {
  GridSource source = grid();
  NumberedPart& part = source.parts[2];
  const std::size_t twice = inner_tet(part);
  part.tets.push_back(part.tets[twice]);
  const auto complaints = complaints_of(source);
  EXPECT_THAT(complaints,
              Contains(AllOf(HasSubstr("has 3 tets"), HasSubstr(tet_name(source, 2, twice)),
                             HasSubstr(tet_name(source, 2, part.tets.size() - 1)))));
}

TEST(MeshCheck, a_tet_that_two_subdomains_have_is_found_from_both) {
  GridSource source = grid();
  const NumberedPart& from = source.parts[2];
  const std::size_t twice = inner_tet(from);
  NumberedPart& part = source.parts[0];
  Tet& copy = part.tets.emplace_back();
  for (std::size_t k = 0; k < 4; ++k) {
    copy[k] = static_cast<std::int32_t>(part.nodes.size());
    part.nodes.push_back(from.nodes[at(from.tets[twice][k])]);
    part.local2global.push_back(from.local2global[at(from.tets[twice][k])]);
  }
  EXPECT_THAT(complaints_of(source),
              Contains(AllOf(HasSubstr("has 3 tets"), HasSubstr("of sub-domain 0"),
                             HasSubstr("of sub-domain 2"))));
}

TEST(MeshCheck, a_missing_boundary_triangle_leaves_a_face_of_one_tet_with_its_place) {
  GridSource source = grid();
  NumberedPart& part = source.parts[1];
  const Triangle face = part.faces.back();
  part.faces.pop_back();
  part.patch_of_face.pop_back();
  const Vec3 middle =
      (part.nodes[at(face[0])] + part.nodes[at(face[1])] + part.nodes[at(face[2])]) / 3.0;
  EXPECT_THAT(complaints_of(source),
              Contains(AllOf(HasSubstr("has 1 tet ("), HasSubstr("and 0 boundary triangles"),
                             HasSubstr("at " + text_of(middle)))));
}

TEST(MeshCheck, a_boundary_triangle_without_a_tet_is_named) {
  GridSource source = grid();
  NumberedPart& part = source.parts[0];
  const Tet& tet = part.tets[inner_tet(source.parts[0]) % part.tets.size()];
  part.faces.push_back({tet[0], tet[1], tet[2]});
  part.patch_of_face.push_back(0);
  const std::string name = "boundary triangle " + std::to_string(part.faces.size() - 1);
  EXPECT_THAT(complaints_of(source), Contains(HasSubstr(name)));
}

TEST(MeshCheck, boundary_triangles_are_numbered_through_all_parts) {
  GridSource source = grid();
  Triangle& face = source.parts[2].faces[3];
  std::swap(face[0], face[1]);
  const std::size_t before = source.parts[0].faces.size() + source.parts[1].faces.size();
  EXPECT_THAT(complaints_of(source),
              Contains(HasSubstr("boundary triangle " + std::to_string(before + 3))));
}

TEST(MeshCheck, a_boundary_triangle_that_points_inwards_is_refused) {
  GridSource source = grid();
  Triangle& face = source.parts[0].faces[3];
  std::swap(face[0], face[1]);
  EXPECT_THAT(complaints_of(source), Contains(HasSubstr("boundary triangle 3")));
}

TEST(MeshCheck, a_turned_tet_is_named_also_without_comparing_faces) {
  GridSource source = grid();
  std::swap(source.parts[1].tets[5][0], source.parts[1].tets[5][1]);
  for (const bool faces : {true, false}) {
    EXPECT_THAT(complaints_of(source, faces),
                Contains(AllOf(HasSubstr(tet_name(source, 1, 5)), HasSubstr("has the volume -"))));
  }
}

TEST(MeshCheck, two_tets_on_the_same_side_of_a_face_are_told_from_neighbours) {
  GridSource source = grid();
  NumberedPart& part = source.parts[2];
  Tet& tet = part.tets[inner_tet(part)];
  std::swap(tet[0], tet[1]);
  EXPECT_THAT(complaints_of(source),
              Contains(AllOf(HasSubstr("has 2 tets"), Not(HasSubstr("1 from one side")))));
}

TEST(MeshCheck, a_shared_node_that_lies_elsewhere_by_the_last_bit_is_named) {
  GridSource source = grid();
  // A node on the cut between sub-domains 0 and 1.
  NumberedPart& part = source.parts[0];
  for (std::size_t v = 0; v < part.nodes.size(); ++v) {
    const auto& other = source.parts[1].local2global;
    if (std::find(other.begin(), other.end(), part.local2global[v]) == other.end()) continue;
    part.nodes[v].x = std::nextafter(part.nodes[v].x, 2);
    EXPECT_THAT(complaints_of(source, false),
                Contains(AllOf(HasSubstr("node " + std::to_string(part.local2global[v])),
                               HasSubstr("in sub-domain 0"), HasSubstr("in sub-domain 1"))));
    return;
  }
  FAIL() << "the grid has no cut";
}

TEST(MeshCheck, a_node_that_no_tet_has_and_a_gap_in_the_numbers_are_told) {
  GridSource source = grid();
  source.parts[0].nodes.push_back({0.5, 0.5, 7});
  source.parts[0].local2global.push_back(200);
  const auto complaints = complaints_of(source);
  EXPECT_THAT(complaints, Contains(HasSubstr("node 200 at (0.5, 0.5, 7) is in no tet")));
  EXPECT_THAT(complaints, Contains(HasSubstr("numbers have gaps")));
}

TEST(MeshCheck, a_number_that_no_mesh_could_have_is_refused) {
  for (const std::int64_t number : {std::int64_t{-1}, std::int64_t{1} << 60}) {
    GridSource source = grid();
    source.parts[0].local2global[0] = number;
    EXPECT_THROW(check_mesh(source), InvalidInput);
  }
}

TEST(MeshCheck, a_triangle_between_regions_has_two_tets_and_counts_for_each) {
  GridSource source = grid();
  // The two sub-domains of the upper half become a region: the cut below it a boundary of both.
  EXPECT_THAT(complaints_of(source), IsEmpty());
  const auto add = [](NumberedPart& part, const std::array<std::int64_t, 3>& nodes) {
    Triangle face{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = std::find(part.local2global.begin(), part.local2global.end(), nodes[k]);
      face[k] = static_cast<std::int32_t>(found - part.local2global.begin());
    }
    part.faces.push_back(face);
    part.patch_of_face.push_back(0);
  };
  // A face that sub-domain 0 shares with another: both its sides become boundary triangles.
  NumberedPart& low = source.parts[0];
  for (const Tet& tet : low.tets) {
    for (const auto& [i, j, k] : tet_face_nodes) {
      const std::array<std::int64_t, 3> nodes = {low.local2global[at(tet[at(i)])],
                                                 low.local2global[at(tet[at(j)])],
                                                 low.local2global[at(tet[at(k)])]};
      const auto has = [&](const NumberedPart& part) {
        return std::all_of(nodes.begin(), nodes.end(), [&](std::int64_t node) {
          return std::count(part.local2global.begin(), part.local2global.end(), node) > 0;
        });
      };
      if (!has(source.parts[1])) continue;
      add(low, nodes);
      EXPECT_THAT(complaints_of(source), Contains(HasSubstr("has 2 tets"))) << "one side alone";
      add(source.parts[1], {nodes[0], nodes[2], nodes[1]});
      EXPECT_THAT(complaints_of(source), IsEmpty());
      return;
    }
  }
  FAIL() << "the grid has no cut";
}

TEST(MeshCheck, of_every_format_is_that_of_the_mesh_it_was_exported_from) {
  GridSource source(cut_grid(4));
  for (const std::size_t part : {1, 2}) source.parts[part].region = 2;
  const MeshCheckResult wanted = check_mesh(source);
  for (const auto& [format, file] : {std::pair{"vtkhdf", "a.vtkhdf"},
                                     {"lb8.ugrid", "a.lb8.ugrid"},
                                     {"b8.ugrid", "a.b8.ugrid"},
                                     {"lb8l.ugrid", "a.lb8l.ugrid"},
                                     {"b8l.ugrid", "a.b8l.ugrid"},
                                     {"meshb", "a.meshb"},
                                     {"tetgen", "a.node"},
                                     {"msh22", "a.msh"},
                                     {"pvtu", "a.pvtu"},
                                     {"cgns", "a.cgns"},
                                     {"msh41", "a.msh"},
                                     {"msh41-text", "a.msh"},
                                     {"su2", "a.su2"}}) {
    SCOPED_TRACE(format);
    const TempFolder folder;
    export_mesh(source, find_mesh_format(format, file), folder.path() / file);
    const MeshCheckResult read = check_mesh(*open_mesh(folder.path() / file, folder.path()));
    EXPECT_THAT(read.complaints, IsEmpty());
    EXPECT_EQ(read.nodes, wanted.nodes);
    EXPECT_EQ(read.volume, wanted.volume);
    EXPECT_NEAR(read.enclosed_volume, wanted.enclosed_volume, 1e-14);
    EXPECT_EQ(read.digest, wanted.digest);
  }
}

TEST(MeshCheck, of_openfoam_is_that_of_the_mesh_but_for_the_digest_which_the_order_of_nodes_is_in) {
  GridSource source(cut_grid(4));
  for (const std::size_t part : {1, 2}) source.parts[part].region = 2;
  const MeshCheckResult wanted = check_mesh(source);
  for (const char* format : {"openfoam", "openfoam-decomposed"}) {
    SCOPED_TRACE(format);
    const TempFolder folder;
    export_mesh(source, find_mesh_format(format, "case"), folder.path() / "case");
    const auto read = open_mesh(folder.path() / "case", folder.path());
    const MeshCheckResult result = check_mesh(*read);
    EXPECT_THAT(result.complaints, IsEmpty());
    EXPECT_EQ(result.nodes, wanted.nodes);
    EXPECT_NEAR(result.volume, wanted.volume, 1e-14);
    EXPECT_NEAR(result.enclosed_volume, wanted.enclosed_volume, 1e-14);
    EXPECT_EQ(result.forced.at_most_deg, wanted.forced.at_most_deg);
    EXPECT_NE(result.digest, wanted.digest);
  }
}

TEST(MeshCheck, of_openfoam_finds_a_cell_that_is_turned_inside_out) {
  const TempFolder folder;
  GridSource source = grid();
  // Its nodes stay, and with them the faces of its neighbours.
  Vec3& node = source.parts[0].nodes[at(source.parts[0].tets[0][0])];
  const Vec3 was = node;
  for (NumberedPart& part : source.parts) {
    std::replace(part.nodes.begin(), part.nodes.end(), was, Vec3{0.9, 0.9, 0.9});
  }
  export_mesh(source, find_mesh_format("openfoam", "case"), folder.path() / "case");
  EXPECT_THAT(check_mesh(*open_mesh(folder.path() / "case", folder.path())).complaints,
              Contains(HasSubstr("has the volume -")));
}

TEST(MeshCheck, finds_the_same_with_the_least_memory) {
  GridSource source = GridSource(cut_grid(12));
  MeshCheckOptions small;
  small.memory_bytes = 1;
  EXPECT_THAT(check_mesh(source, small).complaints, IsEmpty());
  source.parts[1].tets.pop_back();
  source.parts[2].tets.erase(source.parts[2].tets.begin());
  EXPECT_EQ(check_mesh(source, small).complaints, check_mesh(source).complaints);
  EXPECT_THAT(check_mesh(source).complaints, Not(IsEmpty()));
}

TEST(MeshCheck, forced_angle_is_that_of_the_boundary_in_memory) {
  const GridSource source = grid();
  std::vector<Vec3> nodes(static_cast<std::size_t>(source.nodes));
  std::vector<Triangle> triangles;
  for (const NumberedPart& part : source.parts) {
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      nodes[static_cast<std::size_t>(part.local2global[v])] = part.nodes[v];
    }
    for (Triangle face : part.faces) {
      for (std::int32_t& v : face) v = static_cast<std::int32_t>(part.local2global[at(v)]);
      triangles.push_back(face);
    }
  }
  const ForcedDihedral whole = forced_dihedral(nodes, triangles);
  const ForcedDihedral streamed = check_mesh(source).forced;
  EXPECT_EQ(streamed.at_most_deg, whole.at_most_deg);
  EXPECT_EQ(streamed.at, whole.at);
  EXPECT_LT(whole.at_most_deg, 70);
}

}  // namespace
}  // namespace tetfarm
