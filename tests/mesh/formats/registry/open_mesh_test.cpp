#include "mesh/formats/registry/open_mesh.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/list/format_by_ending.h"
#include "mesh/formats/regions_of_faces.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

bool is_read(const Format& format) { return format.open_mesh != nullptr; }

/// The formats of files that can be read back.
std::vector<Format> formats_read_back() {
  std::vector<Format> formats;
  for (const Format& format : written_formats()) {
    if (format_by_ending(written_formats(), format.written_ending(), is_read) != nullptr) {
      formats.push_back(format);
    }
  }
  return formats;
}

/// The file to open: the first of the parts where each part has its own.
fs::path exported(const MeshSource& source, const TempFolder& folder, const Format& format) {
  const std::string ending(format.written_ending());
  const fs::path whole = folder.path() / ("a" + ending);
  export_mesh(source, format, whole);
  return fs::exists(whole) ? whole : folder.path() / ("a_1" + ending);
}

GridSource grid_of_two_regions() {
  GridSource grid(cut_grid(4));
  for (const std::size_t part : {1, 2}) grid.parts[part].region = 2;
  return grid;
}

/// Of all tets by number: nodes and region.
std::vector<std::array<std::int64_t, 5>> tets_of(const MeshSource& source) {
  std::vector<std::array<std::int64_t, 5>> tets;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      auto& tet = tets.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        tet[k] = part.local2global[static_cast<std::size_t>(part.tets[t][k])];
      }
      tet[4] = part.region_of(t);
    }
  }
  return tets;
}

TEST(OpenMesh, most_formats_are_read_back) { EXPECT_GE(formats_read_back().size(), 15U); }

TEST(OpenMesh, every_format_gives_back_the_mesh_that_was_exported_bit_for_bit) {
  const GridSource grid = grid_of_two_regions();
  for (const Format& as : formats_read_back()) {
    SCOPED_TRACE(as.name);
    const TempFolder folder;
    const auto read = open_mesh(exported(grid, folder, as), folder.path());
    EXPECT_EQ(content_of(*read), content_of(grid));
    auto wanted = tets_of(grid);
    if (!as.has_regions) {
      for (auto& tet : wanted) tet[4] = 1;
    }
    EXPECT_EQ(tets_of(*read), wanted);
    EXPECT_EQ(read->patch_names().size(), as.has_patch_names ? 2U : 0U);
    EXPECT_EQ(outline_of(*read).nodes, grid.nodes);
    if (read->knows_subdomains()) {
      ASSERT_EQ(read->size(), grid.size());
      for (std::size_t i = 0; i < grid.size(); ++i) {
        EXPECT_EQ(read->part(i).tets.size(), grid.parts[i].tets.size());
        EXPECT_EQ(read->part(i).region, grid.parts[i].region);
      }
    }
  }
}

TEST(OpenMesh, parts_of_several_regions_keep_the_region_of_each_tet_and_triangle) {
  GridSource grid(cut_grid(4));
  for (NumberedPart& part : grid.parts) {
    part.region_of_tet.assign(part.tets.size(), 1);
    std::fill(part.region_of_tet.begin() + 9, part.region_of_tet.end(), 2);
    set_regions_of_faces(part);
  }
  for (const Format& as : formats_read_back()) {
    if (!as.has_regions) continue;
    SCOPED_TRACE(as.name);
    const TempFolder folder;
    const auto read = open_mesh(exported(grid, folder, as), folder.path());
    EXPECT_EQ(content_of(*read), content_of(grid));
    EXPECT_EQ(tets_of(*read), tets_of(grid));
  }
}

TEST(OpenMesh, a_file_cut_short_anywhere_is_refused) {
  const GridSource grid = grid_of_two_regions();
  for (const Format& as : formats_read_back()) {
    const TempFolder folder;
    const fs::path file = exported(grid, folder, as);
    const std::string bytes = read_file(file);
    for (const std::size_t sevenths : {0, 1, 2, 3, 4, 5, 6}) {
      const std::size_t length = bytes.size() * sevenths / 7;
      write_file_atomically(file, std::string_view(bytes).substr(0, length));
      EXPECT_THROW(open_mesh(file, folder.path()), InvalidInput) << as.name << ' ' << length;
    }
  }
}

TEST(OpenMesh, what_is_no_mesh_by_its_ending_is_refused_with_those_that_are) {
  try {
    open_mesh("wing.stl");
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(".b8l.ugrid"), std::string::npos);
  }
  EXPECT_THROW(open_mesh("/nowhere/a.vtkhdf"), IoError);
  for (const Format& as : formats_read_back()) {
    EXPECT_THROW(open_mesh("/nowhere/a" + std::string(as.written_ending())), IoError) << as.name;
  }
}

TEST(OpenMesh, names_the_folders_too_that_it_reads) {
  EXPECT_NE(readable_meshes().find("OpenFOAM cases"), std::string::npos);
  EXPECT_NE(readable_meshes().find(".vtkhdf"), std::string::npos);
}

}  // namespace
}  // namespace tetfarm
