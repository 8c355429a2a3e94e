#include "mesh/geometry/integer_sphere.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace tetfarm {
namespace {

__extension__ using Wide = __int128;

constexpr int coordinate_bits = 62;
constexpr int row_bits = 59;
constexpr int mantissa_bits = 52;

/// (x, y, z) of a, b, c, d, e in this order, as multiples of a power of two.
using Coordinates = std::array<std::int64_t, 15>;
using Row = std::array<std::int64_t, 3>;
/// Of the determinant: a, b, c and d as seen from e.
using Rows = std::array<Row, 4>;

int exponent_of(std::uint64_t bits) { return static_cast<int>(bits >> mantissa_bits & 0x7ffU); }
std::uint64_t mantissa_of(std::uint64_t bits) {
  constexpr std::uint64_t leading = std::uint64_t{1} << mantissa_bits;
  return (bits & (leading - 1)) | leading;
}

/// False when they take too many bits. Coordinates are 0 or of an exponent that has a leading bit.
bool make_whole(const std::array<double, 15>& from, Coordinates& to) {
  int last_bit = 0x1000;  // the least place of a bit that is set
  int first_bit = 0;
  for (const double x : from) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (x == 0) continue;
    const int exponent = exponent_of(bits);
    if (exponent == 0) return false;
    last_bit = std::min(last_bit, exponent + std::countr_zero(mantissa_of(bits)));
    first_bit = std::max(first_bit, exponent + mantissa_bits);
  }
  if (first_bit - last_bit >= coordinate_bits) return false;
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i] = 0;
    if (from[i] == 0) continue;
    const auto bits = std::bit_cast<std::uint64_t>(from[i]);
    const int shift = exponent_of(bits) - last_bit;
    const std::uint64_t mantissa = mantissa_of(bits);
    const auto size =
        static_cast<std::int64_t>(shift >= 0 ? mantissa << shift : mantissa >> -shift);
    to[i] = from[i] < 0 ? -size : size;
  }
  return true;
}

/// The rows, shifted as far as all have zeros at their ends; gives the bits that the largest takes.
int make_rows(const Coordinates& c, Rows& rows) {
  std::uint64_t sizes = 0;
  std::uint64_t ends = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::int64_t difference = c[i] - c[12 + i % 3];
    rows[i / 3][i % 3] = difference;
    sizes |= static_cast<std::uint64_t>(difference < 0 ? -difference : difference);
    ends |= static_cast<std::uint64_t>(difference);
  }
  if (ends == 0) return 0;
  const int zeros = std::countr_zero(ends);
  for (auto& row : rows) {
    for (std::int64_t& x : row) x >>= zeros;
  }
  return static_cast<int>(std::bit_width(sizes)) - zeros;
}

template <class Number>
int sign_of(Number x) {
  return (x > 0) - (x < 0);
}

/// The cross product of two rows, whose products `Number` holds.
template <class Number>
[[gnu::always_inline]] inline std::array<Number, 3> cross(const Row& p, const Row& q) {
  const auto pair = [&](std::size_t i, std::size_t j) {
    return Number{p[i]} * q[j] - Number{p[j]} * q[i];
  };
  return {pair(1, 2), pair(2, 0), pair(0, 1)};
}

template <class Number>
[[gnu::always_inline]] inline Number lift(const Row& p) {
  return Number{p[0]} * p[0] + Number{p[1]} * p[1] + Number{p[2]} * p[2];
}

// The determinant of the rows a, b, c, d and their squared lengths is
//   bcd |a|² - acd |b|² + abd |c|² - abc |d|²
// with the products of three rows bcd = (c x d) b, acd = (c x d) a, abd = (a x b) d, abc = (a x b)
// c.

/// Of rows that `Number` has room for: five times their bits, and six more.
template <class Number>
int sign_in_one_number(const Rows& v) {
  const auto ab = cross<Number>(v[0], v[1]);
  const auto cd = cross<Number>(v[2], v[3]);
  const auto product = [](const std::array<Number, 3>& pair, const Row& row) {
    return pair[0] * row[0] + pair[1] * row[1] + pair[2] * row[2];
  };
  return sign_of<Number>(
      (product(cd, v[1]) * lift<Number>(v[0]) - product(cd, v[0]) * lift<Number>(v[1])) +
      (product(ab, v[3]) * lift<Number>(v[2]) - product(ab, v[2]) * lift<Number>(v[3])));
}

constexpr int digit_bits = 60;
constexpr Wide digit_mask = (Wide{1} << digit_bits) - 1;

std::int64_t low_digit(Wide x) { return static_cast<std::int64_t>(x & digit_mask); }
std::int64_t above_low_digit(Wide x) { return static_cast<std::int64_t>(x >> digit_bits); }

/// Of at most 120 bits and a sign, which is that of the high digit.
struct TwoDigits {
  std::int64_t low;
  std::int64_t high;

  explicit TwoDigits(Wide x) : low(low_digit(x)), high(above_low_digit(x)) {}
};

/// The same in three: products of three rows, at most 180 bits.
struct ThreeDigits {
  std::int64_t low;
  std::int64_t middle;
  std::int64_t high;
};

[[gnu::always_inline]] inline ThreeDigits product(const std::array<TwoDigits, 3>& pair,
                                                  const Row& row) {
  const Wide low =
      Wide{pair[0].low} * row[0] + Wide{pair[1].low} * row[1] + Wide{pair[2].low} * row[2];
  const Wide high = Wide{pair[0].high} * row[0] + Wide{pair[1].high} * row[1] +
                    Wide{pair[2].high} * row[2] + (low >> digit_bits);
  return {low_digit(low), low_digit(high), above_low_digit(high)};
}

/// A sum of products; what is above each digit is still to be carried on. 2^120 times the number of
/// products in a column is its bound.
struct Columns {
  std::array<Wide, 4> at{};

  [[gnu::always_inline]] void add(const ThreeDigits& x, const TwoDigits& y) {
    at[0] += Wide{x.low} * y.low;
    at[1] += Wide{x.low} * y.high + Wide{x.middle} * y.low;
    at[2] += Wide{x.middle} * y.high + Wide{x.high} * y.low;
    at[3] += Wide{x.high} * y.high;
  }
  int sign() {
    for (std::size_t i = 0; i < 3; ++i) at[i + 1] += at[i] >> digit_bits;
    if (at[3] != 0) return sign_of(at[3]);
    return ((at[0] | at[1] | at[2]) & digit_mask) != 0 ? 1 : 0;
  }
};

/// Of rows of row_bits.
int sign_in_digits(const Rows& v) {
  const auto digits_of = [](const std::array<Wide, 3>& x) {
    return std::array<TwoDigits, 3>{TwoDigits(x[0]), TwoDigits(x[1]), TwoDigits(x[2])};
  };
  const auto ab = digits_of(cross<Wide>(v[0], v[1]));
  const auto cd = digits_of(cross<Wide>(v[2], v[3]));
  Columns sum;
  sum.add(product(cd, v[1]), TwoDigits(lift<Wide>(v[0])));
  sum.add(product(cd, v[0]), TwoDigits(-lift<Wide>(v[1])));
  sum.add(product(ab, v[3]), TwoDigits(lift<Wide>(v[2])));
  sum.add(product(ab, v[2]), TwoDigits(-lift<Wide>(v[3])));
  return sum.sign();
}

}  // namespace

std::optional<int> integer_insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                    const Vec3& e) {
  Coordinates whole;
  if (!make_whole({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z},
                  whole)) {
    return std::nullopt;
  }
  Rows rows;
  const int bits = make_rows(whole, rows);
  // Each of the four terms is at most 3 · 5.2 times the fifth power of the largest number.
  if (bits <= 11) return sign_in_one_number<std::int64_t>(rows);
  if (bits <= 24) return sign_in_one_number<Wide>(rows);
  if (bits <= row_bits) return sign_in_digits(rows);
  return std::nullopt;
}

}  // namespace tetfarm
