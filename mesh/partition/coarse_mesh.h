/// The graph of a whole mesh in clusters of cells, made sub-domain by sub-domain, and the faces by
/// which the sub-domains hang together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "mesh/formats/external_sort.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/graph/weighted_graph.h"
#include "mesh/partition/cell_columns.h"

namespace tetfarm {

/// One side of a face between two sub-domains. Sides 2i and 2i + 1 are those of one face.
struct InterfaceSide {
  std::int32_t subdomain = 0;
  std::int32_t column = 0;  ///< there, of cells that stay together
  std::int64_t side = 0;
  bool operator<(const InterfaceSide& other) const {
    return subdomain != other.subdomain ? subdomain < other.subdomain : side < other.side;
  }
};

/// A node of `graph` is a cluster, weighted by its cells; edges are weighted by shared faces.
struct CoarseMesh {
  explicit CoarseMesh(const std::filesystem::path& folder) : sides(folder) {}

  WeightedGraph graph;
  std::vector<std::int32_t> first_cluster;    ///< of each sub-domain
  std::vector<std::int32_t> wanted_clusters;  ///< of each sub-domain, to be made again
  std::vector<std::int32_t> cluster_of_side;  ///< in the graph
  ExternalSort<InterfaceSide> sides;
};

/// What stays together in a sub-domain: the columns of its prisms, or each cell for itself.
CellColumns kept_columns(const NumberedPart& part, const CellFaces& faces, bool keeps_columns);

/// At most about `clusters` of them, at least one a sub-domain; each is of one piece.
/// Reads each sub-domain once. `folder` is for files that are gone afterwards.
/// @throws InvalidInput when a face has three cells; IoError. Memory: one sub-domain, the clusters
/// and their neighbours, 8 bytes for each face between sub-domains. Cost: about 2 µs a cell.
CoarseMesh coarsen(const MeshSource& source, std::int64_t clusters, bool keeps_columns,
                   const std::filesystem::path& folder);

}  // namespace tetfarm
