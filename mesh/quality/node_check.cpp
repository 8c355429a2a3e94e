#include "mesh/quality/node_check.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/error.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

bool is_same_bits(const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis])) {
      return false;
    }
  }
  return true;
}

}  // namespace

NodeCheck::NodeCheck(const MeshSource& source, const std::filesystem::path& folder,
                     std::size_t memory_bytes)
    : shared_(folder, std::max<std::size_t>(memory_bytes / sizeof(SharedNode), 1024)) {
  // A number above all points could not be of a mesh without gaps, and would cost memory.
  std::int64_t limit = std::numeric_limits<std::int32_t>::max();
  std::int64_t end = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.counted_part(i).part;
    limit += std::ssize(part.local2global);
    for (const std::int64_t number : part.local2global) {
      if (number < 0 || number >= limit) {
        throw InvalidInput("the node number " + std::to_string(number) + " is out of range",
                           "sub-domain " + std::to_string(i));
      }
      end = std::max(end, number + 1);
      meet(number);
    }
  }
  nodes_ = std::count(is_new_.begin(), is_new_.end(), true);
  if (nodes_ == end) return;
  const auto missing = std::find(is_new_.begin(), is_new_.end(), false) - is_new_.begin();
  gaps_.push_back("node numbers have gaps: " + std::to_string(nodes_) +
                  " nodes, but the largest number is " + std::to_string(end - 1) +
                  " and there is no " + std::to_string(missing));
}

void NodeCheck::meet(std::int64_t number) {
  const auto at = static_cast<std::size_t>(number);
  if (at >= is_new_.size()) {
    is_new_.resize(std::max(at + 1, 2 * is_new_.size()), false);
    has_several_.resize(is_new_.size(), false);
  }
  if (is_new_[at]) has_several_[at] = true;
  is_new_[at] = true;
}

std::vector<std::string> NodeCheck::finish(std::size_t most) {
  std::vector<std::string> lines = std::move(gaps_);
  SharedNode first;
  SharedNode other;
  bool has_first = shared_.next(first);
  while (has_first && lines.size() < most) {
    has_first = shared_.next(other);
    if (has_first && other.number == first.number && !is_same_bits(first.place, other.place)) {
      lines.push_back("node " + std::to_string(first.number) + " lies at " + text_of(first.place) +
                      " in sub-domain " + std::to_string(first.part) + " and at " +
                      text_of(other.place) + " in sub-domain " + std::to_string(other.part) + ", " +
                      text_of(distance(first.place, other.place)) + " apart");
    }
    first = other;
  }
  return lines;
}

}  // namespace tetfarm
