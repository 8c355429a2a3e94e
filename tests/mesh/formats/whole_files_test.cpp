// What is written of a small mesh is compared byte for byte with files that are kept, and what is
// read of those with a listing that is kept: formats are promises to other programs. A change that
// is meant to change files runs this test once with UPDATE_GOLDEN=1 and commits what that writes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "base/file_system.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/formats/surfaces/surface_formats.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/every_kind_mesh.h"
#include "tests/mesh/formats/hdf5_listing.h"
#include "tests/mesh/formats/mesh_listing.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const fs::path kept = fs::path(TETFARM_SOURCE_DIR) / "tests/mesh/formats/fixtures";

/// The files of a folder by their names in it; those of HDF5 as listings.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string name = fs::relative(entry.path(), folder).string();
    std::string bytes = read_file(entry.path());
    if (bytes.starts_with(hdf5_signature)) {
      bytes = hdf5_listing(entry.path().string());
      name += ".txt";
    }
    files[name] = bytes;
  }
  return files;
}

bool is_updating() { return std::getenv("UPDATE_GOLDEN") != nullptr; }

void keep(const fs::path& file, const std::string& bytes) {
  make_folders(file.parent_path());
  write_file_atomically(file, bytes);
}

struct WholeFile {
  const char* format;
  const char* name;    ///< of what is exported
  const char* opened;  ///< of what is opened; empty: the format is not read
};

void PrintTo(const WholeFile& file, std::ostream* out) { *out << file.format; }

constexpr std::array formats_of_all = {WholeFile{"msh41", "a.msh", "a.msh"},
                                       WholeFile{"msh41-text", "a.msh", "a.msh"},
                                       WholeFile{"msh41-split", "a.msh", "a_1.msh"},
                                       WholeFile{"msh41-ghosts", "a.msh", "a_1.msh"},
                                       WholeFile{"msh22", "a.msh", "a.msh"},
                                       WholeFile{"su2", "a.su2", "a.su2"},
                                       WholeFile{"meshb", "a.meshb", "a.meshb"},
                                       WholeFile{"lb8.ugrid", "a.lb8.ugrid", "a.lb8.ugrid"},
                                       WholeFile{"b8.ugrid", "a.b8.ugrid", "a.b8.ugrid"},
                                       WholeFile{"lb8l.ugrid", "a.lb8l.ugrid", "a.lb8l.ugrid"},
                                       WholeFile{"b8l.ugrid", "a.b8l.ugrid", "a.b8l.ugrid"},
                                       WholeFile{"pvtu", "a.pvtu", "a.pvtu"},
                                       WholeFile{"cgns", "a.cgns", "a.cgns"},
                                       WholeFile{"vtkhdf", "a.vtkhdf", "a.vtkhdf"},
                                       WholeFile{"openfoam", "case", "case"},
                                       WholeFile{"openfoam-decomposed", "case", "case"},
                                       WholeFile{"comm", "tables", ""},
                                       WholeFile{"comm-text", "tables", ""}};

constexpr WholeFile tetgen_files = {"tetgen", "a.node", "a.ele"};

std::string surface_listing(const SurfaceMesh& surface) {
  std::string text = "surface\n";
  for (const std::string& name : surface.patch_names) text += "patch \"" + name + "\"\n";
  for (const Vec3& p : surface.vertices) {
    text += " vertex " + digits_of(p.x) + " " + digits_of(p.y) + " " + digits_of(p.z) + "\n";
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    text += " triangle" + numbers_of(surface.triangles[t]) + " patch " +
            std::to_string(surface.patch_of_triangle.at(t)) + "\n";
  }
  return text;
}

/// Whether a file of that name may be read as a surface too: it has no quads.
bool is_surface_too(const std::string& name, const std::string& of) {
  return of == "tets" && !name.ends_with("_1.msh") &&
         (name.ends_with(".msh") || name.ends_with(".su2") || name.ends_with("b") ||
          name.ends_with(".ugrid"));
}

std::string listing_of(const fs::path& file, const fs::path& scratch, const std::string& of) {
  std::string text = mesh_listing(*open_mesh(file, scratch));
  if (is_surface_too(file.filename().string(), of)) {
    text += surface_listing(read_surface(file.string()));
  }
  return text;
}

/// Compares what the format makes of the mesh, and what is read of that.
void expect_whole_files(const MeshSource& mesh, const WholeFile& file, const std::string& of) {
  const TempFolder folder;
  const fs::path here = kept / of / file.format;
  export_mesh(mesh, find_mesh_format(file.format, file.name), folder.path() / file.name);
  const std::map<std::string, std::string> written = files_in(folder.path());
  const std::string opened = file.opened;
  const std::string listing =
      opened.empty() ? "" : listing_of(folder.path() / opened, folder.path(), of);
  const fs::path listing_file = kept / of / (std::string(file.format) + ".read");
  if (is_updating()) {
    fs::remove_all(here);
    for (const auto& [name, bytes] : written) keep(here / name, bytes);
    if (!opened.empty()) keep(listing_file, listing);
    return;
  }
  const std::map<std::string, std::string> expected = files_in(here);
  EXPECT_EQ(written.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    ASSERT_TRUE(written.contains(name)) << name;
    EXPECT_EQ(written.at(name), bytes) << name;
  }
  if (!opened.empty()) {
    EXPECT_EQ(listing, read_file(listing_file));
  }
}

class WholeFiles : public testing::TestWithParam<WholeFile> {};
INSTANTIATE_TEST_SUITE_P(Formats, WholeFiles, testing::ValuesIn(formats_of_all),
                         [](const auto& file) {
                           std::string name = file.param.format;
                           std::replace_if(
                               name.begin(), name.end(),
                               [](char c) { return c == '.' || c == '-'; }, '_');
                           return name;
                         });

TEST_P(WholeFiles, of_every_kind_of_cell_are_those_that_are_kept) {
  expect_whole_files(EveryKindMesh(), GetParam(), "every_kind");
}

TEST_P(WholeFiles, of_tets_alone_are_those_that_are_kept) {
  expect_whole_files(TetsMesh(), GetParam(), "tets");
}

TEST(WholeFilesOfScatteredCells, are_those_that_are_kept) {
  const std::set<std::string> same_code = {"lb8.ugrid", "b8.ugrid", "lb8l.ugrid", "comm"};
  for (const WholeFile& file : formats_of_all) {
    if (same_code.contains(file.format)) continue;
    SCOPED_TRACE(file.format);
    expect_whole_files(ScatteredMesh(), file, "scattered");
  }
}

TEST(WholeLists, of_formats_are_those_that_are_kept) {
  const std::string lists = written_formats_text() + "read: " + readable_meshes() + "\n" +
                            "surfaces: " + readable_surfaces() + "\n" +
                            "surfaces written: " + writable_surfaces() + "\n";
  if (is_updating()) keep(kept / "lists.txt", lists);
  EXPECT_EQ(lists, read_file(kept / "lists.txt"));
}

TEST(WholeFilesOfTetgen, are_those_that_are_kept) {
  expect_whole_files(TetsMesh(), tetgen_files, "tets");
}

}  // namespace
}  // namespace tetfarm
