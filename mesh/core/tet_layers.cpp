#include "mesh/core/tet_layers.h"

#include <algorithm>
#include <limits>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
TetBlocks::TetBlocks(std::span<const Tet> tets, std::size_t nodes) : tets_(tets), nodes_(nodes) {
  TF_CHECK(tets.size() <= std::numeric_limits<std::uint32_t>::max());
  std::vector<std::size_t> block_of_page(pages(), std::numeric_limits<std::size_t>::max());
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

TetLayers::TetLayers(const TetBlocks& blocks)
    : blocks_(blocks),
      is_reached_(blocks.nodes(), 0),
      is_given_(blocks.tets().size(), 0),
      has_new_(blocks.pages(), 0) {}

void TetLayers::reach(std::int32_t node) {
  if (is_reached_[at(node)] != 0) return;
  is_reached_[at(node)] = 1;
  has_new_[at(node) / TetBlocks::nodes_of_page] = 1;
}

void TetLayers::reach_nodes_of(std::span<const std::uint32_t> tets) {
  for (const std::uint32_t t : tets) {
    for (const std::int32_t v : blocks_.tets()[t]) reach(v);
  }
}

std::vector<std::uint32_t> TetLayers::next() {
  std::vector<std::uint32_t> layer;
  for (std::size_t block = 0; block < blocks_.blocks(); ++block) {
    const auto pages = blocks_.pages_of(block);
    if (std::any_of(pages.begin(), pages.end(), [&](auto page) { return has_new_[page] != 0; })) {
      add_new_of(block, layer);
    }
  }
  std::fill(has_new_.begin(), has_new_.end(), 0);
  return layer;
}

void TetLayers::add_new_of(std::size_t block, std::vector<std::uint32_t>& layer) {
  const std::span<const Tet> tets = blocks_.tets();
  const std::size_t first = block * TetBlocks::tets_of_block;
  const std::size_t last = std::min(tets.size(), first + TetBlocks::tets_of_block);
  for (std::size_t t = first; t < last; ++t) {
    const Tet& tet = tets[t];
    const int reached = is_reached_[at(tet[0])] | is_reached_[at(tet[1])] |
                        is_reached_[at(tet[2])] | is_reached_[at(tet[3])];
    if (reached == 0 || is_given_[t] != 0) continue;
    is_given_[t] = 1;
    layer.push_back(static_cast<std::uint32_t>(t));
  }
}

}  // namespace tetfarm
