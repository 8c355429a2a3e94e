/// Exact sums and products of doubles as expansions: sums of non-overlapping doubles, smallest
/// first.
///
/// Source: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates" (1997), sections 2.2–2.6. Zero components are dropped, so numbers of few bits stay
/// short. Needs round-to-nearest IEEE doubles without contraction, and no overflow or underflow.
/// Cost: O(length) a sum, O(product of lengths) a product.
#pragma once

#include <array>
#include <cstddef>

namespace tetfarm {

struct TwoTerms {
  double high;
  double low;
};

inline TwoTerms two_sum(double a, double b) {
  const double x = a + b;
  const double b_virtual = x - a;
  const double a_virtual = x - b_virtual;
  return {x, (a - a_virtual) + (b - b_virtual)};
}

inline TwoTerms fast_two_sum(double larger, double smaller) {
  const double x = larger + smaller;
  return {x, smaller - (x - larger)};
}

inline TwoTerms two_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double x = a * b;
  const double ca = splitter * a;
  const double a_high = ca - (ca - a);
  const double a_low = a - a_high;
  const double cb = splitter * b;
  const double b_high = cb - (cb - b);
  const double b_low = b - b_high;
  return {x, a_low * b_low - (((x - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

/// At most `capacity` components; the value is their exact sum.
template <std::size_t capacity>
struct Expansion {
  std::array<double, capacity> component;
  std::size_t length = 0;

  void append(double value) {
    if (value != 0) component[length++] = value;
  }
  /// Has the sign of the exact value.
  double most_significant() const { return length == 0 ? 0.0 : component[length - 1]; }
};

inline Expansion<2> expansion_of(const TwoTerms& terms) {
  Expansion<2> e;
  e.append(terms.low);
  e.append(terms.high);
  return e;
}

inline Expansion<2> exact_difference(double a, double b) { return expansion_of(two_sum(a, -b)); }

/// a + sign · b for a sign of 1 or -1: the components of both are merged by size and added up.
template <std::size_t n, std::size_t m>
Expansion<n + m> signed_sum(const Expansion<n>& a, const Expansion<m>& b, double sign) {
  Expansion<n + m> sum;
  std::size_t i = 0;
  std::size_t j = 0;
  const auto magnitude = [](double x) { return x < 0 ? -x : x; };
  const auto next = [&] {
    const bool from_a =
        j == b.length || (i < a.length && magnitude(a.component[i]) < magnitude(b.component[j]));
    return from_a ? a.component[i++] : sign * b.component[j++];
  };
  const std::size_t total = a.length + b.length;
  if (total == 0) return sum;
  double q = next();
  for (std::size_t k = 1; k < total; ++k) {
    const TwoTerms t = two_sum(q, next());
    sum.append(t.low);
    q = t.high;
  }
  sum.append(q);
  return sum;
}

template <std::size_t n, std::size_t m>
Expansion<n + m> operator+(const Expansion<n>& a, const Expansion<m>& b) {
  return signed_sum(a, b, 1.0);
}

template <std::size_t n, std::size_t m>
Expansion<n + m> operator-(const Expansion<n>& a, const Expansion<m>& b) {
  return signed_sum(a, b, -1.0);
}

template <std::size_t n>
Expansion<2 * n> scaled(const Expansion<n>& a, double factor) {
  Expansion<2 * n> product;
  if (a.length == 0 || factor == 0) return product;
  TwoTerms t = two_product(a.component[0], factor);
  product.append(t.low);
  double q = t.high;
  for (std::size_t i = 1; i < a.length; ++i) {
    t = two_product(a.component[i], factor);
    const TwoTerms s = two_sum(q, t.low);
    product.append(s.low);
    const TwoTerms f = fast_two_sum(t.high, s.high);
    product.append(f.low);
    q = f.high;
  }
  product.append(q);
  return product;
}

template <std::size_t n, std::size_t m>
Expansion<2 * n * m> operator*(const Expansion<n>& a, const Expansion<m>& b) {
  Expansion<2 * n * m> product;
  for (std::size_t j = 0; j < b.length; ++j) {
    const auto part = scaled(a, b.component[j]);
    const auto sum = product + part;
    product.length = sum.length;
    for (std::size_t k = 0; k < sum.length; ++k) product.component[k] = sum.component[k];
  }
  return product;
}

}  // namespace tetfarm
