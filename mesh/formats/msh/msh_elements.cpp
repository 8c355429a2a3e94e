#include "mesh/formats/msh/msh_elements.h"

#include <algorithm>
#include <array>

namespace tetfarm {
namespace {

constexpr std::array<MshElementType, 32> types = {{
    {"", 0, 0},
    {"line", 1, 2},
    {"triangle", 2, 3},
    {"quadrangle", 2, 4},
    {"tetrahedron", 3, 4},
    {"hexahedron", 3, 8},
    {"prism", 3, 6},
    {"pyramid", 3, 5},
    {"3-node line", 1, 3},
    {"6-node triangle", 2, 6},
    {"9-node quadrangle", 2, 9},
    {"10-node tetrahedron", 3, 10},
    {"27-node hexahedron", 3, 27},
    {"18-node prism", 3, 18},
    {"14-node pyramid", 3, 14},
    {"point", 0, 1},
    {"8-node quadrangle", 2, 8},
    {"20-node hexahedron", 3, 20},
    {"15-node prism", 3, 15},
    {"13-node pyramid", 3, 13},
    {"9-node triangle", 2, 9},
    {"10-node triangle", 2, 10},
    {"12-node triangle", 2, 12},
    {"15-node triangle", 2, 15},
    {"15-node incomplete triangle", 2, 15},
    {"21-node triangle", 2, 21},
    {"4-node line", 1, 4},
    {"5-node line", 1, 5},
    {"6-node line", 1, 6},
    {"20-node tetrahedron", 3, 20},
    {"35-node tetrahedron", 3, 35},
    {"56-node tetrahedron", 3, 56},
}};

}  // namespace

std::optional<MshElementType> msh_element_type(std::int64_t type) {
  if (type <= 0 || type >= static_cast<std::int64_t>(types.size())) return std::nullopt;
  return types[static_cast<std::size_t>(type)];
}

std::optional<std::int64_t> MshNodeTags::sort() {
  if (!std::is_sorted(tags_.begin(), tags_.end())) std::sort(tags_.begin(), tags_.end());
  const auto twice = std::adjacent_find(
      tags_.begin(), tags_.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice == tags_.end()) return std::nullopt;
  return twice->first;
}

std::int32_t MshNodeTags::find(std::int64_t tag) const {
  if (tags_.empty() || tag < tags_.front().first || tag > tags_.back().first) return -1;
  const auto guess =
      static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(tags_.front().first);
  if (guess < tags_.size() && tags_[guess].first == tag) return tags_[guess].second;
  const auto found = std::lower_bound(tags_.begin(), tags_.end(), std::pair{tag, std::int32_t{0}});
  return found != tags_.end() && found->first == tag ? found->second : -1;
}

}  // namespace tetfarm
