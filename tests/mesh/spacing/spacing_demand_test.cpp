#include "mesh/spacing/spacing_demand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tetfarm {
namespace {

constexpr double growth = 0.5;
constexpr double background = 1;

Source point_source(const Vec3& at, double spacing, double inner, double outer) {
  return {{{at, spacing, inner, outer}}};
}

SpacingDemand demand_of(const std::vector<PointDemand>& points,
                        const std::vector<Source>& sources) {
  SpacingDemand demand{DemandTree(points, growth), {}, background, growth, background};
  for (const Source& source : sources) demand.sources.push_back(source_demand(source, growth));
  return demand;
}

const std::vector<PointDemand> some_points = {
    {{0.1, 0.2, 0.3}, 0.05, 0.02}, {{0.8, 0.7, 0.2}, 0.1, 0.06}, {{0.5, 0.5, 0.9}, 0.2, 0}};
const std::vector<Source> some_sources = {point_source({0.9, 0.1, 0.9}, 0.04, 0.1, 0.4),
                                          point_source({0.2, 0.9, 0.5}, 0.3, 0.05, 0.2)};

/// What is asked for at a point, from all demands one after the other.
double asked_at(const SpacingDemand& demand, const std::vector<PointDemand>& points,
                const Vec3& p) {
  double least = demand.ceiling;
  for (const PointDemand& d : points) {
    least = std::min(least, d.spacing + growth * std::max(0.0, distance(d.at, p) - d.plateau));
  }
  for (const SourceDemand& source : demand.sources) {
    least = std::min(least, source_value(source, p, 0, background, growth).asked);
  }
  return least;
}

CellDemand::Cell cell_at(const Vec3& centre, double edge) {
  return {centre, 0.5 * std::sqrt(3.0) * edge};
}

/// Enters cells inside one another, down to that of the edge 1/2^levels at the point.
void enter_down_to(CellDemand& inside, const Vec3& p, int levels) {
  for (int level = 0; level <= levels; ++level) {
    const double edge = 1.0 / (1 << level);
    Vec3 centre;
    for (int axis = 0; axis < 3; ++axis) {
      centre[axis] = edge * (std::floor(p[axis] / edge) + 0.5);
    }
    inside.enter(cell_at(centre, edge));
  }
}

const std::vector<Vec3> places = {{0.11, 0.21, 0.33}, {0.83, 0.74, 0.21}, {0.91, 0.12, 0.93},
                                  {0.21, 0.88, 0.51}, {0.45, 0.55, 0.1},  {0.02, 0.97, 0.98}};

TEST(SpacingDemand, in_a_cell_is_the_least_of_all_demands) {
  const SpacingDemand demand = demand_of(some_points, some_sources);
  for (const Vec3& p : places) {
    for (const int levels : {0, 2, 5}) {
      CellDemand inside(demand);
      enter_down_to(inside, p, levels);
      EXPECT_NEAR(inside.at(p), asked_at(demand, some_points, p), 1e-15) << p.x << " " << levels;
    }
  }
}

TEST(SpacingDemand, of_a_cell_is_found_again_after_others_were_left) {
  const SpacingDemand demand = demand_of(some_points, some_sources);
  CellDemand inside(demand);
  inside.enter(cell_at({0.5, 0.5, 0.5}, 1));
  for (const Vec3& p : places) {
    for (int level = 1; level <= 4; ++level) {
      const double edge = 1.0 / (1 << level);
      Vec3 centre;
      for (int axis = 0; axis < 3; ++axis) {
        centre[axis] = edge * (std::floor(p[axis] / edge) + 0.5);
      }
      inside.enter(cell_at(centre, edge));
    }
    EXPECT_NEAR(inside.at(p), asked_at(demand, some_points, p), 1e-15);
    for (int level = 1; level <= 4; ++level) inside.leave();
    EXPECT_NEAR(inside.at(p), asked_at(demand, some_points, p), 1e-15);
  }
}

TEST(SpacingDemand, is_bounded_from_below_in_the_whole_cell) {
  const SpacingDemand demand = demand_of(some_points, some_sources);
  for (const Vec3& p : places) {
    for (const int levels : {1, 3}) {
      CellDemand inside(demand);
      enter_down_to(inside, p, levels);
      const double edge = 1.0 / (1 << levels);
      for (const double enough : {0.0, 0.02, 10.0}) {
        const CellDemand::Bounds bounds = inside.bounds(enough);
        Vec3 centre;
        for (int axis = 0; axis < 3; ++axis) {
          centre[axis] = edge * (std::floor(p[axis] / edge) + 0.5);
        }
        EXPECT_NEAR(bounds.at_centre, asked_at(demand, some_points, centre), 1e-15);
        EXPECT_LE(bounds.lowest, bounds.at_centre);
        for (int k = 0; k < 27; ++k) {
          const Vec3 q = centre + 0.499 * edge * Vec3{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
          EXPECT_LE(bounds.lowest, asked_at(demand, some_points, q) + 1e-15);
        }
        EXPECT_FALSE(bounds.is_ceiling);
      }
    }
  }
}

TEST(SpacingDemand, that_grows_as_it_should_is_bounded_by_growth_alone_where_that_is_enough) {
  const SpacingDemand demand = demand_of(some_points, {});
  ASSERT_FALSE(demand.grows_too_fast());
  CellDemand inside(demand);
  const CellDemand::Cell cell = cell_at({0.75, 0.75, 0.25}, 0.5);
  inside.enter(cell_at({0.5, 0.5, 0.5}, 1));
  inside.enter(cell);
  const double at_centre = asked_at(demand, some_points, cell.centre);
  const double by_growth = at_centre - growth * cell.half_diagonal;
  EXPECT_EQ(inside.bounds(by_growth).lowest, by_growth);
  EXPECT_GT(inside.bounds(by_growth + 1e-9).lowest, by_growth) << "looked at more closely";
}

TEST(SpacingDemand, is_the_ceiling_where_nobody_asks_for_less) {
  const SpacingDemand demand =
      demand_of({{{0, 0, 0}, 0.9, 0}}, {point_source({0.1, 0.1, 0.1}, 0.5, 0.05, 0.1)});
  CellDemand inside(demand);
  inside.enter(cell_at({0.5, 0.5, 0.5}, 1));
  EXPECT_FALSE(inside.bounds(0).is_ceiling);
  inside.enter(cell_at({0.875, 0.875, 0.875}, 0.25));
  const CellDemand::Bounds bounds = inside.bounds(0);
  EXPECT_TRUE(bounds.is_ceiling);
  EXPECT_EQ(bounds.lowest, background);
  EXPECT_EQ(bounds.at_centre, background);
  EXPECT_EQ(inside.at({0.9, 0.9, 0.9}), background);
}

TEST(SpacingDemand, grows_too_fast_where_a_source_varies) {
  const Source even{{{{0, 0, 0}, 0.1, 0.1, 0.5}, {{1, 0, 0}, 0.1, 0.1, 0.5}}};
  EXPECT_FALSE(demand_of({}, {even}).grows_too_fast());
  const Source uneven{{{{0, 0, 0}, 0.1, 0.1, 0.5}, {{1, 0, 0}, 0.2, 0.1, 0.5}}};
  EXPECT_TRUE(demand_of({}, {even, uneven}).grows_too_fast());
  EXPECT_FALSE(demand_of(some_points, some_sources).grows_too_fast());
}

TEST(SpacingDemand, counts_what_it_looks_at) {
  // Two sources cost 8 looks each, a list is counted as long as it is; one more for each question.
  const SpacingDemand demand = demand_of({}, some_sources);
  CellDemand inside(demand);
  EXPECT_EQ(inside.looked_at(), 0U);
  inside.enter(cell_at({0.5, 0.5, 0.5}, 1));
  EXPECT_EQ(inside.looked_at(), 17U);
  inside.at({0.5, 0.5, 0.5});
  EXPECT_EQ(inside.looked_at(), 34U);
  // Only the first may be the least there, so that it alone is listed in the cell.
  inside.enter(cell_at({0.5, 0.5, 0.05}, 0.1));
  EXPECT_EQ(inside.looked_at(), 51U);
  inside.at({0.5, 0.5, 0.05});
  EXPECT_EQ(inside.looked_at(), 60U);
  inside.leave();
  inside.at({0.5, 0.5, 0.5});
  EXPECT_EQ(inside.looked_at(), 77U);
}

}  // namespace
}  // namespace tetfarm
