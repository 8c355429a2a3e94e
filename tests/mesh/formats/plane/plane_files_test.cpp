#include "mesh/formats/plane/plane_files.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(PlaneFiles, have_their_format_from_the_ending) {
  const TempFolder folder;
  for (const std::string name : {"a.mesh", "a.su2", "a.msh", "a.meshb", "b.SU2"}) {
    const std::filesystem::path path = folder.path() / name;
    write_plane_mesh(square_ring(), path);
    const PlaneMesh back = read_plane_mesh(path);
    EXPECT_EQ(back.triangles, square_ring().triangles) << name;
    EXPECT_EQ(back.points, square_ring().points) << name;
    EXPECT_EQ(back.name, path.string());
  }
}

TEST(PlaneFiles, of_an_unknown_ending_are_refused_with_those_that_are_known) {
  const TempFolder folder;
  for (const std::string name : {"a", "a.stl", "a.b/c", "mesh"}) {
    const std::filesystem::path path = folder.path() / name;
    const auto said_of = [&](const auto& action) { return error_text_of<UsageError>(action); };
    for (const std::string& said : {said_of([&] { read_plane_mesh(path); }),
                                    said_of([&] { require_plane_input_name(path); })}) {
      EXPECT_THAT(said, AllOf(HasSubstr(name + ": meshes of the plane are read from .mesh (Medit"),
                              HasSubstr(".su2 (SU2)"), Not(HasSubstr("OpenFOAM"))));
    }
    for (const std::string& said : {said_of([&] { write_plane_mesh(square_ring(), path); }),
                                    said_of([&] { require_plane_output_name(path); })}) {
      EXPECT_THAT(said, AllOf(HasSubstr("are written to .mesh (Medit"), HasSubstr("OpenFOAM")));
    }
  }
}

TEST(PlaneFiles, of_openfoam_are_named_by_a_folder_that_is_there_or_a_slash) {
  const TempFolder folder;
  write_plane_mesh(square_ring(), folder.path() / "new/");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "new/constant/polyMesh/faces"));
  write_plane_mesh(square_ring(), folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "constant/polyMesh/faces"));
}

TEST(PlaneFiles, may_be_packed) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "a.su2";
  write_plane_mesh(square_ring(), path);
  const std::string bytes = read_file(path);
  const std::string packed = path.string() + ".gz";
  gzFile file = gzopen(packed.c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  EXPECT_EQ(read_plane_mesh(std::filesystem::path(packed)).triangles, square_ring().triangles);
}

TEST(PlaneFiles, keep_names_of_patches_from_one_format_to_the_other) {
  const TempFolder folder;
  write_plane_mesh(square_ring(), folder.path() / "a.su2");
  write_plane_mesh(read_plane_mesh(folder.path() / "a.su2"), folder.path() / "a.msh");
  write_plane_mesh(read_plane_mesh(folder.path() / "a.msh"), folder.path() / "b.su2");
  EXPECT_EQ(read_file(folder.path() / "a.su2"), read_file(folder.path() / "b.su2"));
}

}  // namespace
}  // namespace tetfarm
