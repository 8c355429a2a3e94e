#include "mesh/formats/medit/meshb_source.h"

#include <algorithm>
#include <limits>

#include "mesh/formats/listed_mesh.h"
#include "mesh/formats/medit/medit_file.h"

namespace tetfarm {
namespace {

/// What is out of range stays so.
std::int32_t small(std::int64_t reference) {
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(reference, 0, std::numeric_limits<std::int32_t>::max()));
}

std::vector<TetRun> runs_of(const MeditFile& file) {
  constexpr std::int64_t at_once = 65536;
  const std::int64_t tets = file.count(medit::tetrahedra);
  std::vector<TetRun> runs;
  std::vector<std::array<std::int64_t, 5>> records;
  for (std::int64_t first = 0; first < tets; first += at_once) {
    records.resize(static_cast<std::size_t>(std::min(at_once, tets - first)));
    file.read_elements<5>(medit::tetrahedra, first, records);
    for (const auto& tet : records) add_tets(runs, {1, small(tet[4]), 0});
  }
  return runs;
}

std::vector<ListedTriangle> boundary_of(const MeditFile& file) {
  std::vector<std::array<std::int64_t, 4>> records(
      static_cast<std::size_t>(file.count(medit::triangles)));
  file.read_elements<4>(medit::triangles, 0, records);
  std::vector<ListedTriangle> result;
  for (const auto& [a, b, c, patch] : records) {
    result.push_back({{a - 1, b - 1, c - 1}, small(patch) - 1});
  }
  return result;
}

std::vector<ListedQuad> quads_of(const MeditFile& file) {
  std::vector<std::array<std::int64_t, 5>> records(
      static_cast<std::size_t>(file.count(medit::quadrangles)));
  file.read_elements<5>(medit::quadrangles, 0, records);
  std::vector<ListedQuad> result;
  for (const auto& [a, b, c, d, patch] : records) {
    result.push_back({{a - 1, b - 1, c - 1, d - 1}, small(patch) - 1});
  }
  return result;
}

/// The cells of a list that is kept in a block.
ListedCells cells_of(const std::shared_ptr<const MeditFile>& file, ElementType type) {
  const auto list = static_cast<medit::Keyword>(code_of(ElementCodes::medit, type));
  const std::size_t nodes = nodes_of(type);
  ListedCells cells;
  std::vector<std::int64_t> record(nodes + 1);
  for (std::int64_t i = 0; i < file->count(list); ++i) {
    file->read_numbers(list, i, record);
    add_tets(cells.runs, {1, small(record.back()), 0});
  }
  cells.read = [file, list, nodes, type](std::int64_t first, std::span<std::int64_t> into) {
    const std::size_t count = into.size() / nodes;
    std::vector<std::int64_t> records(count * (nodes + 1));
    file->read_numbers(list, first, records);
    for (std::size_t i = 0; i < count; ++i) {
      const auto from = std::span<const std::int64_t>(records).subspan(i * (nodes + 1), nodes);
      take_from_order_of(ElementCodes::medit, type, from, into.subspan(i * nodes, nodes));
    }
    for (std::int64_t& node : into) --node;
  };
  return cells;
}

}  // namespace

std::unique_ptr<MeshSource> open_meshb(const std::filesystem::path& path,
                                       const std::filesystem::path&) {
  const auto file = std::make_shared<const MeditFile>(path);
  ListedMesh mesh;
  mesh.name = file->name();
  mesh.nodes = file->count(medit::vertices);
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_vertices(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    std::vector<std::array<std::int64_t, 5>> records(into.size());
    file->read_elements<5>(medit::tetrahedra, first, records);
    for (std::size_t i = 0; i < into.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) into[i][k] = records[i][k] - 1;
    }
  };
  mesh.runs = runs_of(*file);
  mesh.triangles = boundary_of(*file);
  mesh.quads = quads_of(*file);
  for (const ElementType type : cell_block_types) mesh.cells[type] = cells_of(file, type);
  return open_listed(std::move(mesh));
}

}  // namespace tetfarm
