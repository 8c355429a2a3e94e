#include "mesh/core/tet_layers.h"

#include <algorithm>
#include <limits>

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

TetLayers::TetLayers(std::span<const Tet> tets, std::size_t nodes)
    : tets_(tets),
      is_reached_(nodes, 0),
      is_given_(tets.size(), 0),
      has_new_(nodes / nodes_of_page + 1, 0) {
  std::vector<std::size_t> block_of_page(has_new_.size(), std::numeric_limits<std::size_t>::max());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const std::size_t block = t / tets_of_block;
    if (t % tets_of_block == 0) first_page_.push_back(pages_.size());
    for (const std::int32_t v : tets[t]) {
      const std::size_t page = at(v) / nodes_of_page;
      if (block_of_page[page] == block) continue;
      block_of_page[page] = block;
      pages_.push_back(static_cast<std::uint32_t>(page));
    }
  }
  first_page_.push_back(pages_.size());
}

void TetLayers::reach(std::int32_t node) {
  if (is_reached_[at(node)] != 0) return;
  is_reached_[at(node)] = 1;
  has_new_[at(node) / nodes_of_page] = 1;
}

std::vector<std::uint32_t> TetLayers::next() {
  std::vector<std::uint32_t> layer;
  for (std::size_t block = 0; block + 1 < first_page_.size(); ++block) {
    const auto first = pages_.begin() + static_cast<std::ptrdiff_t>(first_page_[block]);
    const auto last = pages_.begin() + static_cast<std::ptrdiff_t>(first_page_[block + 1]);
    const bool may_have = std::any_of(first, last, [&](auto page) { return has_new_[page] != 0; });
    if (may_have) add_new_of(block, layer);
  }
  std::fill(has_new_.begin(), has_new_.end(), 0);
  return layer;
}

void TetLayers::add_new_of(std::size_t block, std::vector<std::uint32_t>& layer) {
  const std::size_t last = std::min(tets_.size(), (block + 1) * tets_of_block);
  for (std::size_t t = block * tets_of_block; t < last; ++t) {
    const Tet& tet = tets_[t];
    const int reached = is_reached_[at(tet[0])] | is_reached_[at(tet[1])] |
                        is_reached_[at(tet[2])] | is_reached_[at(tet[3])];
    if (reached == 0 || is_given_[t] != 0) continue;
    is_given_[t] = 1;
    layer.push_back(static_cast<std::uint32_t>(t));
  }
}

}  // namespace tetfarm
