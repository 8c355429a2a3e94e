#include "mesh/formats/openfoam/write_openfoam.h"

#include <gmock/gmock.h>

#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

struct PolyMesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::int64_t, 3>> faces;
  std::vector<std::int64_t> owner;
  std::vector<std::int64_t> neighbour;
  std::string boundary;
};

std::string without_brackets(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  return text;
}

/// The numbers of a list, behind its count.
FileNumbers list(const std::filesystem::path& file, std::int64_t& count) {
  FileNumbers numbers(without_brackets(read_file(file)), true);
  numbers.skip_past("object      " + file.filename().string() + ";\n}\n");
  count = numbers.large();
  return numbers;
}

PolyMesh read_poly_mesh(const std::filesystem::path& folder) {
  PolyMesh mesh;
  std::int64_t count = 0;
  FileNumbers points = list(folder / "points", count);
  for (; count > 0; --count) mesh.points.push_back(points.point());
  FileNumbers faces = list(folder / "faces", count);
  for (; count > 0; --count) {
    EXPECT_EQ(faces.large() % 10, 3);
    mesh.faces.push_back(faces.larges<3>());
  }
  FileNumbers owner = list(folder / "owner", count);
  for (; count > 0; --count) mesh.owner.push_back(owner.large());
  FileNumbers neighbour = list(folder / "neighbour", count);
  for (; count > 0; --count) mesh.neighbour.push_back(neighbour.large());
  mesh.boundary = read_file(folder / "boundary");
  return mesh;
}

/// The volume of each cell, from its faces: they are those of one tet when all fit.
std::vector<double> cell_volumes(const PolyMesh& mesh) {
  std::vector<double> volumes(
      static_cast<std::size_t>(*std::max_element(mesh.owner.begin(), mesh.owner.end())) + 1);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto p = [&](std::size_t k) {
      return mesh.points.at(static_cast<std::size_t>(mesh.faces[f][k]));
    };
    const double cone = dot(p(0), cross(p(1), p(2))) / 6;
    volumes.at(static_cast<std::size_t>(mesh.owner[f])) += cone;
    if (f < mesh.neighbour.size()) {
      volumes.at(static_cast<std::size_t>(mesh.neighbour[f])) -= cone;
    }
  }
  return volumes;
}

TEST(WriteOpenfoam, cells_are_the_tets_and_faces_in_upper_triangular_order) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  export_as(grid, folder, "openfoam", "case");
  const PolyMesh mesh = read_poly_mesh(folder.path() / "case/constant/polyMesh");
  EXPECT_EQ(mesh.points.size(), 125u);
  EXPECT_EQ(mesh.faces.size() - mesh.neighbour.size(), 192u);
  const std::vector<double> volumes = cell_volumes(mesh);
  ASSERT_EQ(volumes.size(), 384u);
  for (const double volume : volumes) EXPECT_NEAR(volume, 1.0 / 384, 1e-12);
  for (std::size_t f = 0; f < mesh.neighbour.size(); ++f) {
    ASSERT_LT(mesh.owner[f], mesh.neighbour[f]);
    if (f > 0) {
      ASSERT_LT(std::pair(mesh.owner[f - 1], mesh.neighbour[f - 1]),
                std::pair(mesh.owner[f], mesh.neighbour[f]));
    }
  }
  EXPECT_THAT(mesh.boundary, testing::HasSubstr("low_x"));
  EXPECT_THAT(mesh.boundary, testing::HasSubstr("nFaces          160"));
}

/// A number of a patch, behind its name.
std::int64_t number_of(const std::string& boundary, const std::string& patch,
                       const std::string& what) {
  FileNumbers numbers(boundary, true);
  numbers.skip_past(patch + "\n");
  numbers.skip_past(what);
  std::string digits = boundary.substr(static_cast<std::size_t>(numbers.place()), 25);
  return std::stoll(digits);
}

TEST(WriteOpenfoam, processors_have_the_same_faces_between_them_turned_round) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  export_as(grid, folder, "openfoam-decomposed", "case");
  std::vector<PolyMesh> meshes;
  double volume = 0;
  for (int i = 0; i < 3; ++i) {
    meshes.push_back(read_poly_mesh(folder.path() / "case" / ("processor" + std::to_string(i)) /
                                    "constant/polyMesh"));
    for (const double cell : cell_volumes(meshes.back())) volume += cell;
  }
  EXPECT_NEAR(volume, 1, 1e-12);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    const PolyMesh& here = meshes[static_cast<std::size_t>(a)];
    const PolyMesh& there = meshes[static_cast<std::size_t>(b)];
    const auto named = [](int from, int to) {
      return "procBoundary" + std::to_string(from) + "to" + std::to_string(to);
    };
    const std::int64_t faces = number_of(here.boundary, named(a, b), "nFaces");
    ASSERT_EQ(faces, number_of(there.boundary, named(b, a), "nFaces"));
    const std::int64_t first = number_of(here.boundary, named(a, b), "startFace");
    const std::int64_t back = number_of(there.boundary, named(b, a), "startFace");
    for (std::int64_t i = 0; i < faces; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t mine = here.faces[static_cast<std::size_t>(first + i)][k];
        const std::int64_t theirs = there.faces[static_cast<std::size_t>(back + i)][(3 - k) % 3];
        EXPECT_EQ(here.points[static_cast<std::size_t>(mine)],
                  there.points[static_cast<std::size_t>(theirs)]);
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
