#include "mesh/adaptation/true_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tetfarm {
namespace {

/// y = x² from x = -1 to 1.
class Parabola : public TrueCurve {
 public:
  Parabola() { samples_ = CurveSamples(*this, {0, 0.5, 1, 1.5, 2}); }
  double length() const override { return 2; }
  bool is_closed() const override { return false; }
  Vec2 at(double t) const override { return {t - 1, (t - 1) * (t - 1)}; }
  Vec2 direction(double t) const override { return {1, 2 * (t - 1)}; }
  double nearest(const Vec2& p) const override { return samples_.nearest(*this, p); }

 private:
  CurveSamples samples_;
};

TEST(TrueCurve, finds_its_own_places_again) {
  const Parabola parabola;
  for (int i = 0; i <= 200; ++i) {
    const double t = 0.01 * i;
    EXPECT_NEAR(parabola.nearest(parabola.at(t)), t, 1e-14) << t;
  }
}

TEST(TrueCurve, is_nearest_where_the_way_to_a_point_is_square_to_it) {
  const Parabola parabola;
  for (const double t : {0.1, 0.6, 1.0, 1.3, 1.9}) {
    for (const double off : {-0.2, -1e-6, 1e-9, 0.1}) {
      const Vec2 place = parabola.at(t);
      const Vec2 direction = parabola.direction(t);
      const double size = std::hypot(direction.x, direction.y);
      const Vec2 p{place.x - off * direction.y / size, place.y + off * direction.x / size};
      EXPECT_NEAR(parabola.nearest(p), t, 1e-14) << t << " " << off;
    }
  }
}

TEST(TrueCurve, is_nearest_at_an_end_to_what_lies_beyond) {
  const Parabola parabola;
  EXPECT_EQ(parabola.nearest({3, 1}), 2);
  EXPECT_EQ(parabola.nearest({-3, 1}), 0);
}

TEST(TrueCurve, takes_the_nearer_of_two_places_that_are_nearest_round_about) {
  const Parabola parabola;
  EXPECT_GT(parabola.nearest({1e-3, 3}), 1);
  EXPECT_LT(parabola.nearest({-1e-3, 3}), 1);
}

}  // namespace
}  // namespace tetfarm
