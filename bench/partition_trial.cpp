// Parts for a solver, made cluster by cluster, beside those that METIS makes of the whole mesh:
// faces between them, balance, time.
//
//     partition_trial MESH.vtkhdf PARTS... [--no-whole]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "mesh/formats/cell_faces.h"
#include "mesh/graph/metis_partition.h"
#include "mesh/partition/dual_graph.h"
#include "mesh/partition/partitioned_mesh.h"

namespace tetfarm {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// All parts as one, nodes by their numbers in the whole mesh.
NumberedPart whole_mesh(const MeshSource& source) {
  NumberedPart whole;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (Tet tet : part.tets) {
      for (std::int32_t& v : tet) {
        v = static_cast<std::int32_t>(part.local2global[static_cast<std::size_t>(v)]);
      }
      whole.tets.push_back(tet);
    }
  }
  return whole;
}

void print_pieces(const WeightedGraph& graph, const std::vector<std::int32_t>& part_of_tet,
                  const char* what, std::int32_t parts, double seconds) {
  const std::vector<std::int64_t> weights = weights_of_parts(graph, part_of_tet, parts);
  const std::vector<std::int32_t> pieces = pieces_of_parts(graph, part_of_tet);
  std::printf("%-8s %5d parts  %9lld faces  largest/mean %.3f  %d pieces  %.1f s\n", what, parts,
              static_cast<long long>(edge_cut(graph, part_of_tet)),
              static_cast<double>(*std::max_element(weights.begin(), weights.end())) * parts /
                  static_cast<double>(graph.size()),
              *std::max_element(pieces.begin(), pieces.end()) + 1, seconds);
}

int main_of(int count, char** words) {
  const std::unique_ptr<MeshSource> source = open_mesh(words[1]);
  const bool with_whole = std::strcmp(words[count - 1], "--no-whole") != 0;
  WeightedGraph graph;
  if (with_whole) {
    const NumberedPart whole = whole_mesh(*source);
    graph = dual_graph(cell_faces(whole), whole.tets.size());
  }
  for (int i = 2; i < count - (with_whole ? 0 : 1); ++i) {
    const std::int32_t parts = std::atoi(words[i]);
    double begin = seconds_now();
    if (with_whole) {
      MetisOptions options;
      const std::vector<std::int32_t> part_of_tet = metis_partition(graph, parts, options);
      print_pieces(graph, part_of_tet, "METIS", parts, seconds_now() - begin);
    }
    begin = seconds_now();
    const PartitionedMesh mesh(*source, {parts}, std::filesystem::temp_directory_path());
    std::printf("%-8s %5d parts  %9lld faces  largest/mean %.3f  %.1f s\n", "tetfarm", parts,
                static_cast<long long>(mesh.figures().cut_faces),
                mesh.figures().largest_over_mean(), seconds_now() - begin);
  }
  return 0;
}

}  // namespace
}  // namespace tetfarm

int main(int count, char** words) {
  if (count < 3) {
    std::fprintf(stderr, "partition_trial MESH.vtkhdf PARTS... [--no-whole]\n");
    return 2;
  }
  return tetfarm::main_of(count, words);
}
