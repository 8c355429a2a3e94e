#include "mesh/formats/openfoam/openfoam_source.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/formats/regions_of_faces.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/mesh/formats/read_back.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const mesh_files[] = {"points", "faces", "owner", "neighbour", "boundary", "cellZones"};

GridSource grid_of_two_regions() {
  GridSource grid(cut_grid(4));
  for (const std::size_t part : {1, 2}) grid.parts[part].region = 2;
  return grid;
}

/// The same nodes in the order that is first of those that turn the same way.
template <class Number>
std::array<Number, 4> in_one_order(std::array<Number, 4> tet) {
  bool is_turned = false;
  for (std::size_t end = 3; end > 0; --end) {
    for (std::size_t k = 0; k < end; ++k) {
      if (tet[k + 1] < tet[k]) {
        std::swap(tet[k], tet[k + 1]);
        is_turned = !is_turned;
      }
    }
  }
  if (is_turned) std::swap(tet[2], tet[3]);
  return tet;
}

struct NumberedTet {
  std::array<std::int64_t, 4> nodes;
  std::int32_t region = 1;
  friend bool operator==(const NumberedTet&, const NumberedTet&) = default;
};

/// Of all tets, whatever the order of their nodes.
std::vector<NumberedTet> tets_of(const MeshSource& source) {
  std::vector<NumberedTet> tets;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      std::array<std::int64_t, 4> nodes;
      for (std::size_t k = 0; k < 4; ++k) {
        nodes[k] = part.local2global.at(static_cast<std::size_t>(part.tets[t][k]));
      }
      tets.push_back({in_one_order(nodes), part.region_of(t)});
    }
  }
  return tets;
}

/// Of all tets in their order: the places of their nodes, and their regions.
std::vector<std::pair<std::array<std::array<double, 3>, 4>, std::int32_t>> places_of(
    const MeshSource& source) {
  std::vector<std::pair<std::array<std::array<double, 3>, 4>, std::int32_t>> tets;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      std::array<std::array<double, 3>, 4> tet;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& p = part.nodes.at(static_cast<std::size_t>(part.tets[t][k]));
        tet[k] = {p.x, p.y, p.z};
      }
      tets.emplace_back(in_one_order(tet), part.region_of(t));
    }
  }
  return tets;
}

TEST(OpenfoamSource, a_whole_case_gives_back_cells_nodes_patches_and_regions) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions();
  const auto read = open_mesh(export_as(grid, folder, "openfoam", "case"), folder.path());
  EXPECT_FALSE(read->knows_subdomains());
  EXPECT_EQ(tets_of(*read), tets_of(grid));
  EXPECT_EQ(places_of(*read), places_of(grid));
  EXPECT_EQ(content_of(*read).faces, content_of(grid).faces);
  EXPECT_THAT(read->patch_names(), ElementsAre("low_x", "elsewhere"));
  EXPECT_THAT(read->region_names(), ElementsAre("region_1", "region_2"));
  EXPECT_EQ(outline_of(*read).nodes, grid.nodes);
}

TEST(OpenfoamSource, processors_are_sub_domains_whose_nodes_are_joined_by_the_faces_between) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions();
  const auto read =
      open_mesh(export_as(grid, folder, "openfoam-decomposed", "case"), folder.path());
  EXPECT_TRUE(read->knows_subdomains());
  ASSERT_EQ(read->size(), grid.size());
  EXPECT_EQ(places_of(*read), places_of(grid));
  EXPECT_EQ(content_of(*read).faces, content_of(grid).faces);
  EXPECT_THAT(read->patch_names(), ElementsAre("low_x", "elsewhere"));
  EXPECT_EQ(outline_of(*read).nodes, grid.nodes);
  std::vector<std::int64_t> new_number(static_cast<std::size_t>(grid.nodes), -1);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const NumberedPart part = read->part(i);
    EXPECT_EQ(part.region, grid.parts[i].region);
    ASSERT_EQ(part.nodes, grid.parts[i].nodes);
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      auto& number = new_number[static_cast<std::size_t>(grid.parts[i].local2global[v])];
      if (number < 0) number = part.local2global[v];
      EXPECT_EQ(part.local2global[v], number) << "one node, one number";
    }
  }
}

TEST(OpenfoamSource, parts_of_several_regions_keep_the_region_of_each_cell_and_triangle) {
  GridSource grid(cut_grid(4));
  for (NumberedPart& part : grid.parts) {
    part.region_of_tet.assign(part.tets.size(), 1);
    std::fill(part.region_of_tet.begin() + 9, part.region_of_tet.end(), 2);
    set_regions_of_faces(part);
  }
  for (const char* format : {"openfoam", "openfoam-decomposed"}) {
    const TempFolder folder;
    const auto read = open_mesh(export_as(grid, folder, format, "case"), folder.path());
    EXPECT_EQ(places_of(*read), places_of(grid)) << format;
    EXPECT_EQ(outline_of(*read).tets_of_region, outline_of(grid).tets_of_region) << format;
    if (!read->knows_subdomains()) continue;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      EXPECT_EQ(outline_of(*read).parts[i].faces_of_patch,
                outline_of(grid).parts[i].faces_of_patch);
    }
  }
}

TEST(OpenfoamSource, what_is_read_can_be_exported_and_read_again) {
  const GridSource grid = grid_of_two_regions();
  for (const char* format : {"openfoam", "openfoam-decomposed"}) {
    const TempFolder folder;
    const auto read = open_mesh(export_as(grid, folder, format, "case"), folder.path());
    for (const char* again : {"openfoam", "openfoam-decomposed"}) {
      const auto other = open_mesh(export_as(*read, folder, again, again), folder.path());
      EXPECT_EQ(places_of(*other), places_of(grid)) << format << ", " << again;
    }
  }
}

TEST(OpenfoamSource, a_case_with_both_is_read_whole) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions();
  EXPECT_FALSE(is_openfoam_case(folder.path() / "case"));
  const fs::path file = export_as(grid, folder, "openfoam-decomposed", "case");
  EXPECT_TRUE(is_openfoam_case(file));
  export_as(grid, folder, "openfoam", "case");
  EXPECT_FALSE(open_mesh(file, folder.path())->knows_subdomains());
  EXPECT_FALSE(is_openfoam_case(folder.path()));
}

TEST(OpenfoamSource, files_cut_short_or_missing_are_refused) {
  const GridSource grid = grid_of_two_regions();
  for (const char* format : {"openfoam", "openfoam-decomposed"}) {
    const TempFolder folder;
    const fs::path file = export_as(grid, folder, format, "case");
    const bool is_whole = std::string(format) == "openfoam";
    const fs::path mesh = (is_whole ? file : file / "processor1") / "constant/polyMesh";
    for (const char* name : mesh_files) {
      const std::string bytes = read_file(mesh / name);
      for (const std::size_t sevenths : {0, 1, 2, 3, 4, 5, 6}) {
        const std::size_t length = bytes.size() * sevenths / 7;
        write_file_atomically(mesh / name, std::string_view(bytes).substr(0, length));
        EXPECT_THROW(open_mesh(file, folder.path()), InvalidInput) << name << ' ' << length;
      }
      fs::remove(mesh / name);
      if (std::string(name) != "cellZones") {
        EXPECT_THROW(open_mesh(file, folder.path()), IoError) << name;
      }
      write_file_atomically(mesh / name, bytes);
      EXPECT_NO_THROW(open_mesh(file, folder.path()));
    }
  }
}

const std::string head = "FoamFile { version 2.0; format ascii; class a; object b; }\n";

/// A case of two tets with a face between them, cell 1 above it.
struct TwoTets {
  std::string points = "5\n((0 0 0) (1 0 0) (0 1 0) (0 0 -1) (0 0 1))";
  std::string faces = "7\n(3(0 1 2)\n3(0 3 1)\n3(1 3 2)\n3(2 3 0)\n3(0 1 4)\n3(1 2 4)\n3(2 0 4))";
  std::string owner = "7(0 0 0 0\n1 1 1)";
  std::string neighbour = "1(1)";
  std::string boundary =
      "2(low { type wall; inGroups 1(wall); nFaces 3; startFace 1; }\n"
      "high { type patch; nFaces 3; startFace 4; })";
  std::string zones;

  std::string refusal() const {
    const TempFolder folder;
    const fs::path mesh = folder.path() / "constant/polyMesh";
    make_folders(mesh);
    for (const auto& [name, text] : {std::pair{"points", &points},
                                     {"faces", &faces},
                                     {"owner", &owner},
                                     {"neighbour", &neighbour},
                                     {"boundary", &boundary},
                                     {"cellZones", &zones}}) {
      if (!text->empty()) write_file_atomically(mesh / name, head + *text);
    }
    try {
      const auto read = open_mesh(folder.path(), folder.path());
      EXPECT_EQ(content_of(*read).tets.size(), 2u);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  }
};

TEST(OpenfoamSource, cells_of_no_known_type_are_refused_with_their_number) {
  EXPECT_EQ(TwoTets().refusal(), "");
  TwoTets mesh;
  mesh.faces = changed(mesh.faces, "3(2 0 4)", "4(2 0 4 1)");
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("cell 1 is no tet, pyramid, prism or hex: it has 3 triangles and 1 quad"));
  mesh = {};
  mesh.owner = "7(0 0 0 0 1 1 0)";
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("cell 0 is no tet, pyramid, prism or hex: it has 5 triangles and 0 quads"));
  mesh = {};
  mesh.faces = changed(mesh.faces, "3(2 0 4)", "3(0 2 4)");
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("cell 1 is no tet, pyramid, prism or hex: its faces do not close"));
  mesh = {};
  mesh.faces = changed(mesh.faces, "3(2 0 4)", "3(1 2 4)");
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("cell 1 is no tet, pyramid, prism or hex: its faces do not close"));
  mesh = {};
  mesh.faces = changed(mesh.faces, "3(2 0 4)", "3(2 0 3)");
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("cell 1 is no tet, pyramid, prism or hex: its faces do not close"));
  mesh = {};
  mesh.owner = "7(0 0 0 0 2 2 2)";
  mesh.neighbour = "1(2)";
  EXPECT_THAT(mesh.refusal(), HasSubstr("cell 1 has no faces, but cell 2 does"));
  mesh = {};
  mesh.owner = "7(0 0 0 0 1 1 2147483647)";
  EXPECT_THAT(mesh.refusal(), HasSubstr("owner:2: "));
}

TEST(OpenfoamSource, faces_patches_and_nodes_that_do_not_fit_are_refused) {
  TwoTets mesh;
  mesh.faces = changed(mesh.faces, "3(2 0 4)", "3(2 0 5)");
  EXPECT_THAT(mesh.refusal(), HasSubstr("faces:9: the number 5 is not below 5"));
  mesh = {};
  mesh.owner = "6(0 0 0 0 1 1)";
  EXPECT_THAT(mesh.refusal(), HasSubstr("owner:2: the number of owners is not that of the faces"));
  mesh = {};
  mesh.neighbour = "9(1 1 1 1 1 1 1 1 1)";
  EXPECT_THAT(mesh.refusal(), HasSubstr("more neighbours than faces"));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "startFace 4", "startFace 5");
  EXPECT_THAT(mesh.refusal(), HasSubstr("\"high\" begins with face 5, not 4"));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "nFaces 3; startFace 4", "nFaces 2; startFace 4");
  EXPECT_THAT(mesh.refusal(), HasSubstr("the patches end at face 6 of 7"));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "nFaces 3; startFace 4;", "nFaces 3;");
  EXPECT_THAT(mesh.refusal(), HasSubstr("boundary:3: the patch \"high\" has no nFaces"));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "nFaces 3", "nFaces -3");
  EXPECT_THAT(mesh.refusal(), HasSubstr("boundary:2: "));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "type patch", "type processor");
  EXPECT_THAT(mesh.refusal(), HasSubstr("has no myProcNo"));
  mesh.boundary = changed(mesh.boundary, "processor;", "processor; myProcNo 0; neighbProcNo 1;");
  EXPECT_THAT(mesh.refusal(), HasSubstr("is one processor of a decomposed case"));
  mesh.boundary = changed(mesh.boundary, "neighbProcNo 1;", "");
  EXPECT_THAT(mesh.refusal(),
              HasSubstr("boundary:3: the patch \"high\" has no myProcNo or no neighbProcNo"));
  mesh = {};
  mesh.boundary = changed(mesh.boundary, "type patch", "myProcNo 0; neighbProcNo 1; type patch");
  EXPECT_EQ(mesh.refusal(), "") << "of a patch that is none between processors";
}

TEST(OpenfoamSource, each_cell_is_in_one_zone_if_there_are_any) {
  const auto refusal_with = [](const std::string& first, const std::string& second) {
    TwoTets mesh;
    mesh.zones = "2(one { type cellZone; cellLabels List<label> " + first +
                 "; } two { type cellZone; cellLabels List<label> " + second + "; })";
    return mesh.refusal();
  };
  EXPECT_EQ(refusal_with("1(1)", "1(0)"), "");
  EXPECT_EQ(refusal_with("0()", "2(1 0)"), "");
  EXPECT_THAT(refusal_with("1(0)", "0()"), HasSubstr("cell 1 is in no cell zone"));
  EXPECT_THAT(refusal_with("2(0 1)", "1(1)"), HasSubstr("cell 1 is in two cell zones"));
  EXPECT_THAT(refusal_with("2(0 1)", "1(2)"),
              HasSubstr("cell 2 is in a cell zone, but does not exist"));
  EXPECT_THAT(refusal_with("1(0)", "1(-1)"), HasSubstr("cellZones:2: "));
}

TEST(OpenfoamSource, processors_with_other_patches_than_the_first_are_refused) {
  const TempFolder folder;
  const fs::path file = export_as(grid_of_two_regions(), folder, "openfoam-decomposed", "case");
  const fs::path boundary = file / "processor2/constant/polyMesh/boundary";
  write_file_atomically(boundary, changed(read_file(boundary), "low_x", "high_x"));
  try {
    open_mesh(file, folder.path());
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("processor2/constant/polyMesh: has different patches"));
  }
  write_file_atomically(boundary, changed(read_file(boundary), "high_x", "low_x"));
  EXPECT_NO_THROW(open_mesh(file, folder.path()));
  const fs::path zones = file / "processor2/constant/polyMesh/cellZones";
  const std::string zone = open_mesh(file, folder.path())->region_names().at(0);
  write_file_atomically(zones, changed(read_file(zones), zone, "another"));
  EXPECT_THROW(open_mesh(file, folder.path()), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
