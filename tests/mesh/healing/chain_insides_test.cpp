#include "mesh/healing/chain_insides.h"

#include <gmock/gmock.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

void add_to_chain(TriangleChain& chain, const SurfaceMesh& body, std::int32_t times) {
  const auto first = static_cast<std::int32_t>(chain.vertices.size());
  chain.vertices.insert(chain.vertices.end(), body.vertices.begin(), body.vertices.end());
  for (const Triangle& t : body.triangles) {
    chain.triangles.push_back({{first + t[0], first + t[1], first + t[2]}, times, 0, false, false});
  }
}

TEST(ChainInsides, are_behind_a_body_that_faces_outward_and_nowhere_of_one_inside_it) {
  TriangleChain chain;
  add_to_chain(chain, shapes::box({0, 0, 0}, {1, 1, 1}, 1), 1);
  const std::size_t outer = chain.triangles.size();
  add_to_chain(chain, shapes::box({0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}, 1), 1);
  const auto insides = insides_of(chain, 1e-6).value();
  for (std::size_t t = 0; t < insides.size(); ++t) {
    EXPECT_TRUE(insides[t][0]);
    EXPECT_EQ(insides[t][1], t >= outer) << "in front of the inner one there is material, too";
  }
}

TEST(ChainInsides, a_cavity_is_outside_where_the_body_is_there_once_and_inside_where_twice) {
  for (const std::int32_t times : {1, 2}) {
    TriangleChain chain;
    add_to_chain(chain, shapes::box({0, 0, 0}, {1, 1, 1}, 1), times);
    const std::size_t outer = chain.triangles.size();
    SurfaceMesh cavity = shapes::box({0.2, 0.2, 0.2}, {0.4, 0.4, 0.4}, 1);
    for (Triangle& t : cavity.triangles) std::swap(t[1], t[2]);
    add_to_chain(chain, cavity, 1);
    EXPECT_EQ(insides_of(chain, 1e-6).value()[outer][0], true);
    EXPECT_EQ(insides_of(chain, 1e-6).value()[outer][1], times == 2);
  }
}

TEST(ChainInsides, what_is_thinner_than_the_tolerance_is_like_its_neighbour) {
  TriangleChain chain;
  add_to_chain(chain, shapes::box({0, 0, 0}, {1, 1, 1e-3}, 1), 1);
  EXPECT_THAT(insides_of(chain, 1e-6).value(), Each(ElementsAre(true, false)));
  EXPECT_THAT(insides_of(chain, 1e-2).value(), Each(ElementsAre(false, false)));
}

TEST(ChainInsides, there_are_none_of_what_is_open) {
  TriangleChain chain;
  add_to_chain(chain, shapes::box({0, 0, 0}, {1, 1, 1}, 1), 1);
  chain.triangles.pop_back();
  EXPECT_FALSE(insides_of(chain, 1e-6));
}

}  // namespace
}  // namespace tetfarm
