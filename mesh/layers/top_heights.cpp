#include "mesh/layers/top_heights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/artifacts/checked_bytes.h"

namespace tetfarm {
namespace {

constexpr std::string_view heights_magic = "TFTOPH\r\n";
constexpr std::uint32_t heights_version = 1;
constexpr std::uint64_t count_at = heights_magic.size() + sizeof heights_version;
constexpr std::uint64_t items_at = count_at + sizeof(std::uint64_t);
constexpr std::uint64_t first_vertex_key = std::uint64_t{1} << 32U;

static_assert(sizeof(TopHeight) == 32);

/// Of the last prism between three lines. @pre they have as many layers, one at least.
double height_of_last(const LayerPlan& plan, const Triangle& lines) {
  Vec3 below;
  std::array<Vec3, 3> top;
  for (std::size_t k = 0; k < 3; ++k) {
    const LayerLine& line = plan.lines[at(lines[k])];
    top[k] = point_of(line, line.stop);
    below = below + point_of(line, line.stop - 1);
  }
  const Vec3 way = (1.0 / 3) * (top[0] + top[1] + top[2] - below);
  return std::abs(dot(way, normalized(cross(top[1] - top[0], top[2] - top[0]))));
}

bool ends_in_prism(const LayerPlan& plan, const Triangle& lines, int least) {
  const int stop = plan.lines[at(lines[0])].stop;
  return stop >= least && std::all_of(lines.begin(), lines.end(), [&](std::int32_t number) {
           const LayerLine& line = plan.lines[at(number)];
           return line.stop == stop && !line.of_pml;
         });
}

TopHeight under(const Subdomain& root, std::size_t triangle, double height) {
  TopHeight found;
  found.height = height;
  for (std::size_t k = 0; k < 3; ++k) {
    found.nodes[k] = top_key(root.node_origin[at(root.triangles[triangle][k])]);
  }
  std::sort(found.nodes.begin(), found.nodes.end());
  return found;
}

}  // namespace

std::uint64_t top_key(const Origin& origin) {
  TF_CHECK(origin.owner == top_of_layers || origin.owner == 0);
  return origin.index + (origin.owner == 0 ? first_vertex_key : 0);
}

std::vector<TopHeight> top_heights(const LayerPlan& plan, const SurfaceMesh& surface,
                                   const UnlayeredDomain& rest) {
  std::vector<TopHeight> heights;
  const Subdomain& root = rest.root;
  const std::size_t first_of_fans = root.triangles.size() - rest.lines_of_fans.size();
  for (std::size_t i = 0; i < root.triangles.size(); ++i) {
    if (root.triangle_origin[i].owner != top_of_layers) continue;
    const bool is_of_fan = i >= first_of_fans;
    Triangle lines{};
    if (is_of_fan) {
      lines = rest.lines_of_fans[i - first_of_fans];
    } else {
      const auto [a, b, c] = lines_of(plan, surface, rest.stands_for[i]);
      lines = {a, b, c};
    }
    // The first layer of a fan has no prism below its triangles.
    if (!ends_in_prism(plan, lines, is_of_fan ? 2 : 1)) continue;
    const TopHeight found = under(root, i, height_of_last(plan, lines));
    if (found.nodes[0] < first_vertex_key) heights.push_back(found);
  }
  std::sort(heights.begin(), heights.end(),
            [](const TopHeight& a, const TopHeight& b) { return a.nodes < b.nodes; });
  return heights;
}

std::string top_heights_to_bytes(std::span<const TopHeight> heights) {
  ByteWriter writer;
  writer.text(heights_magic);
  writer.number(heights_version);
  writer.number(static_cast<std::uint64_t>(heights.size()));
  writer.array(heights);
  return with_block_checksums(writer.take());
}

TopHeightsFile::TopHeightsFile(const std::filesystem::path& path, const std::string& name)
    : file_(path, name) {
  const std::string begin = file_.read(0, std::min(file_.size(), items_at));
  ByteReader reader = read_begun(begin, heights_magic, heights_version, name);
  count_ = reader.count();
  if (file_.size() != items_at + count_ * sizeof(TopHeight)) file_.fail("is of another size");
}

std::vector<TopHeight> TopHeightsFile::with_first(std::span<const std::uint64_t> firsts) {
  std::vector<TopHeight> found;
  std::uint64_t from = 0;
  for (const std::uint64_t first : firsts) {
    std::uint64_t end = count_;
    while (from < end) {
      const std::uint64_t middle = from + (end - from) / 2;
      if (item(middle).nodes[0] < first) {
        from = middle + 1;
      } else {
        end = middle;
      }
    }
    for (; from < count_; ++from) {
      const TopHeight next = item(from);
      if (next.nodes[0] != first) break;
      found.push_back(next);
    }
  }
  return found;
}

TopHeight TopHeightsFile::item(std::uint64_t index) {
  const auto height = file_.item<TopHeight>(items_at, index);
  if (!std::is_sorted(height.nodes.begin(), height.nodes.end()) || !(height.height > 0)) {
    file_.fail("has a triangle that cannot be");
  }
  return height;
}

}  // namespace tetfarm
