#include "mesh/formats/local_numbers.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace tetfarm {

std::size_t LocalNumbers::slot_of(std::int64_t global) const {
  const std::uint64_t mixed = static_cast<std::uint64_t>(global) * 0x9e3779b97f4a7c15U;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = (mixed ^ mixed >> 32) & mask;
  while (slots_[slot] >= 0 && local2global_[static_cast<std::size_t>(slots_[slot])] != global) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

std::int32_t LocalNumbers::of(std::int64_t global) {
  TF_CHECK(!slots_.empty());  // not after sort()
  std::size_t slot = slot_of(global);
  if (slots_[slot] >= 0) return slots_[slot];
  if (2 * local2global_.size() >= slots_.size()) {
    grow();
    slot = slot_of(global);
  }
  slots_[slot] = static_cast<std::int32_t>(local2global_.size());
  local2global_.push_back(global);
  return slots_[slot];
}

void LocalNumbers::grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (std::size_t v = 0; v < local2global_.size(); ++v) {
    slots_[slot_of(local2global_[v])] = static_cast<std::int32_t>(v);
  }
}

std::vector<std::int32_t> LocalNumbers::sort() {
  std::vector<std::int32_t> order(local2global_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto global = [&](std::int32_t v) { return local2global_[static_cast<std::size_t>(v)]; };
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return global(a) < global(b); });
  std::vector<std::int32_t> new_number(order.size());
  for (std::size_t v = 0; v < order.size(); ++v) {
    new_number[static_cast<std::size_t>(order[v])] = static_cast<std::int32_t>(v);
  }
  std::sort(local2global_.begin(), local2global_.end());
  slots_ = {};
  return new_number;
}

}  // namespace tetfarm
