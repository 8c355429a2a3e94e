#include "mesh/inspect/shell_orientation.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

struct Neighbour {
  std::int32_t triangle = -1;
  bool agrees = true;
};

/// Up to three neighbours a triangle, over the edges with exactly two uses.
std::vector<std::array<Neighbour, 3>> neighbours_of(std::size_t triangles,
                                                    std::span<const EdgeUse> uses) {
  std::vector<std::array<Neighbour, 3>> neighbours(triangles);
  const auto add = [&neighbours](std::int32_t of, const Neighbour& neighbour) {
    for (Neighbour& slot : neighbours[static_cast<std::size_t>(of)]) {
      if (slot.triangle >= 0) continue;
      slot = neighbour;
      return;
    }
  };
  for_each_edge(uses, [&add](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    add(edge[0].triangle, {edge[1].triangle, agrees});
    add(edge[1].triangle, {edge[0].triangle, agrees});
  });
  return neighbours;
}

}  // namespace

ShellOrientation orient_shells(const SurfaceMesh& surface, std::span<const EdgeUse> uses,
                               const std::vector<char>& sieve) {
  const std::size_t n = surface.triangles.size();
  TF_CHECK(sieve.size() == n);
  const auto neighbours = neighbours_of(n, uses);
  ShellOrientation result;
  result.triangle2shell.assign(n, -1);
  result.turn.assign(n, 0);
  std::vector<std::int32_t> torn;
  for (std::size_t start = 0; start < n; ++start) {
    if (sieve[start] == 0 || result.triangle2shell[start] >= 0) continue;
    const auto shell = static_cast<std::int32_t>(result.shells.size());
    std::vector<std::int32_t> front{static_cast<std::int32_t>(start)};
    result.triangle2shell[start] = shell;
    for (std::size_t i = 0; i < front.size(); ++i) {
      const auto t = static_cast<std::size_t>(front[i]);
      for (const Neighbour& neighbour : neighbours[t]) {
        if (neighbour.triangle < 0) continue;
        const auto u = static_cast<std::size_t>(neighbour.triangle);
        const char turn = neighbour.agrees ? result.turn[t] : static_cast<char>(1 - result.turn[t]);
        if (result.triangle2shell[u] < 0) {
          result.triangle2shell[u] = shell;
          result.turn[u] = turn;
          front.push_back(neighbour.triangle);
        } else if (result.turn[u] != turn) {
          torn.push_back(front[i]);
        }
      }
    }
    std::ranges::sort(front);
    result.shells.push_back(std::move(front));
  }
  if (!torn.empty()) {
    std::ranges::sort(torn);
    torn.erase(std::unique(torn.begin(), torn.end()), torn.end());
    result.defect = defect_of_triangles(surface, "non-orientable shell",
                                        "the surface has only one side, like a Möbius strip: "
                                        "however they are turned, neighbours disagree at " +
                                            counted(torn.size(), "triangle"),
                                        torn);
  }
  return result;
}

}  // namespace tetfarm
