#include "mesh/geometry/triangle_intersection.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tetfarm {
namespace {

using enum TriangleContact;

const TrianglePoints flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

struct Scenario {
  const char* name;
  TrianglePoints other;
  TriangleContact contact;
};

TEST(TriangleContact, is_named_rightly_against_a_flat_triangle) {
  const std::vector<Scenario> scenarios = {
      {"above", {{{0, 0, 1}, {4, 0, 1}, {0, 4, 2}}}, none},
      {"straddles the plane elsewhere", {{{9, 9, -1}, {9, 9, 1}, {12, 9, 0}}}, none},
      {"an edge goes through the inside", {{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}}, crossing},
      {"its edges are pierced, none of its own pierces",
       {{{1, -9, -9}, {1, 30, 0}, {1, -9, 9}}},
       crossing},
      {"a corner on the inside, from above", {{{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}}, touching},
      {"a corner on an edge", {{{2, 0, 0}, {2, -1, 1}, {3, -1, 1}}}, touching},
      {"a corner at a corner", {{{0, 0, 0}, {-1, 0, 1}, {-1, -1, 1}}}, touching},
      {"stands with an edge on the inside", {{{1, 1, 0}, {2, 1, 0}, {1, 1, 1}}}, touching},
      {"shares an edge at an angle", {{{0, 0, 0}, {4, 0, 0}, {0, 0, 1}}}, touching},
      {"shares an edge, folded upright over it", {{{0, 0, 0}, {4, 0, 0}, {1, 1, 1}}}, touching},
      {"from a shared corner through the inside", {{{0, 0, 0}, {9, 9, 1}, {9, 9, -1}}}, crossing},
      {"a corner inside and the rest on both sides",
       {{{1, 1, 0}, {9, 9, 1}, {9, 9, -1}}},
       crossing},
      {"edges cross and both go on outward", {{{2, 0, -1}, {2, 0, 1}, {2, -4, 0}}}, crossing},
      {"an edge through a corner, outward", {{{0, 0, -1}, {0, 0, 1}, {-4, -4, 0}}}, touching},
      {"in the plane, apart", {{{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}}, none},
      {"in the plane, the same", flat, overlapping},
      {"in the plane, the same reversed", {{{0, 0, 0}, {0, 4, 0}, {4, 0, 0}}}, overlapping},
      {"in the plane, edges along each other outside",
       {{{1, 0, 0}, {3, 0, 0}, {2, -2, 0}}},
       touching},
      {"in the plane, edges along each other inside",
       {{{1, 0, 0}, {3, 0, 0}, {1, 1, 0}}},
       overlapping},
      {"in the plane, within", {{{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}}}, overlapping},
      {"in the plane, a corner at a corner", {{{4, 0, 0}, {6, 0, 0}, {6, 1, 0}}}, touching},
      {"in the plane, as a star", {{{3, 3, 0}, {-1, 3, 0}, {3, -1, 0}}}, overlapping},
      {"no area", {{{1, 1, -1}, {1, 1, 0}, {1, 1, 1}}}, none},
  };
  for (const Scenario& s : scenarios) {
    EXPECT_EQ(triangle_contact(flat, s.other), s.contact) << s.name;
    EXPECT_EQ(triangle_contact(s.other, flat), s.contact) << s.name << ", the other way round";
    EXPECT_EQ(triangles_cross(s.other, flat), s.contact == crossing) << s.name;
  }
}

// An independent answer in whole numbers and fractions for corners on a small grid.
using Whole = long long;
struct Fraction {
  Whole top;
  Whole bottom;  // > 0
  bool operator<(const Fraction& b) const { return top * b.bottom < b.top * bottom; }
};

Whole whole_dot(const Vec3& a, const Vec3& b) { return static_cast<Whole>(dot(a, b)); }

/// Where the line that both planes share leaves the triangle: least and greatest along `direction`;
/// empty when it misses. `side` holds the heights of the corners over the other plane.
std::vector<Fraction> interval_on_line(const TrianglePoints& t, const std::array<Whole, 3>& side,
                                       const Vec3& direction) {
  std::vector<Fraction> at;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Whole p = whole_dot(direction, t[i]);
    const Whole q = whole_dot(direction, t[j]);
    if (side[i] == 0) at.push_back({p, 1});
    if ((side[i] < 0) != (side[j] < 0) && side[i] != 0 && side[j] != 0) {
      const Whole bottom = side[j] - side[i];
      const Whole top = p * side[j] - q * side[i];
      at.push_back(bottom > 0 ? Fraction{top, bottom} : Fraction{-top, -bottom});
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

std::array<Whole, 3> heights(const TrianglePoints& plane, const TrianglePoints& t) {
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  std::array<Whole, 3> h{};
  for (std::size_t i = 0; i < 3; ++i) h[i] = whole_dot(normal, t[i] - plane[0]);
  return h;
}

double area_shared_in_plane(const TrianglePoints& a, const TrianglePoints& b) {
  const Vec3 normal = cross(a[1] - a[0], a[2] - a[0]);
  std::vector<Vec3> polygon(b.begin(), b.end());
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 inward = cross(normal, a[(i + 1) % 3] - a[i]);
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec3 p = polygon[k];
      const Vec3 q = polygon[(k + 1) % polygon.size()];
      const double hp = dot(inward, p - a[i]);
      const double hq = dot(inward, q - a[i]);
      if (hp >= 0) kept.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.push_back(p + hp / (hp - hq) * (q - p));
    }
    polygon = kept;
  }
  Vec3 area;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    area += 0.5 * cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return norm(area);
}

enum class Shared { nothing, points, insides };

Shared shared_in_whole_numbers(const TrianglePoints& a, const TrianglePoints& b) {
  const std::array<Whole, 3> ha = heights(b, a);
  const std::array<Whole, 3> hb = heights(a, b);
  const Vec3 direction = cross(cross(a[1] - a[0], a[2] - a[0]), cross(b[1] - b[0], b[2] - b[0]));
  const auto on_a = interval_on_line(a, ha, direction);
  const auto on_b = interval_on_line(b, hb, direction);
  if (on_a.empty() || on_b.empty()) return Shared::nothing;
  if (on_a.back() < on_b.front() || on_b.back() < on_a.front()) return Shared::nothing;
  const auto straddles = [](const std::array<Whole, 3>& h) {
    const auto [low, high] = std::minmax({h[0], h[1], h[2]});
    return low < 0 && high > 0;
  };
  const bool inside =
      straddles(ha) && straddles(hb) && on_a.front() < on_b.back() && on_b.front() < on_a.back();
  return inside ? Shared::insides : Shared::points;
}

class RandomGrid {
 public:
  RandomGrid(std::uint32_t seed, std::uint32_t size) : random_(seed), size_(size) {}
  Vec3 point() { return {at(), at(), at()}; }
  TrianglePoints triangle() {
    for (;;) {
      const TrianglePoints t = {point(), point(), point()};
      if (norm2(cross(t[1] - t[0], t[2] - t[0])) > 0) return t;
    }
  }

 private:
  double at() { return static_cast<double>(random_() % size_); }
  std::mt19937 random_;
  std::uint32_t size_;
};

TEST(TriangleContact, agrees_with_whole_number_arithmetic_on_a_grid) {
  std::array<int, 4> seen{};
  for (const std::uint32_t size : {2U, 3U, 4U, 7U}) {
    RandomGrid grid(size, size);
    for (int i = 0; i < 20000; ++i) {
      const TrianglePoints a = grid.triangle();
      const TrianglePoints b = grid.triangle();
      const TriangleContact contact = triangle_contact(a, b);
      ++seen[static_cast<std::size_t>(contact)];
      ASSERT_EQ(triangle_contact(b, a), contact);
      const std::array<Whole, 3> side = heights(b, a);
      if (std::count(side.begin(), side.end(), 0) == 3) {
        ASSERT_EQ(contact == overlapping, area_shared_in_plane(a, b) > 1e-9);
        ASSERT_NE(contact, crossing);
        continue;
      }
      const Shared expected = shared_in_whole_numbers(a, b);
      ASSERT_EQ(contact == none, expected == Shared::nothing);
      ASSERT_TRUE(expected != Shared::insides || contact == crossing);
      // Crossing without shared insides: two edges cross between their ends.
      if (contact == crossing && expected != Shared::insides) {
        bool edges_cross = false;
        for (std::size_t e = 0; e < 3; ++e) {
          edges_cross |= segment_crosses_triangle(a[e], a[(e + 1) % 3], b);
        }
        ASSERT_TRUE(edges_cross);
      }
    }
  }
  EXPECT_THAT(seen, testing::Each(testing::Gt(100)));
}

TEST(TriangleContact, does_not_depend_on_the_order_of_corners) {
  RandomGrid grid(5, 4);
  for (int i = 0; i < 2000; ++i) {
    const TrianglePoints a = grid.triangle();
    const TrianglePoints b = grid.triangle();
    const TriangleContact contact = triangle_contact(a, b);
    ASSERT_EQ(triangle_contact({a[1], a[2], a[0]}, b), contact);
    ASSERT_EQ(triangle_contact({a[0], a[2], a[1]}, {b[2], b[1], b[0]}), contact);
  }
}

TEST(TriangleContact, is_exact_one_rounding_away_from_touching) {
  const double above = 0x1p-52;
  const TrianglePoints slanted = {{{0, 0, 0}, {1, 0, 1.0 / 3}, {0, 1, 1.0 / 7}}};
  // At (0.25, 0) the slanted triangle is exactly at a quarter of 1/3.
  const Vec3 on{0.25, 0, 1.0 / 12};
  EXPECT_EQ(on.z, 0.25 * (1.0 / 3));
  const auto from_above = [](const Vec3& tip) {
    return TrianglePoints{{tip, {0.25, 0, 9}, {0.5, -1, 9}}};
  };
  EXPECT_EQ(triangle_contact(slanted, from_above(on)), touching);
  EXPECT_EQ(triangle_contact(slanted, from_above(on + Vec3{0, 0, above})), none);
  EXPECT_NE(triangle_contact(slanted, from_above(on - Vec3{0, 0, above})), none);
}

TEST(SegmentAndTriangle, meet_or_cross_as_they_should) {
  struct Case {
    const char* name;
    Vec3 p;
    Vec3 q;
    bool meets;
    bool crosses;
  };
  const std::vector<Case> cases = {
      {"through the inside", {1, 1, -1}, {1, 1, 1}, true, true},
      {"through an edge", {2, 0, -1}, {2, 0, 1}, true, true},
      {"through a corner", {4, 0, -1}, {4, 0, 1}, true, false},
      {"beside it", {3, 3, -1}, {3, 3, 1}, false, false},
      {"ends on the inside", {1, 1, 0}, {1, 1, 1}, true, false},
      {"ends in the plane beside it", {3, 3, 0}, {1, 1, 1}, false, false},
      {"too short", {1, 1, 1}, {1, 1, 2}, false, false},
      {"in the plane across it", {-1, 1, 0}, {9, 1, 0}, true, false},
      {"in the plane along an edge", {-3, 0, 0}, {1, 0, 0}, true, false},
      {"in the plane on an edge's line, beyond", {-3, 0, 0}, {-1, 0, 0}, false, false},
      {"in the plane, within", {1, 1, 0}, {1, 2, 0}, true, false},
      {"in the plane, past a corner", {5, -1, 0}, {4, 2, 0}, false, false},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(segment_meets_triangle(c.p, c.q, flat), c.meets) << c.name;
    EXPECT_EQ(segment_meets_triangle(c.q, c.p, flat), c.meets) << c.name;
    EXPECT_EQ(segment_crosses_triangle(c.p, c.q, flat), c.crosses) << c.name;
    EXPECT_EQ(segment_crosses_triangle(c.q, c.p, flat), c.crosses) << c.name;
  }
}

TEST(MeetingBeyondShared, allows_only_the_shared_corners_and_edge) {
  const std::vector<Vec3> v = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0},  {4, 4, 0},   {1, 1, 0},
                               {0, 0, 4}, {2, 1, 1}, {2, 1, -1}, {-1, -1, 0}, {0, 0, 0}};
  struct Case {
    const char* name;
    Triangle b;
    bool meets;
  };
  const std::vector<Case> cases = {
      {"neighbour in the plane", {1, 3, 2}, false},
      {"neighbour folded flat", {0, 1, 4}, true},
      {"neighbour upright", {0, 1, 5}, false},
      {"neighbour upright over the inside", {0, 1, 6}, false},
      {"one corner, outward", {0, 8, 5}, false},
      {"one corner, through the inside", {0, 6, 7}, true},
      {"one corner, in the plane and overlapping", {0, 3, 4}, true},
      {"one corner, the opposite edge pierces", {1, 6, 7}, true},
      {"no corner, piercing", {6, 7, 5}, true},
      {"the same place under another number", {9, 8, 5}, true},
      {"twice the same", {2, 0, 1}, true},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(triangles_meet_beyond_shared(v, {0, 1, 2}, c.b), c.meets) << c.name;
    EXPECT_EQ(triangles_meet_beyond_shared(v, c.b, {2, 0, 1}), c.meets) << c.name;
  }
}

TEST(MeetingBeyondShared, equals_contact_after_shrinking_away_from_the_shared_corner) {
  // With one shared corner, sharing more than that corner is the same as contact between a and what
  // is left of b beyond a sixteenth of the way, or the other way round.
  RandomGrid grid(9, 4);
  int meeting = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 shared = grid.point();
    const std::vector<Vec3> v = {shared, grid.point(), grid.point(), grid.point(), grid.point()};
    const TrianglePoints a = {v[0], v[1], v[2]};
    const TrianglePoints b = {v[0], v[3], v[4]};
    if (is_degenerate(a) || is_degenerate(b)) continue;
    const Vec3 near3 = shared + (v[3] - shared) / 16;
    const Vec3 near4 = shared + (v[4] - shared) / 16;
    const bool expected = triangle_contact(a, {near3, v[3], v[4]}) != none ||
                          triangle_contact(a, {near3, v[4], near4}) != none;
    ASSERT_EQ(triangles_meet_beyond_shared(v, {0, 1, 2}, {4, 0, 3}), expected);
    meeting += expected ? 1 : 0;
  }
  EXPECT_GT(meeting, 100);
}

TEST(Degenerate, means_exactly_no_area) {
  EXPECT_TRUE(is_degenerate({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}}));
  EXPECT_TRUE(is_degenerate({{{1, 2, 3}, {1, 2, 3}, {0, 0, 0}}}));
  EXPECT_FALSE(is_degenerate({{{0, 0, 0}, {1, 1, 1}, {3, 3, 3 + 0x1p-51}}}));
  EXPECT_FALSE(is_degenerate({{{0, 0, 0}, {1, 0, 0}, {1, 1e-30, 0}}}));
}

}  // namespace
}  // namespace tetfarm
