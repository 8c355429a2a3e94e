#include "mesh/geometry/integer_sphere.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace tetfarm {
namespace {

__extension__ using Wide = __int128;

constexpr int coordinate_bits = 60;
constexpr int mantissa_bits = 52;

/// (x, y, z) of a, b, c, d, e in this order, as multiples of a power of two.
using Coordinates = std::array<std::int64_t, 15>;
/// The rows of the determinant: a, b, c and d as seen from e.
template <class Number>
using Rows = std::array<std::array<Number, 3>, 4>;

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
    const auto bits = std::bit_cast<std::uint64_t>(from[i]);
    const int shift = exponent_of(bits) - last_bit;
    const std::uint64_t mantissa = mantissa_of(bits);
    const auto size =
        static_cast<std::int64_t>(shift >= 0 ? mantissa << shift : mantissa >> -shift);
    to[i] = from[i] == 0 ? 0 : from[i] < 0 ? -size : size;
  }
  return true;
}

/// The rows, shifted as far as all have zeros at their ends; gives the bits that the largest takes.
int make_rows(const Coordinates& c, Rows<std::int64_t>& rows) {
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

/// Of rows that `Number` has room for: five times their bits, and six more.
template <class Number>
int sign_in_one_number(const Rows<std::int64_t>& v) {
  const auto pair = [&v](std::size_t p, std::size_t q, std::size_t i, std::size_t j) {
    return Number{v[p][i] * v[q][j] - v[p][j] * v[q][i]};
  };
  const auto minor = [&](std::size_t p, std::size_t q, std::size_t r) {
    return pair(p, q, 1, 2) * v[r][0] + pair(p, q, 2, 0) * v[r][1] + pair(p, q, 0, 1) * v[r][2];
  };
  const auto lift = [&v](std::size_t p) {
    return v[p][0] * v[p][0] + v[p][1] * v[p][1] + v[p][2] * v[p][2];
  };
  return sign_of<Number>(minor(1, 2, 3) * lift(0) - minor(0, 2, 3) * lift(1) +
                         (minor(0, 1, 3) * lift(2) - minor(0, 1, 2) * lift(3)));
}

constexpr int digit_bits = 56;
constexpr Wide digit_mask = (Wide{1} << digit_bits) - 1;

/// Moves what is above the digits of the columns up; the last keeps all, and the sign.
template <std::size_t count>
std::array<std::int64_t, count> carried(std::array<Wide, count> columns) {
  std::array<std::int64_t, count> digits;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    columns[i + 1] += columns[i] >> digit_bits;
    digits[i] = static_cast<std::int64_t>(columns[i] & digit_mask);
  }
  digits[count - 1] = static_cast<std::int64_t>(columns[count - 1]);
  return digits;
}

/// Determinant of three rows of 61 bits: 186 bits.
std::array<std::int64_t, 4> minor_digits(const Rows<std::int64_t>& v, std::size_t p, std::size_t q,
                                         std::size_t r) {
  std::array<Wide, 4> columns{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto pair = carried<3>({Wide{v[p][j]} * v[q][k] - Wide{v[p][k]} * v[q][j], 0, 0});
    for (std::size_t digit = 0; digit < 3; ++digit) columns[digit] += Wide{pair[digit]} * v[r][i];
  }
  return carried(columns);
}

/// Of rows of 61 bits: 312 bits.
int sign_in_digits(const Rows<std::int64_t>& v) {
  static constexpr std::array<std::array<std::size_t, 3>, 4> others = {
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};  // turned so that all terms are added
  std::array<Wide, 6> columns{};
  for (std::size_t p = 0; p < 4; ++p) {
    const auto minor = minor_digits(v, others[p][0], others[p][1], others[p][2]);
    Wide lift = 0;
    for (const std::int64_t x : v[p]) lift += Wide{x} * x;
    const auto lift_digits = carried<3>({lift, 0, 0});
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 3; ++j) columns[i + j] += Wide{minor[i]} * lift_digits[j];
    }
  }
  const auto digits = carried(columns);
  if (digits[5] != 0) return sign_of(digits[5]);
  return std::any_of(digits.begin(), digits.end(), [](std::int64_t x) { return x != 0; }) ? 1 : 0;
}

}  // namespace

std::optional<int> integer_insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                    const Vec3& e) {
  Coordinates whole;
  if (!make_whole({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, e.x, e.y, e.z},
                  whole)) {
    return std::nullopt;
  }
  Rows<std::int64_t> rows;
  const int bits = make_rows(whole, rows);
  // Each of the four terms is at most 3 · 5.2 times the fifth power of the largest number.
  if (bits <= 11) return sign_in_one_number<std::int64_t>(rows);
  if (bits <= 24) return sign_in_one_number<Wide>(rows);
  return sign_in_digits(rows);
}

}  // namespace tetfarm
