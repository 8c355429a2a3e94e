/// How high the last prism is below each triangle of the top of the layers: what the tets that
/// stand there are to be measured by, leaf by leaf. A file of it is read in the parts that one leaf
/// needs. Lengths in the unit of the input.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/artifacts/block_file.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/unlayered_domain.h"

namespace tetfarm {

/// A node of the top as one number: its own in the top, or behind all of these its vertex of the
/// surface. @pre the origin is one of the two.
std::uint64_t top_key(const Origin& origin);

struct TopHeight {
  std::array<std::uint64_t, 3> nodes{};  ///< keys, ascending
  double height = 0;                     ///< of the last prism, normal to its upper triangle

  friend bool operator==(const TopHeight&, const TopHeight&) = default;
};

/// Of the triangles of the top that a prism of boundary layers ends in and of whose nodes one at
/// least is no vertex of the surface: ascending by nodes. @pre `rest` is what the plan leaves.
/// Cost: O(n log n).
std::vector<TopHeight> top_heights(const LayerPlan& plan, const SurfaceMesh& surface,
                                   const UnlayeredDomain& rest);

/// The grammar is in store/formats.md. @pre they are ascending. Cost: O(n).
std::string top_heights_to_bytes(std::span<const TopHeight> heights);

/// Such a file, open to read what stands under some nodes. @throws CorruptFile naming `name`,
/// IoError.
class TopHeightsFile {
 public:
  TopHeightsFile(const std::filesystem::path& path, const std::string& name);

  /// Those whose first node is one of `firsts`, ascending. @pre `firsts` are ascending.
  /// Cost: O(log n) of the file for each, and what is found.
  std::vector<TopHeight> with_first(std::span<const std::uint64_t> firsts);

 private:
  TopHeight item(std::uint64_t index);

  BlockFile file_;
  std::uint64_t count_ = 0;
};

}  // namespace tetfarm
