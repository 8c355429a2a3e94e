#include "mesh/cosmetics/element_passing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/error.h"
#include "mesh/core/validate.h"
#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "tests/mesh/cosmetics/cut_bar.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using trial::Cell;
using trial::CutBar;

std::uint64_t left_or_right(const Cell& cell) { return cell[0] < 8 ? 2 : 3; }

ExtractionOptions so_many_layers(int layers) {
  ExtractionOptions options;
  options.taken_layers = layers;
  return options;
}

/// The sections of a leaf of the bar, its core first.
std::vector<ElementSection> extracted(const CutBar& bar, std::uint64_t heap,
                                      const ExtractionOptions& options = {}) {
  std::vector<InterfaceNodes> leaves;
  for (const auto& [path, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
  const CosmeticOrder order = colour_subdomains(leaves);
  const trial::LeafMesh& part = bar.parts.at(heap);
  for (const SharedNodes& shared : order.shared) {
    if (shared.path.heap != heap) continue;
    ExtractedElements extracted = extract_elements(part.leaf, part.mesh, shared, options);
    extracted.sections.insert(extracted.sections.begin(),
                              core_section(part.leaf, part.mesh, extracted.core));
    return extracted.sections;
  }
  return {};
}

std::vector<ElementSection> all_extracted(const CutBar& bar,
                                          const ExtractionOptions& options = {}) {
  std::vector<ElementSection> all;
  for (const auto& [heap, part] : bar.parts) {
    for (ElementSection& section : extracted(bar, heap, options)) all.push_back(std::move(section));
  }
  return all;
}

/// Makes the cubes' tets those of a body-centred cubic lattice.
Vec3 on_the_lattice(const Cell& corner) {
  const Vec3 p = trial::on_the_grid(corner);
  return {0.5 * (p.y + p.z - p.x), 0.5 * (p.z + p.x - p.y), 0.5 * (p.x + p.y - p.z)};
}

std::size_t taken_tets(const CutBar& bar, std::uint64_t heap) {
  std::size_t taken = 0;
  for (const ElementSection& section : extracted(bar, heap)) {
    if (section.sharers.size() > 1) taken += section.tets.size();
  }
  return taken;
}

TEST(ElementPassing, nothing_is_taken_at_a_cut_through_an_even_lattice) {
  const CutBar bar({16, 4, 4}, left_or_right, on_the_lattice);
  EXPECT_EQ(taken_tets(bar, 2), 0U);
  EXPECT_EQ(taken_tets(bar, 3), 0U);
}

TEST(ElementPassing, what_has_a_node_beside_the_lattice_is_taken_at_a_cut) {
  const Cell moved = {8, 2, 2};
  const CutBar bar({16, 4, 4}, left_or_right, [&](const Cell& corner) {
    Vec3 p = on_the_lattice(corner);
    if (corner == moved) p.x += 0.02;
    return p;
  });
  const CutBar cubes({16, 4, 4}, left_or_right);
  EXPECT_GT(taken_tets(bar, 2), 0U);
  EXPECT_GT(taken_tets(bar, 3), 0U);
  EXPECT_LT(taken_tets(bar, 2), taken_tets(cubes, 2));
}

TEST(ElementPassing, as_many_layers_at_a_cut_leave_the_core_as_are_asked_for) {
  const CutBar bar({16, 3, 3}, left_or_right);
  for (const int layers : {1, 3}) {
    const std::vector<ElementSection> sections = extracted(bar, 2, so_many_layers(layers));
    ASSERT_EQ(sections.size(), 2U);
    EXPECT_THAT(sections[0].sharers, ElementsAre(2));
    EXPECT_THAT(sections[1].sharers, ElementsAre(2, 3));
    // A layer of tets is a layer of cubes here, as each cube has nodes on both of its sides.
    EXPECT_EQ(sections[1].tets.size(), 6U * static_cast<unsigned>(layers) * 9);
    EXPECT_EQ(sections[0].tets.size(), 6U * static_cast<unsigned>(8 - layers) * 9);
    for (const ElementSection& section : sections) EXPECT_THAT(validate(section), IsEmpty());
  }
}

TEST(ElementPassing, behind_the_first_layer_only_what_lies_round_bad_elements_leaves_the_core) {
  const CutBar bar({16, 9, 9}, left_or_right);
  const CutBar bent({16, 9, 9}, left_or_right, [](const Cell& corner) {
    return corner == Cell{6, 4, 4} ? Vec3{6, 4, 4.93} : trial::on_the_grid(corner);
  });
  EXPECT_EQ(extracted(bar, 2)[1].tets.size(), 6U * 9 * 9);
  const std::vector<ElementSection> sections = extracted(bent, 2);
  EXPECT_GT(sections[1].tets.size(), 6U * 9 * 9);
  EXPECT_LT(sections[1].tets.size(), 6U * 9 * 9 * 3);
  const auto holds = [&](const Vec3& node) {
    const auto& nodes = sections[1].nodes;
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  EXPECT_TRUE(holds({6, 4, 4.93}));
  EXPECT_FALSE(holds({6, 8, 4}));
  // Two layers round the bad ones, though the second is the fifth from the cut.
  EXPECT_TRUE(holds({3, 4, 4}));
  EXPECT_FALSE(holds({2, 4, 4}));
}

TEST(ElementPassing, what_is_bad_behind_the_layers_where_it_is_sought_stays_in_the_core) {
  const CutBar bent({16, 9, 9}, left_or_right, [](const Cell& corner) {
    return corner == Cell{2, 4, 4} ? Vec3{2, 4, 4.93} : trial::on_the_grid(corner);
  });
  EXPECT_EQ(extracted(bent, 2)[1].tets.size(), 6U * 9 * 9);
}

TEST(ElementPassing, the_core_is_what_is_left_of_its_own_mesh_only) {
  const CutBar bar({16, 3, 3}, left_or_right);
  const trial::LeafMesh& part = bar.parts.at(2);
  CoreElements core;
  core.tets = part.mesh.tets.size() - 1;
  core.taken_tets = {static_cast<std::uint32_t>(part.mesh.tets.size())};
  EXPECT_THROW(core_section(part.leaf, part.mesh, core), Error);
  core.taken_tets = {0, 1};
  EXPECT_THROW(core_section(part.leaf, part.mesh, core), Error);
  core.taken_tets = {0};
  EXPECT_EQ(core_section(part.leaf, part.mesh, core).tets.size(), core.tets);
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
