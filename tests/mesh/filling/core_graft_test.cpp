#include "mesh/filling/core_graft.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/geometry/bowyer_watson.h"
#include "tests/mesh/filling/lattice_cases.h"

namespace tetfarm {
namespace {

/// The Delaunay tets of a sphere and of the lattice round it but for the core, whose place is
/// hollow: tets there have nodes of its hull only. Nothing is constrained.
class CoreSeatTest : public testing::Test {
 protected:
  CoreSeatTest()
      : domain_(root_subdomain(shapes::sphere({0, 0, 0}, 1, 3))),
        nodes_(lattice_cases::uniform().lattice_nodes(bounding_box(domain_.vertices))) {
    const LatticeGrid grid(nodes_);
    core_ = LatticeCore(
        grid, find_core_nodes(nodes_, grid, domain_,
                              BoxTree(triangle_boxes(domain_.vertices, domain_.triangles)),
                              find_lattice_boundary(nodes_, domain_)));
  }
  /// Without the lattice node `but`.
  void make_complex(std::int32_t but = -1) {
    std::vector<Vec3> points = domain_.vertices;
    numbers_.assign(nodes_.size(), -1);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto node = static_cast<std::int32_t>(i);
      if (core_.is_core(node) || node == but) continue;
      numbers_[i] = static_cast<std::int32_t>(points.size());
      points.push_back(nodes_[i].at);
    }
    complex_ = bowyer_watson(points).complex;
    constrained_.assign(complex_.nodes.size(), 0);
  }
  CoreSeat seat() const { return find_core_seat(complex_, constrained_, core_, numbers_); }
  std::ptrdiff_t tets() const {
    return std::count_if(complex_.nodes.begin(), complex_.nodes.end(),
                         [](const Tet& t) { return t[0] >= 0; });
  }
  /// Of a tet of the filling, with a face that is none of the hull's.
  FaceHandle inner_face(const CoreSeat& seat) const {
    for (const std::int32_t t : seat.filling) {
      for (int f = 0; f < 4; ++f) {
        const FaceHandle other = complex_.neighbours[at(t)][at(f)];
        if (std::find(seat.outer.begin(), seat.outer.end(), other) == seat.outer.end()) {
          return face_handle(t, f);
        }
      }
    }
    ADD_FAILURE() << "no filling";
    return no_face;
  }

  Subdomain domain_;
  std::vector<LatticeNode> nodes_;
  LatticeCore core_;
  TetComplex complex_;
  std::vector<std::uint8_t> constrained_;
  std::vector<std::int32_t> numbers_;
};

TEST_F(CoreSeatTest, puts_the_core_in_the_place_of_what_fills_its_hull) {
  make_complex();
  const CoreSeat seat = this->seat();
  ASSERT_TRUE(seat.fits);
  EXPECT_EQ(std::count(seat.faces.begin(), seat.faces.end(), FaceOfSeat::free),
            std::ssize(core_.hull()));
  const std::ptrdiff_t before = tets();
  for (const std::int32_t v : core_.core_nodes()) {
    numbers_[at(v)] = static_cast<std::int32_t>(complex_.points.size());
    complex_.points.push_back(nodes_[at(v)].at);
  }
  complex_.node2tet.resize(complex_.points.size(), -1);
  graft_core(complex_, constrained_, core_, numbers_, seat);
  const std::vector<std::string> complaints = validate(complex_);
  EXPECT_TRUE(complaints.empty()) << complaints.front();
  EXPECT_EQ(tets(), before - std::ssize(seat.filling) + core_.tet_count());
}

TEST_F(CoreSeatTest, does_not_fit_where_a_face_of_the_hull_is_missing) {
  const CoreHullFace& first = core_.hull().front();
  make_complex(first.tet[at(tet_face_nodes[at(face_of(first.face))][0])]);
  const CoreSeat seat = this->seat();
  EXPECT_FALSE(seat.fits);
  EXPECT_EQ(seat.faces.front(), FaceOfSeat::missing);
}

TEST_F(CoreSeatTest, does_not_fit_over_a_constrained_face_but_at_its_hull) {
  make_complex();
  const CoreSeat free = seat();
  ASSERT_TRUE(free.fits);
  const FaceHandle inner = inner_face(free);
  constrained_[at(tet_of(inner))] |= static_cast<std::uint8_t>(1U << face_of(inner));
  EXPECT_FALSE(seat().fits);
  constrained_[at(tet_of(inner))] = 0;
  // The side of a hull's face that belongs to the filling.
  const FaceHandle outer = free.outer.front();
  const FaceHandle side = complex_.neighbours[at(tet_of(outer))][at(face_of(outer))];
  constrained_[at(tet_of(side))] |= static_cast<std::uint8_t>(1U << face_of(side));
  const CoreSeat at_cut = seat();
  EXPECT_TRUE(at_cut.fits);
  EXPECT_EQ(at_cut.faces.front(), FaceOfSeat::constrained);
}

TEST_F(CoreSeatTest, does_not_fit_where_filling_lies_beyond_the_hull_too) {
  make_complex();
  const CoreSeat closed = seat();
  ASSERT_TRUE(closed.fits);
  // A face of the hull leads back into the filling.
  const FaceHandle outer = closed.outer.front();
  const FaceHandle side = complex_.neighbours[at(tet_of(outer))][at(face_of(outer))];
  complex_.neighbours[at(tet_of(side))][at(face_of(side))] = inner_face(closed);
  EXPECT_FALSE(seat().fits);
}

}  // namespace
}  // namespace tetfarm
