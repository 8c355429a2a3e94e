/// Where a foot has several lines: how they belong to the triangles of the wall, and what lies
/// between them.
///
/// Source: layer_fan.h.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace tetfarm {

/// How a fan ends in a plane that its lines at one foot run in: a triangle of the boundary at the
/// foot, and quads above it, as many as there are further layers, or the triangles that these are
/// divided into, whose numbers follow.
struct FanEnd {
  std::int32_t patch = -1;     ///< of the plane; -1: there is none
  std::int32_t triangle = -1;  ///< of the surface

  friend bool operator==(const FanEnd&, const FanEnd&) = default;
};

/// What lies between neighbouring lines of one foot, where a fan of them goes round a sharp edge or
/// corner: see layer_fan.h for the cells. Numbers are those of lines. Seen from the layers along an
/// edge of the wall from one foot to the other, the first of two lines is to the left.
struct FanPiece {
  std::array<std::int32_t, 2> from{};  ///< two lines of one foot
  /// Of the other end of the edge two lines of a fan, or twice its only line; or twice a third line
  /// of the same foot: a corner.
  std::array<std::int32_t, 2> to{};
  std::int32_t beside = 0;          ///< a triangle of the wall at the edge or corner
  std::array<FanEnd, 2> ends = {};  ///< at the lines `from`, and `to`

  friend bool operator==(const FanPiece&, const FanPiece&) = default;
};

/// The line that a triangle of the wall has at a corner where there are several.
struct FanCorner {
  std::int32_t triangle = 0;
  int corner = 0;
  std::int32_t line = 0;

  friend auto operator<=>(const FanCorner&, const FanCorner&) = default;
};

}  // namespace tetfarm
