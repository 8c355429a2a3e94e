#include "mesh/cosmetics/seam_cosmetics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "mesh/core/tet_quality.h"
#include "mesh/core/validate.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "tests/mesh/cosmetics/cut_bar.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using trial::Cell;
using trial::CutBar;

/// The sections of a cut bar and the order in which its leaves have their turn.
struct Farm {
  CosmeticOrder order;
  std::map<Sharers, ElementSection> sections;
  std::map<std::uint64_t, std::uint32_t> next_node;
  SeamOptions options;

  explicit Farm(const CutBar& bar, const ExtractionOptions& extraction = {}) {
    std::vector<InterfaceNodes> leaves;
    for (const auto& [heap, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
    order = colour_subdomains(leaves);
    std::map<Sharers, std::vector<ElementSection>> pieces;
    for (const SharedNodes& shared : order.shared) {
      const trial::LeafMesh& part = bar.parts.at(shared.path.heap);
      ExtractedElements extracted = extract_elements(part.leaf, part.mesh, shared, extraction);
      extracted.sections.push_back(core_section(part.leaf, part.mesh, extracted.core));
      for (ElementSection& piece : extracted.sections) {
        pieces[piece.sharers].push_back(std::move(piece));
      }
      next_node[shared.path.heap] =
          static_cast<std::uint32_t>(part.mesh.nodes.size() - part.leaf.vertices.size());
    }
    for (const auto& [sharers, list] : pieces) {
      sections[sharers] = join_pieces(list);
    }
  }

  std::vector<ElementSection> of(std::uint64_t self) const {
    std::vector<ElementSection> mine;
    for (const auto& [sharers, section] : sections) {
      const bool shares = std::binary_search(sharers.begin(), sharers.end(), self);
      if (shares && sharers.size() > 1) mine.push_back(section);
    }
    return mine;
  }

  SeamResult give_turn(const ColouredLeaf& leaf) {
    SeamTurn turn{leaf.path.heap, {}, next_node.at(leaf.path.heap)};
    for (const ColouredLeaf& other : order.leaves) {
      if (other.colour < leaf.colour) turn.had_turn.push_back(other.path.heap);
    }
    SeamResult result = improve_seams(of(leaf.path.heap), turn, options);
    for (const ElementSection& section : result.sections) sections[section.sharers] = section;
    return result;
  }

  void give_all_turns() {
    for (std::int32_t colour = 0; colour < 8; ++colour) {
      for (const ColouredLeaf& leaf : order.leaves) {
        if (leaf.colour == colour) give_turn(leaf);
      }
    }
  }

  JoinedElements joined() const {
    std::vector<ElementSection> all;
    for (const auto& [sharers, section] : sections) all.push_back(section);
    return join_elements(all);
  }
};

std::vector<std::string> complaints_of(const JoinedElements& joined) {
  const auto surface_nodes = std::count_if(joined.node_origin.begin(), joined.node_origin.end(),
                                           [](const Origin& origin) { return origin.owner == 0; });
  const TetMesh mesh{joined.nodes, joined.tets, static_cast<std::int32_t>(surface_nodes)};
  return validate(mesh, joined.triangles);
}

double worst_dihedral_deg(const JoinedElements& joined) {
  double worst = 180;
  for (const Tet& tet : joined.tets) {
    const auto p = [&](std::size_t i) { return joined.nodes[static_cast<std::size_t>(tet[i])]; };
    worst = std::min(worst, dihedral_range(p(0), p(1), p(2), p(3)).min_deg);
  }
  return worst;
}

/// Corners of cubes pushed about, never those on the outside of a bar of n³ cubes.
trial::PlaceOfCorner disturbed(int n, std::uint32_t seed, double most) {
  return [n, seed, most](const Cell& corner) {
    Vec3 p = trial::on_the_grid(corner);
    for (int axis = 0; axis < 3; ++axis) {
      if (corner[static_cast<std::size_t>(axis)] % n == 0) return p;
    }
    std::mt19937 random(
        seed + static_cast<std::uint32_t>(corner[0] * 97 + corner[1] * 31 + corner[2] * 7));
    std::uniform_real_distribution<double> push(-most, most);
    for (int axis = 0; axis < 3; ++axis) p[axis] += push(random);
    return p;
  };
}

std::uint64_t octant(const Cell& cell) {
  return std::uint64_t{8} +
         static_cast<std::uint64_t>(4 * (cell[0] / 4) + 2 * (cell[1] / 4) + cell[2] / 4);
}

TEST(SeamCosmetics, a_node_of_a_cut_moves_and_nodes_of_the_surface_do_not) {
  // One node on the cut is far off its place: no side alone may move it.
  const CutBar bar(
      {12, 4, 4},
      [](const Cell& cell) { return cell[0] < 6 ? std::uint64_t{2} : std::uint64_t{3}; },
      [](const Cell& corner) {
        Vec3 p = trial::on_the_grid(corner);
        if (corner == Cell{6, 2, 2}) p.x += 0.95;
        return p;
      });
  Farm farm(bar);
  const JoinedElements before = farm.joined();
  ASSERT_LT(worst_dihedral_deg(before), 5);
  farm.give_all_turns();
  const JoinedElements after = farm.joined();
  EXPECT_THAT(complaints_of(after), IsEmpty());
  EXPECT_GT(worst_dihedral_deg(after), 25);
  for (std::size_t v = 0; v < after.nodes.size(); ++v) {
    if (after.node_origin[v].owner != 0) continue;
    const auto same = std::lower_bound(before.node_origin.begin(), before.node_origin.end(),
                                       after.node_origin[v]);
    EXPECT_EQ(before.nodes[static_cast<std::size_t>(same - before.node_origin.begin())],
              after.nodes[v]);
  }
}

TEST(SeamCosmetics, the_mesh_is_valid_and_its_worst_no_worse_after_every_turn) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    Farm farm(CutBar({8, 8, 8}, octant, disturbed(8, seed, 0.24)));
    const std::size_t triangles = farm.joined().triangles.size();
    double worst = worst_dihedral_deg(farm.joined());
    const double at_first = worst;
    for (std::int32_t colour = 0; colour < 8; ++colour) {
      for (const ColouredLeaf& leaf : farm.order.leaves) {
        if (leaf.colour != colour) continue;
        const SeamResult result = farm.give_turn(leaf);
        for (const ElementSection& section : result.sections) {
          EXPECT_THAT(validate(section), IsEmpty());
        }
        const JoinedElements joined = farm.joined();
        EXPECT_THAT(complaints_of(joined), IsEmpty()) << "after " << leaf.path.heap;
        EXPECT_EQ(joined.triangles.size(), triangles);
        EXPECT_GE(worst_dihedral_deg(joined), worst - 1e-9);
        worst = worst_dihedral_deg(joined);
      }
    }
    EXPECT_GT(worst, at_first + 5) << seed;
  }
}

double smallest_height_of(const JoinedElements& joined) {
  double lowest2 = HUGE_VAL;
  for (const Tet& tet : joined.tets) {
    const auto p = [&](std::size_t i) { return joined.nodes[static_cast<std::size_t>(tet[i])]; };
    lowest2 = std::min(lowest2, cosmetics::smallest_height2(p(0), p(1), p(2), p(3)));
  }
  return std::sqrt(lowest2);
}

TEST(SeamCosmetics, low_elements_are_raised_where_the_spacing_is_known) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const CutBar bar({8, 8, 8}, octant, disturbed(8, seed, 0.24));
    Farm by_shape(bar);
    by_shape.options.cosmetics.spacing = [](const Vec3&) { return 1.4; };
    Farm by_height = by_shape;
    by_shape.options.cosmetics.height_in_spacings = 0;
    by_shape.give_all_turns();
    by_height.give_all_turns();
    const JoinedElements joined = by_height.joined();
    EXPECT_GT(smallest_height_of(joined), 1.05 * smallest_height_of(by_shape.joined())) << seed;
    EXPECT_GT(worst_dihedral_deg(joined), 0.98 * worst_dihedral_deg(by_shape.joined())) << seed;
    EXPECT_THAT(complaints_of(joined), IsEmpty());
  }
}

TEST(SeamCosmetics, cores_and_the_elements_of_others_stay_as_they_are) {
  Farm farm(CutBar(
      {16, 4, 4},
      [](const Cell& cell) {
        return cell[0] < 6 ? std::uint64_t{2} : cell[0] < 11 ? std::uint64_t{6} : std::uint64_t{7};
      },
      disturbed(16, 5, 0.2)));
  const ElementSection others = farm.sections.at({6, 7});
  const ElementSection core = farm.sections.at({2});
  farm.give_turn(farm.order.leaves.front());
  ASSERT_EQ(farm.order.leaves.front().path.heap, 2U);
  EXPECT_EQ(farm.sections.at({6, 7}).nodes, others.nodes);
  EXPECT_EQ(farm.sections.at({6, 7}).tets, others.tets);
  EXPECT_EQ(farm.sections.at({2}).nodes, core.nodes);
}

TEST(SeamCosmetics, two_layers_of_those_who_wait_and_four_of_those_who_had_their_turn) {
  const CutBar bar({16, 4, 4}, [](const Cell& cell) {
    return cell[0] < 8 ? std::uint64_t{2} : std::uint64_t{3};
  });
  ExtractionOptions extraction;
  extraction.taken_layers = 5;
  extraction.sought_layers = 5;
  Farm farm(bar, extraction);
  const SeamResult first = improve_seams(farm.of(2), {2, {}, 0});
  EXPECT_EQ(first.tets, 6 * 16 * (5 + 2));
  const SeamResult second = improve_seams(farm.of(3), {3, {2}, 0});
  EXPECT_EQ(second.tets, 6 * 16 * (5 + 4));
}

TEST(SeamCosmetics, leaves_without_common_nodes_may_have_their_turn_in_any_order) {
  const auto row = [](const Cell& cell) {
    return std::uint64_t{4} + static_cast<std::uint64_t>(cell[0] / 4);
  };
  const CutBar bar({16, 4, 4}, row, disturbed(16, 3, 0.22));
  Farm forth(bar);
  Farm back(bar);
  std::vector<ColouredLeaf> first;
  for (const ColouredLeaf& leaf : forth.order.leaves) {
    if (leaf.colour == 0) first.push_back(leaf);
  }
  ASSERT_GE(first.size(), 2U);
  for (const ColouredLeaf& leaf : first) forth.give_turn(leaf);
  std::reverse(first.begin(), first.end());
  for (const ColouredLeaf& leaf : first) back.give_turn(leaf);
  for (const auto& [sharers, section] : forth.sections) {
    EXPECT_EQ(section.nodes, back.sections.at(sharers).nodes);
    EXPECT_EQ(section.tets, back.sections.at(sharers).tets);
    EXPECT_EQ(section.node_origin, back.sections.at(sharers).node_origin);
  }
}

TEST(SeamCosmetics, new_nodes_have_numbers_of_their_own_and_lost_ones_are_told) {
  std::size_t made = 0;
  std::size_t lost = 0;
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    Farm farm(CutBar({8, 8, 3}, octant, disturbed(8, seed, 0.24)));
    // So much is wanted that nodes come and go.
    farm.options.cosmetics.wanted_dihedral_deg = 45;
    farm.options.cosmetics.rebuilt_dihedral_deg = 40;
    std::vector<Origin> known = farm.joined().node_origin;
    std::vector<Origin> gone;
    for (std::int32_t colour = 0; colour < 8; ++colour) {
      for (const ColouredLeaf& leaf : farm.order.leaves) {
        if (leaf.colour != colour) continue;
        const SeamResult result = farm.give_turn(leaf);
        gone.insert(gone.end(), result.gone.begin(), result.gone.end());
        for (std::uint32_t n = farm.next_node.at(leaf.path.heap); n < result.next_node; ++n) {
          known.push_back({leaf.path.heap, n});
          ++made;
        }
      }
    }
    std::sort(known.begin(), known.end());
    std::sort(gone.begin(), gone.end());
    lost += gone.size();
    std::vector<Origin> left;
    std::set_difference(known.begin(), known.end(), gone.begin(), gone.end(),
                        std::back_inserter(left));
    EXPECT_EQ(farm.joined().node_origin, left) << seed;
  }
  EXPECT_GT(made, 0U);
  EXPECT_GT(lost, 0U);
}

TEST(SeamCosmetics, a_subdomain_without_neighbours_has_nothing_to_do) {
  const SeamResult result = improve_seams({}, {5, {}, 17});
  EXPECT_THAT(result.sections, IsEmpty());
  EXPECT_EQ(result.next_node, 17U);
}

}  // namespace
}  // namespace tetfarm
