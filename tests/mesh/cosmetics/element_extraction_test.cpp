#include "mesh/cosmetics/element_extraction.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.h"
#include "tests/mesh/cosmetics/extracted_sections.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using trial::Cell;
using trial::CutBar;
using trial::extracted;
using trial::left_or_right;
using trial::so_many_layers;

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

TEST(ElementExtraction, nothing_is_taken_at_a_cut_through_an_even_lattice) {
  const CutBar bar({16, 4, 4}, left_or_right, on_the_lattice);
  EXPECT_EQ(taken_tets(bar, 2), 0U);
  EXPECT_EQ(taken_tets(bar, 3), 0U);
}

TEST(ElementExtraction, what_has_a_node_beside_the_lattice_is_taken_at_a_cut) {
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

TEST(ElementExtraction, as_many_layers_at_a_cut_leave_the_core_as_are_asked_for) {
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

TEST(ElementExtraction, behind_the_first_layer_only_what_lies_round_bad_elements_leaves_the_core) {
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

TEST(ElementExtraction, what_is_bad_behind_the_layers_where_it_is_sought_stays_in_the_core) {
  const CutBar bent({16, 9, 9}, left_or_right, [](const Cell& corner) {
    return corner == Cell{2, 4, 4} ? Vec3{2, 4, 4.93} : trial::on_the_grid(corner);
  });
  EXPECT_EQ(extracted(bent, 2)[1].tets.size(), 6U * 9 * 9);
}

TEST(ElementExtraction, the_core_is_what_is_left_of_its_own_mesh_only) {
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

}  // namespace
}  // namespace tetfarm
