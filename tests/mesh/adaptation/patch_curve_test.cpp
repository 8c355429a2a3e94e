#include "mesh/adaptation/patch_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/adaptation/circle_curve.h"
#include "mesh/adaptation/naca_profile.h"

namespace tetfarm {
namespace {

PatchCurve circle() { return {{1}, "c", {std::make_shared<const CircleCurve>(Circle{{0, 0}, 1})}}; }

Vec2 on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(PatchCurve, is_a_part_of_the_circle_in_either_direction) {
  for (const double direction : {1.0, -1.0}) {
    std::vector<Vec2> points;
    // Across the place where the circle's parameters begin.
    for (int i = 0; i <= 8; ++i) points.push_back(on_circle(-1 + direction * 0.25 * i));
    const BoundaryCurve part = boundary_curve_of(circle(), points, false);
    EXPECT_FALSE(part.is_closed());
    EXPECT_NEAR(part.length(), 2, 0.05);
    EXPECT_EQ(part.at(0), points.front());
    EXPECT_EQ(part.at(part.length()), points.back());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = part.at(part.parameter_of(i));
      EXPECT_NEAR(std::hypot(p.x - points[i].x, p.y - points[i].y), 0, 4e-15) << i;
    }
  }
}

TEST(PatchCurve, goes_once_round_a_circle_that_has_no_corner) {
  for (const double direction : {1.0, -1.0}) {
    std::vector<Vec2> points;
    for (int i = 0; i < 7; ++i) points.push_back(on_circle(0.3 + direction * 0.9 * i));
    const PieceOnCurve piece = piece_on_curve(circle(), points, true);
    EXPECT_FALSE(piece.fold.has_value());
    EXPECT_NEAR(piece.part.way, direction * 2 * std::numbers::pi, 1e-14);
    const BoundaryCurve whole = boundary_curve_of(circle(), points, true);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = whole.at(whole.parameter_of(i) + whole.length());
      EXPECT_NEAR(std::hypot(p.x - points[i].x, p.y - points[i].y), 0, 1e-14) << i;
    }
  }
}

TEST(PatchCurve, knows_the_node_that_turns_back) {
  const std::vector<Vec2> points{on_circle(0), on_circle(0.3), on_circle(0.2), on_circle(0.5)};
  EXPECT_EQ(piece_on_curve(circle(), points, false).fold, std::optional<std::size_t>(2));
}

TEST(PatchCurve, begins_and_ends_at_a_trailing_edge_on_the_right_side) {
  const PatchCurve naca{{1}, "n", naca_parts({})};
  const TrueCurve& profile = *naca.parts[0];
  std::vector<Vec2> points;
  for (int i = 0; i <= 20; ++i) points.push_back(profile.at(profile.length() * i / 20));
  PieceOnCurve piece = piece_on_curve(naca, points, false);
  EXPECT_FALSE(piece.fold.has_value());
  EXPECT_EQ(piece.part.from, 0);
  EXPECT_EQ(piece.part.way, profile.length());
  std::reverse(points.begin(), points.end());
  piece = piece_on_curve(naca, points, false);
  EXPECT_FALSE(piece.fold.has_value());
  EXPECT_EQ(piece.part.from, profile.length());
  EXPECT_EQ(piece.part.way, -profile.length());
}

TEST(PatchCurve, tells_a_blunt_base_of_one_edge_from_the_profile) {
  NacaPlace place;
  place.is_sharp = false;
  const PatchCurve naca{{1}, "n", naca_parts(place)};
  const TrueCurve& base = *naca.parts[1];
  const PieceOnCurve piece = piece_on_curve(naca, {base.at(0), base.at(base.length())}, false);
  EXPECT_EQ(piece.part.curve.get(), &base);
}

TEST(PatchCurve, without_parts_is_the_line_between_corners) {
  const PatchCurve line{{1}, "l", {}};
  const BoundaryCurve part = boundary_curve_of(line, {{0, 0}, {1, 1e-4}, {2, 0}}, false);
  EXPECT_EQ(part.at(0.5).y, 0);
  EXPECT_EQ(part.length(), 2);
  EXPECT_TRUE(piece_on_curve(line, {{0, 0}, {1, 0}, {0, 0}}, false).fold.has_value());
}

}  // namespace
}  // namespace tetfarm
