#include "mesh/formats/ugrid/ugrid_source.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "mesh/formats/listed_mesh.h"
#include "mesh/formats/ugrid/mapbc.h"

namespace tetfarm {
namespace {

constexpr std::int64_t most_regions = 1'000'000;

struct RegionLine {
  std::int64_t number = 1;
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string name;
};

std::vector<RegionLine> regions_beside(const std::filesystem::path& path, std::int64_t cells) {
  std::vector<RegionLine> regions;
  std::ifstream file(path);
  std::string line;
  std::int64_t expected = 1;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    RegionLine region;
    const bool is_whole = static_cast<bool>(words >> region.number >> region.first >> region.last);
    if (!is_whole || region.number < 1 || region.number > most_regions ||
        region.first != expected || region.last + 1 < region.first || region.last > cells) {
      throw InvalidInput("a line does not match the mesh: " + line, path.string());
    }
    std::getline(words >> std::ws, region.name);
    expected = region.last + 1;
    regions.push_back(region);
  }
  if (!regions.empty() && expected != cells + 1) {
    throw InvalidInput("the lines do not cover all cells", path.string());
  }
  return regions;
}

/// A file beside the mesh: NAME.mapbc beside NAME.b8.ugrid.
std::filesystem::path beside(const std::filesystem::path& path, const std::string& ending) {
  return std::filesystem::path(path).replace_extension().replace_extension().string() + ending;
}

void require_right_length(const UgridFile& file) {
  if (file.expected_size() != file.size()) {
    throw InvalidInput("the length of the file does not match its counts", file.name());
  }
}

std::int32_t patch_from(std::int64_t number) {
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(number, 0, std::numeric_limits<std::int32_t>::max()) - 1);
}

/// The boundary of a mesh. Its normals in the file all point into the domain or all out of it.
struct Boundary {
  std::vector<ListedTriangle> triangles;
  std::vector<ListedQuad> quads;
  double volume = 0;  ///< six times what it encloses, with the sign of the file

  void turn_outwards() {
    if (volume >= 0) return;
    for (ListedTriangle& triangle : triangles) std::swap(triangle.nodes[1], triangle.nodes[2]);
    for (ListedQuad& quad : quads) std::swap(quad.nodes[1], quad.nodes[3]);
  }
};

void read_triangles(const UgridFile& file, Boundary& boundary) {
  const std::int64_t nodes = file.counts().nodes;
  const auto count = static_cast<std::size_t>(file.counts().triangles);
  std::vector<std::array<std::int64_t, 3>> corners(count);
  file.read_triangles(0, corners);
  std::vector<std::int64_t> patches(count);
  file.read_patches(0, patches);
  boundary.triangles.resize(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t node = boundary.triangles[t].nodes[k] = corners[t][k] - 1;
      if (node < 0 || node >= nodes) {
        file.fail_at_corner("boundary triangle " + std::to_string(t) + " has node " +
                                std::to_string(node + 1) + " of " + std::to_string(nodes),
                            static_cast<std::int64_t>(t), k);
      }
      file.read_nodes(node, std::span(&p[k], 1));
    }
    boundary.volume += dot(p[0], cross(p[1], p[2]));
    boundary.triangles[t].patch = patch_from(patches[t]);
  }
}

void read_quads(const UgridFile& file, Boundary& boundary) {
  const std::int64_t nodes = file.counts().nodes;
  const auto count = static_cast<std::size_t>(file.counts().quadrangles);
  std::vector<std::int64_t> corners(4 * count);
  file.read_elements(ElementType::quad, 0, corners);
  std::vector<std::int64_t> patches(count);
  file.read_patches(file.counts().triangles, patches);
  boundary.quads.resize(count);
  for (std::size_t q = 0; q < count; ++q) {
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t node = boundary.quads[q].nodes[k] = corners[4 * q + k] - 1;
      if (node < 0 || node >= nodes) {
        file.fail_at_quadrangle("boundary quad " + std::to_string(q) + " has node " +
                                    std::to_string(node + 1) + " of " + std::to_string(nodes),
                                static_cast<std::int64_t>(q));
      }
      file.read_nodes(node, std::span(&p[k], 1));
    }
    boundary.volume += 6 * static_cast<double>(cone_volume({}, p));
    boundary.quads[q].patch = patch_from(patches[q]);
  }
}

Boundary boundary_of(const UgridFile& file) {
  Boundary boundary;
  read_triangles(file, boundary);
  read_quads(file, boundary);
  boundary.turn_outwards();
  return boundary;
}

void read_cells(const UgridFile& file, ElementType type, std::int64_t first,
                std::span<std::int64_t> into) {
  const std::size_t nodes = nodes_of(type);
  std::vector<std::int64_t> theirs(into.size());
  file.read_elements(type, first, theirs);
  for (std::size_t i = 0; i < theirs.size(); i += nodes) {
    take_from_order_of(ElementCodes::ugrid, type,
                       std::span<const std::int64_t>(theirs).subspan(i, nodes),
                       into.subspan(i, nodes));
  }
  for (std::int64_t& node : into) --node;
}

/// Cells of the mesh are counted as the file lists them: tets, then the others. Each type gets its
/// runs of what lines say of all.
void add_runs(const std::vector<RegionLine>& regions, const UgridFile& file, ListedMesh& mesh) {
  std::int64_t first = 1;
  const auto add = [&](std::int64_t count, std::vector<TetRun>& runs) {
    for (const RegionLine& region : regions) {
      const std::int64_t from = std::max(region.first, first);
      const std::int64_t to = std::min(region.last, first + count - 1);
      if (to >= from) add_tets(runs, {to + 1 - from, static_cast<std::int32_t>(region.number), 0});
    }
    first += count;
  };
  add(file.counts().tets, mesh.runs);
  for (const ElementType type : cell_block_types)
    add(file.counts().of(type), mesh.cells[type].runs);
}

}  // namespace

std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path, UgridForm form,
                                       std::int64_t tets_of_piece) {
  const auto file = std::make_shared<const UgridFile>(path, form);
  require_right_length(*file);
  std::int64_t all_cells = file->counts().tets;
  for (const ElementType type : cell_block_types) all_cells += file->counts().of(type);
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
  for (const ElementType type : cell_block_types) {
    mesh.cells[type].read = [file, type](std::int64_t first, std::span<std::int64_t> into) {
      read_cells(*file, type, first, into);
    };
  }
  Boundary boundary = boundary_of(*file);
  mesh.triangles = std::move(boundary.triangles);
  mesh.quads = std::move(boundary.quads);
  Mapbc mapbc = read_mapbc(beside(path, ".mapbc"));
  mesh.patch_names = std::move(mapbc.names);
  mesh.patch_types = std::move(mapbc.types);
  std::vector<RegionLine> regions = regions_beside(beside(path, ".regions"), all_cells);
  if (regions.empty()) regions = {{1, 1, all_cells, "domain"}};
  for (const RegionLine& region : regions) {
    const auto number = static_cast<std::size_t>(region.number);
    mesh.region_names.resize(std::max(mesh.region_names.size(), number));
    mesh.region_names[number - 1] = region.name;
  }
  add_runs(regions, *file, mesh);
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
