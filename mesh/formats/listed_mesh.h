/// A mesh whose file has one list of nodes, one of tets and one of boundary triangles, and lists of
/// other elements by type, read part by part: what the readers of such formats have in common.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Consecutive tets, or other cells of one type, of one region and one sub-domain.
struct TetRun {
  std::int64_t tets = 0;
  std::int32_t region = 1;
  std::int32_t subdomain = 0;
};

/// By numbers in the whole mesh; the normal points out of the domain.
struct ListedTriangle {
  std::array<std::int64_t, 3> nodes{};
  std::int32_t patch = 0;
};

struct ListedQuad {
  std::array<std::int64_t, 4> nodes{};
  std::int32_t patch = 0;
};

/// Cells of a type that is kept in blocks.
struct ListedCells {
  std::vector<TetRun> runs;  ///< all of them, one run after the other
  /// Fills the span with the nodes of consecutive cells from `first` on, in our order.
  std::function<void(std::int64_t first, std::span<std::int64_t>)> read;
};

/// Numbers count from 0.
struct ListedMesh {
  using Nodes = std::array<std::int64_t, 4>;

  std::string name;  ///< of the file, for messages
  std::int64_t nodes = 0;
  /// Fills the span with those from `first` on, which the file has. Others may call it at once.
  std::function<void(std::int64_t first, std::span<Vec3>)> read_nodes;
  std::function<void(std::int64_t first, std::span<Nodes>)> read_tets;
  std::vector<TetRun> runs;  ///< all tets, one run after the other
  std::vector<ListedTriangle> triangles;
  ByType<ListedCells> cells;  ///< of the types in blocks
  std::vector<ListedQuad> quads;
  std::vector<std::string> patch_names;
  std::vector<std::string> region_names;
  std::vector<PatchType> patch_types;  ///< as of MeshSource
  bool knows_subdomains = false;
  bool takes_threads = true;
};

/// Appends to the runs: the last grows when it is of the same region and sub-domain.
void add_tets(std::vector<TetRun>& runs, const TetRun& next);

/// Parts are the sub-domains where the file knows them, consecutive runs of each, else pieces of at
/// most `tets_of_piece` tets of one region, and then such pieces of each other type. A boundary
/// face belongs to the part that has it as the face of a cell, turned the same way; those without
/// such a cell are with the last part. The numbers of boundary faces are those of the list. Nodes
/// that no element has are in no part, and complained of. All cells are read once for that. In
/// memory: the boundary faces, two bits a node, one part. @throws InvalidInput when there are no
/// cells, or one or a boundary face has a node that is not there, or a patch or region is out of
/// range; what the functions throw.
std::unique_ptr<MeshSource> open_listed(ListedMesh mesh, std::int64_t tets_of_piece = 1'000'000);

}  // namespace tetfarm
