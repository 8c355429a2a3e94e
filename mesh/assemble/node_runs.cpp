#include "mesh/assemble/node_runs.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Nodes of a part that follow one another in the part and in the whole mesh: most of what is
/// inside a sub-domain is one, so that stretches are fewer than nodes by far.
struct Stretch {
  std::int64_t number = 0;  ///< of the first, in the whole mesh
  std::size_t first = 0;    ///< in the part
  std::size_t count = 0;
};

std::vector<Stretch> stretches_by_number(const std::vector<std::int64_t>& numbers) {
  std::vector<Stretch> stretches;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (v == 0 || numbers[v] != numbers[v - 1] + 1) stretches.push_back({numbers[v], v, 0});
    ++stretches.back().count;
  }
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.number < b.number; });
  return stretches;
}

}  // namespace

void for_each_node_run(
    const NumberedPart& part,
    const std::function<void(std::int64_t first, const std::vector<Vec3>& nodes)>& visit) {
  TF_CHECK(part.local2global.size() == part.nodes.size());
  std::vector<Vec3> run;
  std::int64_t first = 0;
  for (const Stretch& stretch : stretches_by_number(part.local2global)) {
    if (stretch.number != first + std::ssize(run)) {
      if (!run.empty()) visit(first, run);
      run.clear();
      first = stretch.number;
    }
    const auto begin = part.nodes.begin() + static_cast<std::ptrdiff_t>(stretch.first);
    run.insert(run.end(), begin, begin + static_cast<std::ptrdiff_t>(stretch.count));
  }
  if (!run.empty()) visit(first, run);
}

}  // namespace tetfarm
