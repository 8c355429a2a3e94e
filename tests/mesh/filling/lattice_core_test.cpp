#include "mesh/filling/lattice_core.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/array_index.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_distance.h"
#include "tests/mesh/filling/lattice_cases.h"

namespace tetfarm {
namespace {

/// A lattice in a sphere, and its core as a complex with the lattice's numbers.
struct Case {
  Case(const SpacingField& field, double radius)
      : domain(root_subdomain(shapes::sphere({0, 0, 0}, radius, 4))),
        nodes(field.lattice_nodes(bounding_box(domain.vertices))),
        grid(nodes),
        is_core(find_core_nodes(nodes, grid, domain,
                                BoxTree(triangle_boxes(domain.vertices, domain.triangles)),
                                find_lattice_boundary(nodes, domain))),
        core(grid, is_core) {
    for (const LatticeNode& node : nodes) complex.points.push_back(node.at);
    complex.node2tet.assign(nodes.size(), -1);
    complex.nodes.resize(at(core.tet_count()));
    complex.neighbours.resize(at(core.tet_count()));
    std::vector<std::int32_t> numbers(nodes.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::int32_t>(i);
    core.write(complex, 0, numbers);
  }

  Subdomain domain;
  std::vector<LatticeNode> nodes;
  LatticeGrid grid;
  std::vector<std::uint8_t> is_core;
  LatticeCore core;
  TetComplex complex;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> made;
    made.emplace_back(lattice_cases::uniform(), 1.0);
    made.emplace_back(lattice_cases::fine(), 1.0);
    made.emplace_back(lattice_cases::graded(), 1.6);
    return made;
  }();
  return all;
}

Tet sorted(Tet tet) {
  std::sort(tet.begin(), tet.end());
  return tet;
}

TEST(LatticeCore, is_a_valid_complex_of_equal_tets) {
  for (const Case& c : cases()) {
    ASSERT_GT(c.core.tet_count(), 100);
    const auto wrong = validate(c.complex);
    EXPECT_TRUE(wrong.empty()) << wrong.front();
    for (const Tet& t : c.complex.nodes) {
      const double edge = c.nodes[at(t[0])].cell_edge;
      const double six_volumes = orient3d(c.complex.points[at(t[0])], c.complex.points[at(t[1])],
                                          c.complex.points[at(t[2])], c.complex.points[at(t[3])]);
      EXPECT_NEAR(six_volumes, edge * edge * edge / 2, 1e-9 * edge * edge * edge);
    }
  }
}

TEST(LatticeCore, has_the_24_tets_of_each_core_node_and_no_others) {
  for (const Case& c : cases()) {
    std::vector<int> tets(c.nodes.size(), 0);
    for (const Tet& t : c.complex.nodes) {
      bool has_core_node = false;
      for (const std::int32_t v : t) {
        ++tets[at(v)];
        has_core_node = has_core_node || c.is_core[at(v)] != 0;
      }
      EXPECT_TRUE(has_core_node);
    }
    for (std::size_t v = 0; v < tets.size(); ++v) {
      if (c.is_core[v] != 0) {
        EXPECT_EQ(tets[v], 24);
      }
    }
  }
}

TEST(LatticeCore, tets_are_those_of_the_delaunay_tetrahedrization) {
  for (const Case& c : cases()) {
    std::vector<Vec3> points = c.domain.vertices;
    const auto first = static_cast<std::int32_t>(points.size());
    for (const LatticeNode& node : c.nodes) points.push_back(node.at);
    const DelaunayTets all = bowyer_watson(points);
    std::set<Tet> known;
    for (const Tet& t : all.complex.nodes) {
      if (t[0] >= 0) known.insert(sorted(t));
    }
    const auto missing =
        std::count_if(c.complex.nodes.begin(), c.complex.nodes.end(), [&](const Tet& t) {
          const std::int32_t moved = first;
          return !known.contains(sorted({t[0] + moved, t[1] + moved, t[2] + moved, t[3] + moved}));
        });
    EXPECT_EQ(missing, 0) << "of " << c.core.tet_count();
  }
}

TEST(LatticeCore, hull_is_every_face_without_neighbour_and_has_no_core_node) {
  for (const Case& c : cases()) {
    std::size_t open = 0;
    for (const auto& neighbours : c.complex.neighbours) {
      open += static_cast<std::size_t>(std::count(neighbours.begin(), neighbours.end(), no_face));
    }
    EXPECT_EQ(c.core.hull().size(), open);
    for (const CoreHullFace& hull : c.core.hull()) {
      EXPECT_EQ(c.complex.neighbours[at(tet_of(hull.face))][at(face_of(hull.face))], no_face);
      EXPECT_EQ(c.complex.nodes[at(tet_of(hull.face))], hull.tet);
      for (const std::int32_t v : c.complex.face_nodes(hull.face)) EXPECT_FALSE(c.core.is_core(v));
    }
  }
}

TEST(LatticeCore, of_one_node_has_24_tets_and_as_many_faces_round_it) {
  const Case& c = cases().front();
  std::size_t centres = 0;
  const std::vector<std::int32_t> core_nodes = c.core.core_nodes();
  constexpr std::size_t every = 17;
  for (std::size_t i = 0; i < core_nodes.size(); i += every) {
    std::vector<std::uint8_t> is_core(c.nodes.size(), 0);
    is_core[at(core_nodes[i])] = 1;
    const LatticeCore core(c.grid, is_core);
    EXPECT_EQ(core.tet_count(), 24);
    EXPECT_EQ(core.hull().size(), 24U);
    for (std::int32_t slot = 0; slot < c.grid.slot_count(); ++slot) {
      centres += c.grid.centre(slot) == core_nodes[i] ? 1U : 0U;
    }
  }
  EXPECT_GT(centres, 0U) << "nodes at centres of cells, and";
  EXPECT_GT(core_nodes.size() / every, centres) << "nodes at their corners";
}

TEST(LatticeCore, keeps_away_from_the_boundary) {
  for (const Case& c : cases()) {
    std::size_t near = 0;
    const std::vector<std::int32_t> core_nodes = c.core.core_nodes();
    constexpr std::size_t every = 7;
    for (std::size_t i = 0; i < core_nodes.size(); i += every) {
      const LatticeNode& node = c.nodes[at(core_nodes[i])];
      for (const Triangle& t : c.domain.triangles) {
        const auto p = [&](std::size_t k) { return c.domain.vertices[at(t[k])]; };
        const double distance2 = distance2_to_triangle(node.at, p(0), p(1), p(2));
        EXPECT_GE(distance2, core_reach * core_reach * node.cell_edge * node.cell_edge);
        if (distance2 < 2.3 * 2.3 * node.cell_edge * node.cell_edge) ++near;
      }
    }
    EXPECT_GT(near, 0U);
  }
}

TEST(LatticeCore, leaves_nodes_out_that_it_shall_not_have) {
  Case c(lattice_cases::uniform(), 1.0);
  const std::int32_t before = c.core.tet_count();
  const std::vector<std::int32_t> first = {c.core.core_nodes().front()};
  c.core.leave_out(first);
  EXPECT_FALSE(c.core.is_core(first[0]));
  EXPECT_LT(c.core.tet_count(), before);
  c.core.leave_out(c.core.core_nodes());
  EXPECT_EQ(c.core.tet_count(), 0);
  EXPECT_TRUE(c.core.hull().empty());
}

}  // namespace
}  // namespace tetfarm
