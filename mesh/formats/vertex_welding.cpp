#include "mesh/formats/vertex_welding.h"

#include <bit>
#include <limits>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int32_t empty = -1;

std::uint64_t mixed(std::uint64_t bits) {
  bits ^= bits >> 32;
  bits *= 0x9e3779b97f4a7c15;
  return bits ^ bits >> 29;
}

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t hash = mixed(std::bit_cast<std::uint64_t>(p.x));
  hash = mixed(hash * 3 + std::bit_cast<std::uint64_t>(p.y));
  return mixed(hash * 3 + std::bit_cast<std::uint64_t>(p.z));
}

}  // namespace

VertexWelding::VertexWelding(std::size_t expected_points)
    : slots_(std::bit_ceil(2 * expected_points + 16), empty) {
  points_.reserve(expected_points);
}

std::int32_t VertexWelding::add(const Vec3& point) {
  const Vec3 p = {point.x + 0.0, point.y + 0.0, point.z + 0.0};  // -0 + 0 is 0
  std::size_t slot = slot_of(p);
  if (slots_[slot] != empty) return slots_[slot];
  TF_CHECK(points_.size() < std::numeric_limits<std::int32_t>::max());
  const auto number = static_cast<std::int32_t>(points_.size());
  points_.push_back(p);
  slots_[slot] = number;
  if (2 * points_.size() > slots_.size()) grow();
  return number;
}

std::size_t VertexWelding::slot_of(const Vec3& point) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_of(point) & mask;
  while (slots_[slot] != empty && points_[static_cast<std::size_t>(slots_[slot])] != point) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

void VertexWelding::grow() {
  slots_.assign(2 * slots_.size(), empty);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    slots_[slot_of(points_[i])] = static_cast<std::int32_t>(i);
  }
}

}  // namespace tetfarm
