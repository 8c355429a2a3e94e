#include "mesh/arrangement/segment_division.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

/// Of the plane z = 0, seen along z.
struct PlanarPoints {
  ExactPoints points = {};

  std::int32_t at(double x, double y) { return points.add(exact_point({x, y, 0})); }
  std::vector<Segment> divided(const std::vector<Segment>& segments) {
    std::int64_t pairs_left = 1000;
    return divide_segments(points, segments, 2, pairs_left).value();
  }
};

TEST(SegmentDivision, two_that_cross_are_divided_at_one_new_point) {
  PlanarPoints p;
  const std::int32_t a = p.at(0, 0);
  const std::int32_t b = p.at(3, 1);
  const std::int32_t c = p.at(1, -1);
  const std::int32_t d = p.at(1, 1);
  const std::vector<Segment> pieces = p.divided({{a, b}, {c, d}});
  ASSERT_EQ(p.points.size(), 5);
  EXPECT_EQ(p.points[4].at[1], mpq_class(1, 3));
  EXPECT_THAT(pieces, ElementsAre(Segment{a, 4}, Segment{b, 4}, Segment{c, 4}, Segment{d, 4}));
}

TEST(SegmentDivision, an_end_on_another_divides_that_one) {
  PlanarPoints p;
  const std::int32_t a = p.at(0, 0);
  const std::int32_t b = p.at(2, 2);
  const std::int32_t on = p.at(1, 1);
  const std::int32_t off = p.at(1, 5);
  EXPECT_THAT(p.divided({{b, a}, {on, off}}),
              ElementsAre(Segment{a, on}, Segment{b, on}, Segment{on, off}));
}

TEST(SegmentDivision, what_lies_on_each_other_becomes_pieces_that_are_there_once) {
  PlanarPoints p;
  const std::int32_t a = p.at(0, 0);
  const std::int32_t b = p.at(1, 3);
  const std::int32_t c = p.at(2, 6);
  const std::int32_t d = p.at(3, 9);
  EXPECT_THAT(p.divided({{a, c}, {d, b}}),
              ElementsAre(Segment{a, b}, Segment{b, c}, Segment{c, d}));
}

TEST(SegmentDivision, a_point_alone_divides_what_it_lies_on_and_is_no_piece) {
  PlanarPoints p;
  const std::int32_t a = p.at(0, 0);
  const std::int32_t b = p.at(2, 0);
  const std::int32_t on = p.at(1, 0);
  const std::int32_t off = p.at(1, 1);
  EXPECT_THAT(p.divided({{a, b}, {on, on}, {off, off}}),
              ElementsAre(Segment{a, on}, Segment{b, on}));
}

TEST(SegmentDivision, gives_up_where_there_are_too_many_pairs) {
  PlanarPoints p;
  std::vector<Segment> all;
  for (int i = 0; i < 10; ++i) all.push_back({p.at(0, i), p.at(1, 9 - i)});
  std::int64_t too_few = 44;
  EXPECT_FALSE(divide_segments(p.points, all, 2, too_few));
  std::int64_t enough = 47;
  EXPECT_THAT(divide_segments(p.points, all, 2, enough).value(), SizeIs(20));
  EXPECT_EQ(enough, 2);
}

}  // namespace
}  // namespace tetfarm
