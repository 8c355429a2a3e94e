#include "mesh/assemble/node_runs.h"

#include <algorithm>
#include <numeric>

namespace tetfarm {

void for_each_node_run(
    const NumberedPart& part,
    const std::function<void(std::int64_t first, const std::vector<Vec3>& nodes)>& visit) {
  std::vector<std::size_t> by_number(part.nodes.size());
  std::iota(by_number.begin(), by_number.end(), std::size_t{0});
  std::sort(by_number.begin(), by_number.end(), [&](std::size_t a, std::size_t b) {
    return part.local2global[a] < part.local2global[b];
  });
  std::vector<Vec3> run;
  std::int64_t first = 0;
  for (const std::size_t v : by_number) {
    const std::int64_t number = part.local2global[v];
    if (number != first + std::ssize(run)) {
      if (!run.empty()) visit(first, run);
      run.clear();
      first = number;
    }
    run.push_back(part.nodes[v]);
  }
  if (!run.empty()) visit(first, run);
}

}  // namespace tetfarm
