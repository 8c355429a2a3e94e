#include "mesh/cosmetics/element_passing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mesh/core/validate.h"
#include "tests/mesh/cosmetics/extracted_sections.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using trial::Cell;
using trial::CutBar;
using trial::extracted;
using trial::left_or_right;
using trial::so_many_layers;

std::vector<ElementSection> all_extracted(const CutBar& bar,
                                          const ExtractionOptions& options = {}) {
  std::vector<ElementSection> all;
  for (const auto& [heap, part] : bar.parts) {
    for (ElementSection& section : extracted(bar, heap, options)) all.push_back(std::move(section));
  }
  return all;
}

TEST(ElementPassing, pieces_of_all_leaves_join_to_the_whole_mesh) {
  const CutBar bar({8, 6, 4}, [](const Cell& cell) {
    return cell[0] < 4 ? std::uint64_t{2} : cell[1] < 3 ? std::uint64_t{6} : std::uint64_t{7};
  });
  const JoinedElements joined = join_elements(all_extracted(bar));
  EXPECT_EQ(joined.nodes.size(), 9U * 7 * 5);
  EXPECT_EQ(joined.tets.size(), bar.tets());
  EXPECT_EQ(joined.triangles.size(), bar.surface_triangles);
  const auto surface_nodes = std::count_if(joined.node_origin.begin(), joined.node_origin.end(),
                                           [](const Origin& origin) { return origin.owner == 0; });
  const TetMesh mesh{joined.nodes, joined.tets, static_cast<std::int32_t>(surface_nodes)};
  EXPECT_THAT(validate(mesh, joined.triangles), IsEmpty());
}

TEST(ElementPassing, sharing_out_is_the_reverse_of_joining) {
  const CutBar bar({8, 4, 4}, [](const Cell& cell) {
    return cell[0] < 4 ? std::uint64_t{2} : cell[1] < 2 ? std::uint64_t{6} : std::uint64_t{7};
  });
  const std::vector<ElementSection> sections = extracted(bar, 6);
  std::vector<Sharers> sharers;
  for (const ElementSection& section : sections) sharers.push_back(section.sharers);
  const std::vector<ElementSection> again = share_out_elements(join_elements(sections), sharers);
  ASSERT_EQ(again.size(), sections.size());
  for (std::size_t s = 0; s < sections.size(); ++s) {
    EXPECT_EQ(again[s].node_origin, sections[s].node_origin);
    EXPECT_EQ(again[s].tets, sections[s].tets);
    EXPECT_EQ(again[s].tet_owner, sections[s].tet_owner);
    EXPECT_EQ(again[s].triangles, sections[s].triangles);
    EXPECT_EQ(again[s].triangle_index, sections[s].triangle_index);
  }
}

TEST(ElementPassing, every_tet_at_a_shared_node_is_in_a_section_that_its_own_leaf_shares) {
  const CutBar bar({6, 6, 6}, [](const Cell& cell) {
    return std::uint64_t{8} +
           static_cast<std::uint64_t>(4 * (cell[0] / 3) + 2 * (cell[1] / 3) + cell[2] / 3);
  });
  for (const auto& [heap, part] : bar.parts) {
    for (const ElementSection& section : extracted(bar, heap)) {
      EXPECT_TRUE(std::binary_search(section.sharers.begin(), section.sharers.end(), heap));
      for (const std::uint8_t owner : section.tet_owner) {
        EXPECT_EQ(section.sharers[owner], heap);
      }
    }
  }
}

TEST(ElementPassing, elements_at_the_node_of_many_are_in_the_section_of_many) {
  const CutBar bar({6, 6, 2}, [](const Cell& cell) {
    return std::uint64_t{4} + static_cast<std::uint64_t>(2 * (cell[0] / 3) + cell[1] / 3);
  });
  std::set<Sharers> found;
  for (const ElementSection& section : all_extracted(bar, so_many_layers(2))) {
    found.insert(section.sharers);
    if (section.sharers.size() != 4) continue;
    for (const Vec3& p : section.nodes) {
      EXPECT_LE(std::abs(p.x - 3), 2);
      EXPECT_LE(std::abs(p.y - 3), 2);
    }
  }
  EXPECT_TRUE(found.contains(Sharers{4, 5, 6, 7}));
  EXPECT_TRUE(found.contains(Sharers{4, 6}));
}

/// Of each node of a cut that is not on the surface, the leaves that have all its elements at hand.
std::map<Origin, std::set<std::uint64_t>> leaves_that_may_move(
    const std::vector<ElementSection>& sections) {
  std::map<Origin, std::set<std::uint64_t>> able;
  for (const ElementSection& section : sections) {
    const std::set<std::uint64_t> sharers(section.sharers.begin(), section.sharers.end());
    for (const Origin& origin : section.node_origin) {
      if (origin.owner != 1) continue;
      const auto [found, is_new] = able.try_emplace(origin, sharers);
      if (!is_new) std::erase_if(found->second, [&](auto leaf) { return !sharers.contains(leaf); });
    }
  }
  return able;
}

TEST(ElementPassing, every_node_of_a_cut_can_be_moved_in_some_turn) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    // Cells of five scattered points: cuts meet along lines at all angles.
    std::array<Vec3, 5> middles;
    for (std::size_t i = 0; i < 5; ++i) middles[i] = 10 * trial::random_vector(seed, i);
    const CutBar bar({10, 10, 10}, [&](const Cell& cell) {
      const Vec3 here = trial::on_the_grid(cell) - Vec3{4.5, 4.5, 4.5};
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < 5; ++i) {
        if (norm2(middles[i] - here) < norm2(middles[nearest] - here)) nearest = i;
      }
      return std::uint64_t{8} + nearest;
    });
    int nodes = 0;
    int stuck = 0;
    for (const auto& [origin, leaves] : leaves_that_may_move(all_extracted(bar))) {
      ++nodes;
      stuck += leaves.empty() ? 1 : 0;
    }
    EXPECT_GT(nodes, 100) << seed;
    EXPECT_EQ(stuck, 0) << seed;
  }
}

TEST(ElementPassing, layers_are_counted_from_the_elements_of_one_subdomain) {
  const CutBar bar({16, 2, 2}, left_or_right);
  std::vector<ElementSection> sections = all_extracted(bar, so_many_layers(4));
  std::erase_if(sections, [](const ElementSection& s) { return s.sharers.size() == 1; });
  std::vector<Sharers> sharers;
  for (const ElementSection& section : sections) sharers.push_back(section.sharers);
  const JoinedElements joined = join_elements(sections);
  const std::vector<int> layers = layers_from(joined, sharers, 2, 2);
  for (std::size_t t = 0; t < joined.tets.size(); ++t) {
    double middle = 0;
    for (const std::int32_t v : joined.tets[t]) {
      middle += 0.25 * joined.nodes[static_cast<std::size_t>(v)].x;
    }
    const int expected = middle < 8 ? 0 : middle < 9 ? 1 : middle < 10 ? 2 : 3;
    EXPECT_EQ(layers[t], expected) << middle;
  }
}

}  // namespace
}  // namespace tetfarm
