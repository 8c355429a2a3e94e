#include "mesh/partition/partitioned_mesh.h"

#include <algorithm>
#include <numeric>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/formats/cell_faces.h"
#include "mesh/graph/graph_coarsening.h"
#include "mesh/graph/metis_partition.h"
#include "mesh/graph/part_refinement.h"
#include "mesh/partition/coarse_mesh.h"
#include "mesh/partition/dual_graph.h"

namespace tetfarm {
namespace {

/// METIS is to stay well below what is promised (1.03), so that cells near borders can move.
constexpr std::int32_t imbalance_in_thousandths = 25;
constexpr double most_over_mean = 1.028;
constexpr std::int64_t least_clusters_of_part = 64;
/// The coarse graph is small beside the mesh: METIS may try it more than once.
constexpr std::int32_t trials = 8;
/// Halving again and again is sometimes better for few parts, and dear for many.
constexpr std::int32_t most_parts_by_halves = 16;
constexpr std::int64_t most_weight = std::int64_t{1} << 30;
constexpr int coarse_passes = 30;
constexpr int fine_passes = 8;

std::int64_t heaviest_part(std::int64_t cells, std::int32_t parts) {
  const std::int64_t mean_or_more = (cells + parts - 1) / parts;
  return std::max(mean_or_more,
                  static_cast<std::int64_t>(most_over_mean * static_cast<double>(cells) / parts));
}

/// METIS adds up weights in 32 bits.
WeightedGraph with_small_weights(WeightedGraph graph, std::int64_t cells) {
  const auto unit = static_cast<std::int32_t>(1 + cells / most_weight);
  if (unit == 1) return graph;
  for (std::int32_t& weight : graph.weight) weight = (weight + unit - 1) / unit;
  return graph;
}

/// METIS's answer, mended.
std::vector<std::int32_t> partition_by(const MetisOptions& options, const WeightedGraph& graph,
                                       std::int32_t parts, std::int64_t cells) {
  std::vector<std::int32_t> part_of_cluster =
      metis_partition(with_small_weights(graph, cells), parts, options);
  join_pieces(graph, parts, part_of_cluster);
  std::vector<std::int64_t> weights = weights_of_parts(graph, part_of_cluster, parts);
  refine_parts(graph, graph.size(), {heaviest_part(cells, parts), coarse_passes}, part_of_cluster,
               weights);
  return part_of_cluster;
}

/// What METIS is asked for. Neither is always the better one.
std::vector<MetisOptions> ways_to_try(std::int32_t parts) {
  MetisOptions options;
  options.imbalance_in_thousandths = imbalance_in_thousandths;
  options.trials = trials;
  options.contiguous = true;
  std::vector<MetisOptions> ways = {options};
  if (parts <= most_parts_by_halves) {
    ways.push_back(options);
    ways.back().method = MetisOptions::Method::recursive;
    ways.back().contiguous = false;
    // Of few parts METIS's answers differ most, by a quarter.
    for (const std::int32_t seed : {21, 22}) {
      ways.push_back(options);
      ways.back().seed = seed;
    }
  }
  return ways;
}

/// The shortest cut of those that are even, if one is.
std::vector<std::int32_t> partition_clusters(const WeightedGraph& graph, std::int32_t parts,
                                             std::int64_t cells) {
  std::vector<std::int32_t> best;
  std::pair<std::int64_t, std::int64_t> least;  // how much too heavy, how many faces
  for (const MetisOptions& options : ways_to_try(parts)) {
    std::vector<std::int32_t> found = partition_by(options, graph, parts, cells);
    const std::vector<std::int64_t> weights = weights_of_parts(graph, found, parts);
    const std::int64_t heaviest = *std::max_element(weights.begin(), weights.end());
    const std::pair score(std::max<std::int64_t>(0, heaviest - heaviest_part(cells, parts)),
                          edge_cut(graph, found));
    if (!best.empty() && least <= score) continue;
    best = std::move(found);
    least = score;
  }
  return best;
}

/// Takes the clusters apart again: one sub-domain after the other, with the parts of the cells on
/// the other side of its cuts as they are at that time.
class FinePartition {
 public:
  FinePartition(CoarseMesh coarse, std::int32_t parts, bool keeps_columns)
      : coarse_(std::move(coarse)), keeps_columns_(keeps_columns), weights_(at(parts)) {
    const std::vector<std::int32_t>& sizes = coarse_.graph.weight;
    const std::int64_t cells = std::accumulate(sizes.begin(), sizes.end(), std::int64_t{0});
    if (cells < parts) {
      throw UsageError("the mesh has only " + std::to_string(cells) + " elements",
                       "--partitions " + std::to_string(parts));
    }
    if (coarse_.graph.size() < at(parts)) {
      throw UsageError("the columns of prisms, which stay whole, are only " +
                           std::to_string(coarse_.graph.size()) +
                           "; with --keep-columns no they may be divided",
                       "--partitions " + std::to_string(parts));
    }
    heaviest_ = heaviest_part(cells, parts);
    coarse_.graph = tie_pieces(std::move(coarse_.graph));
    part_of_cluster_ = partition_clusters(coarse_.graph, parts, cells);
    weights_ = weights_of_parts(coarse_.graph, part_of_cluster_, parts);
    for (const std::int32_t cluster : coarse_.cluster_of_side) {
      part_of_side_.push_back(part_of_cluster_[at(cluster)]);
    }
  }

  /// The parts of the cells of the next sub-domain.
  std::vector<std::int32_t> next_subdomain(const NumberedPart& subdomain) {
    const std::vector<InterfaceSide> sides = coarse_.sides.take_while(
        [this](const InterfaceSide& side) { return side.subdomain == next_; });
    std::vector<std::int32_t> beyond;
    for (const InterfaceSide& side : sides) beyond.push_back(side.column);
    const CellFaces faces = cell_faces(subdomain);
    const CellColumns columns = kept_columns(subdomain, faces, keeps_columns_);
    std::vector<GraphLevel> levels =
        coarsen_graph(dual_graph(faces, columns, beyond), columns.sizes.size(),
                      at(coarse_.wanted_clusters[at(next_)]));
    std::vector<std::int32_t> part_of_node = parts_of_clusters(levels.back().movable);
    for (const InterfaceSide& side : sides) part_of_node.push_back(part_of_side_[other(side)]);
    while (true) {
      const GraphLevel& level = levels.back();
      refine_parts(level.graph, level.movable, {heaviest_, fine_passes}, part_of_node, weights_);
      if (levels.size() == 1) break;
      std::vector<std::int32_t> finer;
      finer.reserve(level.coarse_of.size());
      for (const std::int32_t coarse : level.coarse_of) finer.push_back(part_of_node[at(coarse)]);
      part_of_node = std::move(finer);
      levels.pop_back();
    }
    settle(sides, levels.front(), part_of_node);
    ++next_;
    std::vector<std::int32_t> part_of_cell;
    for (const std::int32_t column : columns.column_of_cell) {
      part_of_cell.push_back(part_of_node[at(column)]);
    }
    return part_of_cell;
  }

  PartitionFigures figures() const {
    PartitionFigures figures{weights_, cut_faces_};
    for (std::size_t side = 0; side < part_of_side_.size(); side += 2) {
      figures.cut_faces += part_of_side_[side] != part_of_side_[side + 1] ? 1 : 0;
    }
    return figures;
  }

 private:
  std::vector<std::int32_t> parts_of_clusters(std::size_t clusters) const {
    const auto first = part_of_cluster_.begin() + coarse_.first_cluster[at(next_)];
    return {first, first + static_cast<std::ptrdiff_t>(clusters)};
  }

  static std::size_t other(const InterfaceSide& side) {
    return static_cast<std::size_t>(side.side ^ 1);
  }

  /// Tells the neighbours; faces between sub-domains are counted when all is done.
  void settle(const std::vector<InterfaceSide>& sides, const GraphLevel& cells,
              std::vector<std::int32_t>& part_of_node) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::int32_t part = part_of_node[at(sides[i].column)];
      part_of_side_[static_cast<std::size_t>(sides[i].side)] = part;
      part_of_node[cells.movable + i] = part;
    }
    cut_faces_ += edge_cut(cells.graph, part_of_node);
    part_of_node.resize(cells.movable);
  }

  CoarseMesh coarse_;
  bool keeps_columns_;
  std::int64_t heaviest_ = 0;
  std::vector<std::int32_t> part_of_cluster_;
  std::vector<std::int32_t> part_of_side_;
  std::vector<std::int64_t> weights_;
  std::int32_t next_ = 0;
  std::int64_t cut_faces_ = 0;
};

}  // namespace

double PartitionFigures::largest_over_mean() const {
  const std::int64_t sum = std::accumulate(cells.begin(), cells.end(), std::int64_t{0});
  return sum == 0 ? 1
                  : static_cast<double>(*std::max_element(cells.begin(), cells.end())) *
                        static_cast<double>(cells.size()) / static_cast<double>(sum);
}

PartitionedMesh::PartitionedMesh(const MeshSource& source, const PartitionOptions& options,
                                 const std::filesystem::path& folder)
    : pieces_(options.parts, folder),
      cell_marks_(source.cell_marks()),
      has_feet_(source.has_feet()),
      patch_names_(source.patch_names()),
      patch_types_(source.patch_types()),
      region_names_(source.region_names()) {
  const std::int64_t clusters = std::max(options.clusters, least_clusters_of_part * options.parts);
  FinePartition fine(coarsen(source, clusters, options.keeps_columns, folder), options.parts,
                     options.keeps_columns);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart subdomain = source.part(i);
    pieces_.add(subdomain, fine.next_subdomain(subdomain));
  }
  figures_ = fine.figures();
}

}  // namespace tetfarm
