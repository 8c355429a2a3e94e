#include "mesh/core/tet_replacement.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/array_index.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// Two tets on both sides of the triangle 0, 1, 2, with the apexes 3 above and 4 below.
TetComplex two_tets() {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 1}, {1, 1, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  return make_tet_complex(mesh);
}

/// The three tets round the edge from 4 to 3 that fill the same space.
std::vector<Tet> three_tets() { return {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}}; }

/// Four tets round node 4, inside the tet of the other nodes.
TetComplex four_round_a_node() {
  TetMesh mesh;
  mesh.nodes = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}};
  mesh.tets = {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}};
  return make_tet_complex(mesh);
}

const std::vector<std::int32_t> both = {0, 1};

bool would_fill(const TetComplex& complex, const std::vector<std::int32_t>& old_tets,
                const std::vector<Tet>& new_tets) {
  TetMarks marks(complex.nodes.size());
  return are_pairs(open_faces(complex, old_tets, new_tets, marks));
}

std::vector<std::int32_t> replace(TetComplex& complex, const std::vector<std::int32_t>& old_tets,
                                  const std::vector<Tet>& new_tets) {
  TetMarks marks(complex.nodes.size());
  const std::vector<OpenFace> faces = open_faces(complex, old_tets, new_tets, marks);
  EXPECT_TRUE(are_pairs(faces));
  const std::vector<std::int32_t> numbers = exchange_tets(complex, old_tets, new_tets);
  glue_pairs(complex, faces, numbers);
  return numbers;
}

TEST(TetReplacement, leaves_a_valid_complex_there_and_back) {
  TetComplex complex = two_tets();
  ASSERT_THAT(validate(complex), IsEmpty());
  const std::vector<std::int32_t> three = replace(complex, both, three_tets());
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.live_tets(), 3U);
  replace(complex, three, {{0, 1, 2, 3}, {0, 2, 1, 4}});
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.live_tets(), 2U);
  for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
    if (!complex.is_live(t)) continue;
    const auto& across = complex.neighbours[at(t)];
    EXPECT_EQ(std::count(across.begin(), across.end(), no_face), 3);
  }
}

TEST(TetReplacement, joins_new_tets_to_those_beyond_the_cavity) {
  TetComplex complex = four_round_a_node();
  ASSERT_THAT(validate(complex), IsEmpty());
  // Tets 0 and 1 share the edge 2, 3; beyond them are 2 and 3.
  const std::vector<Tet> same = {complex.nodes[1], complex.nodes[0]};
  const std::vector<std::int32_t> numbers = replace(complex, both, same);
  EXPECT_THAT(validate(complex), IsEmpty());
  for (const std::int32_t t : numbers) {
    const auto& across = complex.neighbours[at(t)];
    EXPECT_EQ(std::count(across.begin(), across.end(), no_face), 1);
  }
}

TEST(TetReplacement, leaves_out_a_node_that_no_new_tet_holds) {
  TetComplex complex = four_round_a_node();
  replace(complex, {0, 1, 2, 3}, {{0, 1, 2, 3}});
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.live_tets(), 1U);
  EXPECT_EQ(complex.node2tet[4], -1);
}

TEST(TetReplacement, refuses_tets_that_do_not_fill_the_cavity) {
  const TetComplex complex = two_tets();
  EXPECT_TRUE(would_fill(complex, both, three_tets()));
  const std::vector<Tet> three = three_tets();
  EXPECT_FALSE(would_fill(complex, both, {three[0], three[1]})) << "one is missing";
  EXPECT_FALSE(would_fill(complex, {0}, three)) << "they fill more";
  EXPECT_FALSE(would_fill(complex, both, {three[0], three[1], {0, 2, 4, 3}})) << "one is turned";
  std::vector<Tet> turned;
  for (const auto& [a, b, c, d] : three) turned.push_back({b, a, c, d});
  EXPECT_FALSE(would_fill(complex, both, turned)) << "all are turned";
  EXPECT_FALSE(would_fill(complex, both, {three[0], three[1], three[2], three[0], three[0]}))
      << "a face has more than one partner";
  EXPECT_FALSE(would_fill(complex, both, {}));
}

TEST(TetReplacement, refuses_two_pairs_on_one_face) {
  const std::array<std::int32_t, 3> nodes = {0, 1, 2};
  const std::vector<OpenFace> outer_and_new = {{nodes, no_face, true, false},
                                               {nodes, 0, false, false}};
  const std::vector<OpenFace> both_new = {{nodes, 1, false, true}, {nodes, 2, false, false}};
  ASSERT_TRUE(are_pairs(outer_and_new));
  ASSERT_TRUE(are_pairs(both_new));
  std::vector<OpenFace> all = outer_and_new;
  all.insert(all.end(), both_new.begin(), both_new.end());
  EXPECT_FALSE(are_pairs(all));
}

TEST(TetReplacementDeathTest, takes_no_tet_out_twice) {
  TetComplex complex = two_tets();
  EXPECT_DEATH(exchange_tets(complex, std::vector<std::int32_t>{0, 0}, {}), "is_live");
}

}  // namespace
}  // namespace tetfarm
