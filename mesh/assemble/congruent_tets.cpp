#include "mesh/assemble/congruent_tets.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace tetfarm {
namespace {

constexpr int place_bits = 9;
constexpr std::size_t places = std::size_t{1} << place_bits;  // 128 kB: in the processor's caches

static_assert(sizeof(std::array<Vec3, 6>) == 18 * sizeof(double));

}  // namespace

/// No tet has such edges, whose bits are those of no difference of two nodes.
CongruentTets::CongruentTets() : known_(places) {
  const auto none = std::bit_cast<double>(~std::uint64_t{0});
  for (Known& known : known_) known.edges.fill({none, none, none});
}

/// By the three edges from the first node. Products are added, not multiplied on: they do not wait
/// for each other. Signs and exponents are turned to the low end first: a product takes bits to
/// higher places only.
std::size_t CongruentTets::place_of(const Edges& edges) {
  constexpr std::array<std::uint64_t, 9> factors = {
      0x9e3779b97f4a7c15, 0xc2b2ae3d27d4eb4f, 0x165667b19e3779f9,
      0xd6e8feb86659fd93, 0xa0761d6478bd642f, 0xe7037ed1a0b428db,
      0x8ebc6af09c88c6e3, 0x589965cc75374cc3, 0x1d8e4e27c47d124f};
  constexpr int bits_of_sign_and_exponent = 12;
  std::uint64_t sum = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double number : {edges[i].x, edges[i].y, edges[i].z}) {
      sum += std::rotl(std::bit_cast<std::uint64_t>(number), bits_of_sign_and_exponent) *
             factors[next++];
    }
  }
  sum = (sum ^ (sum >> 32U)) * factors[0];
  return sum >> (64U - place_bits);
}

TetShape CongruentTets::shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Edges edges = {b - a, c - a, d - a, c - b, d - b, d - c};
  Known& known = known_[place_of(edges)];
  if (std::memcmp(&known.edges, &edges, sizeof edges) == 0) {
    known.is_frequent = true;
    TetShape shape = known.shape;
    shape.centroid = 0.25 * (a + b + c + d);
    return shape;
  }
  ++worked_out_;
  const TetShape shape = tet_shape(a, b, c, d);
  if (!known.is_frequent) known = {edges, shape, false};
  known.is_frequent = false;
  return shape;
}

}  // namespace tetfarm
