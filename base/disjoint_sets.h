/// Items 0, 1, … in sets that are joined two by two.
///
/// Source: R. E. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975, with
/// halved paths and without ranks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/check.h"

namespace tetfarm {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t items) : parent_(items) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// One of the item's set, the same for all of the set until it is joined with another.
  std::size_t root(std::size_t item) {
    while (parent_[item] != item) {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  /// A number for each set, in the order of their first items; returns how many.
  /// @pre item2set is empty.
  std::int32_t number(std::vector<std::int32_t>& item2set) {
    TF_CHECK(item2set.empty());
    std::vector<std::int32_t> root2set(parent_.size(), -1);
    std::int32_t sets = 0;
    for (std::size_t item = 0; item < parent_.size(); ++item) {
      std::int32_t& set = root2set[root(item)];
      if (set < 0) set = sets++;
      item2set.push_back(set);
    }
    return sets;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace tetfarm
