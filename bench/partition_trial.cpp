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

#include "mesh/formats/registry/open_mesh.h"
#include "mesh/graph/metis_partition.h"
#include "mesh/partition/partitioned_mesh.h"
#include "tests/support/whole_dual_graph.h"

namespace tetfarm {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
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
  if (with_whole) graph = test::whole_dual_graph(*source);
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
