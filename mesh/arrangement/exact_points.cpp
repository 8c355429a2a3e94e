#include "mesh/arrangement/exact_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetfarm {
namespace {

void round_near(ExactPoint& point) {
  point.near = {point.at[0].get_d(), point.at[1].get_d(), point.at[2].get_d()};
}

constexpr int bits_of_double = 53;

using WholePoint = std::array<mpz_class, 3>;

/// The exponent of two, 0 or less, of which all coordinates are whole multiples.
int least_bit(const std::array<Vec3, 5>& points) {
  int least = 0;
  for (const Vec3& p : points) {
    for (int i = 0; i < 3; ++i) {
      if (p[i] == 0) continue;
      int exponent = 0;
      std::frexp(p[i], &exponent);
      least = std::min(least, exponent - bits_of_double);
    }
  }
  return least;
}

WholePoint whole_point(const Vec3& p, int bit) {
  WholePoint whole;
  for (std::size_t i = 0; i < 3; ++i) {
    int exponent = 0;
    const double digits = std::frexp(p[static_cast<int>(i)], &exponent);
    whole[i] = std::ldexp(digits, bits_of_double);
    if (digits != 0) whole[i] <<= static_cast<mp_bitcnt_t>(exponent - bits_of_double - bit);
  }
  return whole;
}

struct Seen {
  double u;
  double v;
};

Seen seen(const Vec3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// What the determinant of rounded coordinates may be off by: each difference of two by a few last
/// bits of the largest coordinate.
double error_of_turn(const Seen& a, const Seen& b, const Seen& c) {
  constexpr double bits = 1e-15;
  const double largest = std::max(
      {std::abs(a.u), std::abs(a.v), std::abs(b.u), std::abs(b.v), std::abs(c.u), std::abs(c.v)});
  const double longest = std::max(
      {std::abs(a.u - c.u), std::abs(a.v - c.v), std::abs(b.u - c.u), std::abs(b.v - c.v)});
  return 8 * bits * largest * (longest + bits * largest);
}

/// (x - y) without its denominator, which is positive.
mpz_class scaled_difference(const mpq_class& x, const mpq_class& y) {
  return x.get_num() * y.get_den() - y.get_num() * x.get_den();
}

int sign_of(int order) { return (order > 0) - (order < 0); }

/// The sign of seen_area, in whole numbers: nothing has to be reduced for it.
int exact_turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
  const auto u = static_cast<std::size_t>((axis + 1) % 3);
  const auto v = static_cast<std::size_t>((axis + 2) % 3);
  const mpz_class first = scaled_difference(a.at[u], c.at[u]) * scaled_difference(b.at[v], c.at[v]);
  const mpz_class second =
      scaled_difference(a.at[v], c.at[v]) * scaled_difference(b.at[u], c.at[u]);
  return sign_of(cmp(first * a.at[v].get_den() * b.at[u].get_den(),
                     second * a.at[u].get_den() * b.at[v].get_den()));
}

}  // namespace

ExactPoint exact_point(const Vec3& p) {
  return {{mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}, p};
}

Box3 box_round(const ExactPoint& p) {
  Box3 box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::nextafter(p.near[i], -HUGE_VAL);
    box.high[i] = std::nextafter(p.near[i], HUGE_VAL);
  }
  return box;
}

ExactPoint point_between(const ExactPoint& p, const ExactPoint& q, const mpq_class& share) {
  ExactPoint between;
  for (std::size_t i = 0; i < 3; ++i) {
    between.at[i] = p.at[i] + share * (q.at[i] - p.at[i]);
  }
  round_near(between);
  return between;
}

ExactPoint plane_crossing(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc) {
  // In whole numbers of the least bit that any coordinate has: fractions would be reduced again and
  // again on the way.
  const int bit = least_bit({p, q, abc[0], abc[1], abc[2]});
  const WholePoint a = whole_point(abc[0], bit);
  const WholePoint b = whole_point(abc[1], bit);
  const WholePoint c = whole_point(abc[2], bit);
  const WholePoint from = whole_point(p, bit);
  const WholePoint to = whole_point(q, bit);
  mpz_class height_from;
  mpz_class height_to;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const mpz_class normal = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    height_from += normal * (from[i] - a[i]);
    height_to += normal * (to[i] - a[i]);
  }
  const mpz_class difference = height_from - height_to;
  ExactPoint crossing;
  for (std::size_t i = 0; i < 3; ++i) {
    crossing.at[i] = mpq_class(to[i] * height_from - from[i] * height_to, difference);
    crossing.at[i].canonicalize();
    crossing.at[i] >>= static_cast<mp_bitcnt_t>(-bit);
  }
  round_near(crossing);
  return crossing;
}

mpq_class seen_area(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
  const auto u = static_cast<std::size_t>((axis + 1) % 3);
  const auto v = static_cast<std::size_t>((axis + 2) % 3);
  return (a.at[u] - c.at[u]) * (b.at[v] - c.at[v]) - (a.at[v] - c.at[v]) * (b.at[u] - c.at[u]);
}

int seen_turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
  const Seen pa = seen(a.near, axis);
  const Seen pb = seen(b.near, axis);
  const Seen pc = seen(c.near, axis);
  const double area = (pa.u - pc.u) * (pb.v - pc.v) - (pa.v - pc.v) * (pb.u - pc.u);
  const double error = error_of_turn(pa, pb, pc);
  if (area > error) return 1;
  if (area < -error) return -1;
  return exact_turn(a, b, c, axis);
}

std::int32_t ExactPoints::add(ExactPoint point) {
  std::vector<std::int32_t>& alike = numbers_[{point.near.x, point.near.y, point.near.z}];
  for (const std::int32_t number : alike) {
    if ((*this)[number].at == point.at) return number;
  }
  alike.push_back(size());
  points_.push_back(std::move(point));
  return alike.back();
}

}  // namespace tetfarm
