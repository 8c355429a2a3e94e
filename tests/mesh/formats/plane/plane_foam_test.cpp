#include "mesh/formats/plane/plane_foam.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

double volume_of_prism(const NumberedPart& part, const ElementBlock& prisms, std::size_t i) {
  std::vector<Vec3> corners;
  for (const std::int32_t v : prisms.element(ElementType::prism, i)) {
    corners.push_back(part.nodes[static_cast<std::size_t>(v)]);
  }
  return static_cast<double>(element_volume(ElementType::prism, corners));
}

/// The ring as a case, and what the reader of OpenFOAM's meshes finds in it.
class PlaneFoam : public ::testing::Test {
 protected:
  explicit PlaneFoam(const PlaneMesh& mesh = square_ring()) {
    write_plane_foam(mesh, case_folder());
  }
  std::filesystem::path case_folder() const { return folder_.path() / "case"; }
  std::string file(const std::string& name) const {
    return read_file(case_folder() / "constant/polyMesh" / name);
  }

  const TempFolder folder_;
};

TEST_F(PlaneFoam, is_read_as_prisms_of_height_1_over_the_triangles) {
  const auto source = open_mesh(case_folder(), folder_.path());
  std::size_t prisms = 0;
  double volume = 0;
  for (std::size_t i = 0; i < source->size(); ++i) {
    const NumberedPart part = source->part(i);
    EXPECT_TRUE(part.tets.empty());
    const ElementBlock& block = part.blocks[ElementType::prism];
    for (std::size_t k = 0; k < block.size(); ++k) {
      const double of_prism = volume_of_prism(part, block, k);
      EXPECT_GT(of_prism, 0);
      volume += of_prism;
    }
    prisms += block.size();
  }
  EXPECT_EQ(prisms, 8U);
  EXPECT_NEAR(volume, 8, 1e-12);
  EXPECT_THAT(source->patch_names(), ElementsAre("inlet", "patch_5", "the_body", "frontAndBack"));
  EXPECT_THAT(source->region_names(), ElementsAre("region_1", "upper"));
}

TEST_F(PlaneFoam, has_patches_of_the_type_that_a_flow_wants) {
  const std::string boundary = file("boundary");
  const auto entry = [](const std::string& name, const std::string& type, int faces, int first) {
    return "    " + name + "\n    {\n        type            " + type +
           ";\n        nFaces          " + std::to_string(faces) + ";\n        startFace       " +
           std::to_string(first) + ";\n    }\n";
  };
  EXPECT_THAT(
      boundary,
      HasSubstr("\n4\n(\n" + entry("inlet", "patch", 1, 8) + entry("patch_5", "patch", 3, 9) +
                entry("the_body", "wall", 4, 12) + entry("frontAndBack", "empty", 16, 16)));
}

TEST_F(PlaneFoam, takes_a_patch_for_a_wall_that_is_named_so) {
  for (const std::string name : {"wall", "lowerWall", "walls_7", "Side-Walls"}) {
    PlaneMesh mesh = square_ring();
    mesh.patch_names[3] = name;
    write_plane_foam(mesh, case_folder());
    EXPECT_THAT(file("boundary"), HasSubstr(name + "\n    {\n        type            wall;"));
  }
}

TEST_F(PlaneFoam, leaves_out_nodes_without_triangles_and_zones_of_one_region) {
  PlaneMesh mesh = square_ring();
  mesh.points.insert(mesh.points.begin(), Vec2{-5, -5});
  for (auto& triangle : mesh.triangles) {
    for (std::int32_t& v : triangle) ++v;
  }
  for (auto& edge : mesh.edges) {
    for (std::int32_t& v : edge) ++v;
  }
  mesh.regions.assign(8, 1);
  write_plane_foam(mesh, case_folder());  // over the one that is there
  EXPECT_FALSE(std::filesystem::exists(case_folder() / "constant/polyMesh/cellZones"));
  EXPECT_THAT(file("points"), AllOf(HasSubstr("\n16\n("), Not(HasSubstr("-5"))));
  EXPECT_EQ(open_mesh(case_folder(), folder_.path())->part(0).nodes.size(), 16U);
}

TEST_F(PlaneFoam, does_not_name_two_patches_alike) {
  PlaneMesh mesh = square_ring();
  mesh.patch_names[3] = "frontAndBack";
  write_plane_foam(mesh, case_folder());
  EXPECT_THAT(file("boundary"), HasSubstr("    frontAndBack_2\n"));
}

}  // namespace
}  // namespace tetfarm
