#include "mesh/formats/ugrid/ugrid_source.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "mesh/formats/listed_mesh.h"

namespace tetfarm {
namespace {

constexpr std::int64_t most_regions = 1'000'000;

struct RegionLine {
  std::int64_t number = 1;
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string name;
};

std::vector<std::string> names_of_mapbc(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    long number = 0;
    long code = 0;
    std::string name;
    if (words >> number >> code && std::getline(words >> std::ws, name)) names.push_back(name);
  }
  return names;
}

std::vector<RegionLine> regions_beside(const std::filesystem::path& path, std::int64_t tets) {
  std::vector<RegionLine> regions;
  std::ifstream file(path);
  std::string line;
  std::int64_t expected = 1;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    RegionLine region;
    const bool is_whole = static_cast<bool>(words >> region.number >> region.first >> region.last);
    if (!is_whole || region.number < 1 || region.number > most_regions ||
        region.first != expected || region.last + 1 < region.first || region.last > tets) {
      throw InvalidInput("a line does not match the mesh: " + line, path.string());
    }
    std::getline(words >> std::ws, region.name);
    expected = region.last + 1;
    regions.push_back(region);
  }
  if (!regions.empty() && expected != tets + 1) {
    throw InvalidInput("the lines do not cover all tets", path.string());
  }
  return regions;
}

/// A file beside the mesh: NAME.mapbc beside NAME.b8.ugrid.
std::filesystem::path beside(const std::filesystem::path& path, const std::string& ending) {
  return std::filesystem::path(path).replace_extension().replace_extension().string() + ending;
}

void require_tets_alone(const UgridFile& file) {
  const UgridListCounts& counts = file.counts();
  if (counts.quadrangles + counts.pyramids + counts.prisms + counts.hexahedra != 0) {
    file.fail_at_counts("has elements other than triangles and tets");
  }
  if (file.expected_size() != file.size()) {
    throw InvalidInput("the length of the file does not match its counts", file.name());
  }
}

/// Normals in the file all point into the domain or all out of it.
std::vector<ListedTriangle> boundary_of(const UgridFile& file) {
  const std::int64_t nodes = file.counts().nodes;
  const auto count = static_cast<std::size_t>(file.counts().triangles);
  std::vector<std::array<std::int64_t, 3>> corners(count);
  file.read_triangles(0, corners);
  std::vector<std::int64_t> patches(count);
  file.read_patches(0, patches);
  std::vector<ListedTriangle> boundary(count);
  double volume = 0;
  for (std::size_t t = 0; t < count; ++t) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t node = boundary[t].nodes[k] = corners[t][k] - 1;
      if (node < 0 || node >= nodes) {
        file.fail_at_corner("boundary triangle " + std::to_string(t) + " has node " +
                                std::to_string(node + 1) + " of " + std::to_string(nodes),
                            static_cast<std::int64_t>(t), k);
      }
      file.read_nodes(node, std::span(&p[k], 1));
    }
    volume += dot(p[0], cross(p[1], p[2]));
    boundary[t].patch = static_cast<std::int32_t>(
        std::clamp<std::int64_t>(patches[t], 0, std::numeric_limits<std::int32_t>::max()) - 1);
  }
  for (ListedTriangle& triangle : boundary) {
    if (volume < 0) std::swap(triangle.nodes[1], triangle.nodes[2]);
  }
  return boundary;
}

}  // namespace

std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path, UgridForm form,
                                       std::int64_t tets_of_piece) {
  const auto file = std::make_shared<const UgridFile>(path, form);
  require_tets_alone(*file);
  const std::int64_t tets = file->counts().tets;
  ListedMesh mesh;
  mesh.name = file->name();
  mesh.nodes = file->counts().nodes;
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_nodes(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    file->read_tets(first, into);
    for (ListedMesh::Nodes& tet : into) {
      for (std::int64_t& node : tet) --node;
    }
  };
  mesh.triangles = boundary_of(*file);
  mesh.patch_names = names_of_mapbc(beside(path, ".mapbc"));
  std::vector<RegionLine> regions = regions_beside(beside(path, ".regions"), tets);
  if (regions.empty()) regions = {{1, 1, tets, "domain"}};
  for (const RegionLine& region : regions) {
    const auto number = static_cast<std::size_t>(region.number);
    mesh.region_names.resize(std::max(mesh.region_names.size(), number));
    mesh.region_names[number - 1] = region.name;
    add_tets(mesh.runs, {region.last + 1 - region.first, static_cast<std::int32_t>(number), 0});
  }
  return open_listed(std::move(mesh), tets_of_piece);
}

template <bool big_endian, bool wide>
std::unique_ptr<MeshSource> open_ugrid_as(const std::filesystem::path& path,
                                          const std::filesystem::path&) {
  return open_ugrid(path, {big_endian, wide});
}

template std::unique_ptr<MeshSource> open_ugrid_as<false, false>(const std::filesystem::path&,
                                                                 const std::filesystem::path&);
template std::unique_ptr<MeshSource> open_ugrid_as<false, true>(const std::filesystem::path&,
                                                                const std::filesystem::path&);
template std::unique_ptr<MeshSource> open_ugrid_as<true, false>(const std::filesystem::path&,
                                                                const std::filesystem::path&);
template std::unique_ptr<MeshSource> open_ugrid_as<true, true>(const std::filesystem::path&,
                                                               const std::filesystem::path&);

}  // namespace tetfarm
