// A mesh of all types of cells goes out and comes in again by every format that can hold it, and is
// judged as a whole.

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>

#include "base/error.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/quality/mesh_check.h"
#include "tests/base/temp_folder.h"
#include "tests/support/hybrid_grid.h"
#include "tests/support/hybrid_mesh.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Form {
  std::string format;
  std::string name;
  std::string opened;
  bool has_regions = true;

  friend void PrintTo(const Form& form, std::ostream* stream) { *stream << form.format; }
};

std::vector<Form> forms() {
  return {{"vtkhdf", "m.vtkhdf", "m.vtkhdf"},
          {"pvtu", "m.pvtu", "m.pvtu"},
          {"lb8.ugrid", "m.lb8.ugrid", "m.lb8.ugrid"},
          {"b8.ugrid", "m.b8.ugrid", "m.b8.ugrid"},
          {"lb8l.ugrid", "m.lb8l.ugrid", "m.lb8l.ugrid"},
          {"b8l.ugrid", "m.b8l.ugrid", "m.b8l.ugrid"},
          {"cgns", "m.cgns", "m.cgns"},
          {"msh41", "m41.msh", "m41.msh"},
          {"msh41-text", "m41t.msh", "m41t.msh"},
          {"msh41-split", "parts.msh", "parts_1.msh"},
          {"msh22", "m22.msh", "m22.msh"},
          {"su2", "m.su2", "m.su2", false},
          {"meshb", "m.meshb", "m.meshb"}};
}

class HybridMeshInFormats : public testing::TestWithParam<Form> {
 protected:
  std::unique_ptr<MeshSource> out_and_in(const MeshSource& mesh) {
    const Form& form = GetParam();
    const std::filesystem::path file = folder_.path() / form.name;
    export_mesh(mesh, find_mesh_format(form.format, file), file);
    return open_mesh(folder_.path() / form.opened, folder_.path());
  }

  TempFolder folder_;
};

TEST_P(HybridMeshInFormats, keeps_its_digest_and_its_volume) {
  const HybridMesh mesh;
  const MeshCheckResult wanted = check_mesh(mesh);
  ASSERT_THAT(wanted.complaints, IsEmpty());
  const MeshCheckResult found = check_mesh(*out_and_in(mesh));
  EXPECT_THAT(found.complaints, IsEmpty());
  EXPECT_EQ(found.nodes, wanted.nodes);
  EXPECT_EQ(found.digest, wanted.digest);
  EXPECT_NEAR(found.volume, HybridMesh::volume, 1e-14);
  EXPECT_NEAR(found.enclosed_volume, HybridMesh::volume, 1e-14);
}

TEST_P(HybridMeshInFormats, keeps_its_counts_and_regions) {
  const HybridMesh mesh(GetParam().has_regions ? 2 : 1);
  const MeshCheckResult wanted = check_mesh(mesh);
  ASSERT_THAT(wanted.complaints, IsEmpty());
  const std::unique_ptr<MeshSource> read = out_and_in(mesh);
  EXPECT_EQ(check_mesh(*read).digest, wanted.digest);
  const MeshOutline outline = outline_of(*read);
  EXPECT_EQ(outline.tets, 1);
  EXPECT_EQ(outline.blocks[ElementType::hex].count, 2);
  EXPECT_EQ(outline.blocks[ElementType::prism].count, 1);
  EXPECT_EQ(outline.blocks[ElementType::pyramid].count, 2);
  if (!GetParam().has_regions) return;
  EXPECT_THAT(outline.tets_of_region, ElementsAre(0, 1));
  EXPECT_THAT(outline.blocks[ElementType::hex].of_group, ElementsAre(2, 0));
  EXPECT_THAT(outline.blocks[ElementType::prism].of_group, ElementsAre(1, 0));
  EXPECT_THAT(outline.blocks[ElementType::pyramid].of_group, ElementsAre(0, 2));
  EXPECT_EQ(outline.boundary_faces_of(2), 1);
  for (std::size_t i = 0; i < read->size(); ++i) {
    const NumberedPart part = read->part(i);
    for_each_block_face(part.blocks, [&](ElementType, std::span<const std::int32_t> nodes,
                                         std::int32_t region, std::int32_t) {
      const bool is_between = std::all_of(nodes.begin(), nodes.end(), [&](std::int32_t v) {
        return part.nodes[static_cast<std::size_t>(v)].x == 1;
      });
      if (is_between && part.tets.size() == 1) {
        EXPECT_EQ(region, 2);
      }
      if (part.blocks[ElementType::hex].size() == 2) {
        EXPECT_EQ(region, 1);
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(, HybridMeshInFormats, testing::ValuesIn(forms()), [](const auto& form) {
  std::string name = form.param.format;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
});

TEST(HybridMesh, a_format_of_tets_refuses_it_with_a_sentence_that_counts) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "m.node";
  EXPECT_THAT([&] { export_mesh(HybridMesh(), find_mesh_format("tetgen", file), file); },
              testing::ThrowsMessage<Error>(
                  HasSubstr("tetrahedra only; this mesh has 2 pyramids, 1 prism, 2 hexes, ")));
}

/// Cells, nodes, boundary faces and the volume of what a mesh was written as.
void expect_same_mesh(const MeshSource& wanted, const MeshSource& found) {
  const MeshCheckResult check = check_mesh(found);
  EXPECT_THAT(check.complaints, IsEmpty());
  const MeshOutline wanted_outline = outline_of(wanted);
  const MeshOutline outline = outline_of(found);
  for (const ElementType type : all_element_types) {
    EXPECT_EQ(outline.elements()[type], wanted_outline.elements()[type]) << element(type).plural;
  }
  EXPECT_EQ(outline.nodes, wanted_outline.nodes);
  EXPECT_EQ(outline.faces_of_patch.size(), wanted_outline.faces_of_patch.size());
  EXPECT_NEAR(check.volume, check_mesh(wanted).volume, 1e-9);
}

TEST(HybridMesh, openfoam_cases_have_all_cells_whole_and_decomposed) {
  for (const auto& [format, name] :
       {std::pair("openfoam", "case"), std::pair("openfoam-decomposed", "parts")}) {
    SCOPED_TRACE(format);
    const TempFolder folder;
    export_mesh(HybridMesh(), find_mesh_format(format, name), folder.path() / name);
    expect_same_mesh(HybridMesh(), *open_mesh(folder.path() / name, folder.path()));
    const HybridGrid grid(5, 3);
    export_mesh(grid, find_mesh_format(format, name), folder.path() / "grid");
    expect_same_mesh(grid, *open_mesh(folder.path() / "grid", folder.path()));
  }
}

TEST(HybridMesh, every_format_has_the_grid_of_all_types_as_it_was) {
  const HybridGrid grid(4, 3);
  const MeshCheckResult wanted = check_mesh(grid);
  ASSERT_THAT(wanted.complaints, IsEmpty());
  EXPECT_NEAR(wanted.volume, grid.volume(), 1e-9);
  for (const Form& form : forms()) {
    SCOPED_TRACE(form.format);
    const TempFolder folder;
    export_mesh(grid, find_mesh_format(form.format, form.name), folder.path() / form.name);
    const std::unique_ptr<MeshSource> read = open_mesh(folder.path() / form.opened, folder.path());
    expect_same_mesh(grid, *read);
    EXPECT_EQ(check_mesh(*read).digest, wanted.digest);
  }
}

TEST(HybridMesh, a_quad_whose_neighbour_has_two_triangles_there_is_found) {
  HybridMesh mesh;
  ElementBlock& pyramids = mesh.parts[1].blocks[ElementType::pyramid];
  NumberedPart& part = mesh.parts[1];
  const std::vector<std::int32_t> base(pyramids.nodes.begin(), pyramids.nodes.begin() + 5);
  pyramids.nodes.erase(pyramids.nodes.begin(), pyramids.nodes.begin() + 5);
  pyramids.regions.pop_back();
  part.tets.push_back({base[0], base[1], base[2], base[4]});
  part.tets.push_back({base[0], base[2], base[3], base[4]});
  const MeshCheckResult result = check_mesh(mesh);
  EXPECT_NEAR(result.volume, HybridMesh::volume, 1e-14);
  EXPECT_THAT(result.complaints,
              testing::Contains(HasSubstr("face (1, 2, 6, 5) at (1, 0.5, 0.5) has 1 tet")));
}

TEST(HybridMesh, a_turned_cell_is_named) {
  HybridMesh mesh;
  ElementBlock& prisms = mesh.parts[0].blocks[ElementType::prism];
  std::rotate(prisms.nodes.begin(), prisms.nodes.begin() + 3, prisms.nodes.end());
  EXPECT_THAT(check_mesh(mesh).complaints,
              testing::Contains(HasSubstr("prism 0 of sub-domain 0, at (0.5, 0.5, 1.33333333)")));
}

TEST(HybridMesh, a_cell_with_a_volume_that_is_turned_over_at_a_corner_is_named) {
  HybridMesh mesh;
  for (Vec3& p : mesh.parts[0].nodes) {
    if (p == Vec3{0, 0, -1}) p = {0.7, 0.7, -0.3};
  }
  EXPECT_THAT(check_mesh(mesh).complaints,
              testing::Contains(testing::AllOf(HasSubstr("hex 1 of sub-domain 0"),
                                               HasSubstr("has the volume 0."),
                                               HasSubstr("and the scaled Jacobian -"))));
}

TEST(HybridMesh, an_element_of_another_type_or_patch_changes_the_digest) {
  const Hash128 digest = check_mesh(HybridMesh()).digest;
  HybridMesh other_patch;
  ++other_patch.parts[0].blocks[ElementType::quad].patches[0];
  EXPECT_NE(check_mesh(other_patch).digest, digest);
  HybridMesh other_start;
  std::vector<std::int32_t>& nodes = other_start.parts[0].blocks[ElementType::hex].nodes;
  std::swap(nodes[0], nodes[1]);
  EXPECT_NE(check_mesh(other_start).digest, digest);
}

}  // namespace
}  // namespace tetfarm
