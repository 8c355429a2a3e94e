// The cells of pieces of fans: how many of which type, and that they are positive and fill what
// lies between their lines.
#include "mesh/layers/layer_fan.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/array_index.h"
#include "mesh/layers/layer_proof.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Along an edge of length 2 from the origin towards y, above z: two lines 90 degrees apart at each
/// end, to the left and to the right.
class Piece {
 public:
  Piece(int stop_from, int stop_to) {
    for (std::size_t k = 0; k < 4; ++k) {
      LayerLine& line = lines_[k];
      line.foot = k < 2 ? 0 : 1;
      line.at = {0, k < 2 ? 0.0 : 2.0, 0};
      line.along = line.later = {k % 2 == 0 ? -1.0 : 1.0, 0, 1};
      line.law.first = 0.5;
      line.stop = k < 2 ? stop_from : stop_to;
    }
  }

  Piece& early_from() {
    lines_[0].early = lines_[1].early = true;
    return *this;
  }
  Piece& early_to() {
    lines_[2].early = lines_[3].early = true;
    return *this;
  }
  /// The other end has a line straight up.
  Piece& to_one() {
    lines_[2].along = lines_[2].later = {0, 0, 1};
    is_to_one_ = true;
    return *this;
  }

  PieceLines lines() const {
    return {&lines_[0], &lines_[1], &lines_[2], &lines_[is_to_one_ ? 2 : 3]};
  }

 private:
  std::array<LayerLine, 4> lines_;
  bool is_to_one_ = false;
};

std::string types_of(const PieceLines& lines) {
  std::map<ElementType, int> counts;
  for (const FanCell& cell : base_cells(lines)) ++counts[cell.type];
  std::string text;
  for (const auto& [type, count] : counts) {
    text +=
        (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(element(type).name);
  }
  return text;
}

double volume_of(const PieceLines& lines) {
  const std::array<Vec3, fan_nodes> points = base_points(lines);
  double volume = 0;
  for (const FanCell& cell : base_cells(lines)) {
    std::vector<Vec3> p;
    for (std::size_t k = 0; k < nodes_of(cell.type); ++k) p.push_back(points[cell.nodes[k]]);
    volume += static_cast<double>(element_volume(cell.type, p));
  }
  return volume;
}

void expect_cells(const Piece& piece, const std::string& types, double volume,
                  std::size_t triangles) {
  EXPECT_EQ(types_of(piece.lines()), types);
  EXPECT_NEAR(volume_of(piece.lines()), volume, 1e-14);
  EXPECT_TRUE(has_positive_base(piece.lines()));
  EXPECT_EQ(open_triangles(piece.lines()).size(), triangles);
}

/// Both ends are triangles of area 1/4, the edge 2 long.
TEST(LayerFan, opens_a_lying_prism_by_a_node_in_its_middle) {
  const Piece piece(1, 3);
  expect_cells(piece, "4 tet, 2 pyramid", 0.5, 2);
  EXPECT_TRUE(has_centre(piece.lines()));
  EXPECT_EQ(base_points(piece.lines())[fan_centre], (Vec3{0, 1, 1.0 / 3}));
  Piece both_early(2, 2);
  expect_cells(both_early.early_from().early_to(), "4 tet, 2 pyramid", 0.5, 2);
}

TEST(LayerFan, divides_the_sides_where_one_end_is_early) {
  Piece from(2, 2);
  expect_cells(from.early_from(), "3 tet", 0.5, 2);
  EXPECT_FALSE(has_centre(from.lines()));
  Piece to(2, 2);
  expect_cells(to.early_to(), "3 tet", 0.5, 2);
}

TEST(LayerFan, ends_at_a_single_line) {
  Piece piece(1, 1);
  // Below the triangle from the two first points to the other foot, and from there to the line's.
  expect_cells(piece.early_from().to_one(), "2 tet", 1.0 / 6 + 1.0 / 6, 1);
}

TEST(LayerFan, ends_where_there_are_no_layers) {
  expect_cells(Piece(1, 0), "1 tet", 1.0 / 6, 1);
  expect_cells(Piece(0, 1), "1 tet", 1.0 / 6, 1);
  expect_cells(Piece(1, 0).to_one(), "1 tet", 1.0 / 6, 1);
  EXPECT_THAT(base_cells(Piece(0, 0).lines()), IsEmpty());
  EXPECT_THAT(open_triangles(Piece(0, 0).lines()), IsEmpty());
  EXPECT_THAT(base_cells(Piece(0, 1).to_one().lines()), IsEmpty());
  EXPECT_THAT(open_triangles(Piece(0, 1).to_one().lines()), IsEmpty());
}

TEST(LayerFan, fills_a_corner_with_a_tet) {
  std::array<LayerLine, 3> lines;
  const std::array<Vec3, 3> ways = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    lines[k].along = lines[k].later = ways[k];
    lines[k].law.first = 0.5;
    lines[k].stop = 2;
  }
  // Clockwise, seen from beyond their points.
  const PieceLines corner = {lines.data(), &lines[1], &lines[2], &lines[2]};
  EXPECT_EQ(types_of(corner), "1 tet");
  EXPECT_NEAR(volume_of(corner), 1.0 / 48, 1e-16);
  EXPECT_TRUE(has_positive_base(corner));
  EXPECT_THAT(open_triangles(corner), ElementsAre(ElementsAre(0, 2, 1)));
  const PieceLines turned = {&lines[1], lines.data(), &lines[2], &lines[2]};
  EXPECT_FALSE(has_positive_base(turned));
  for (LayerLine& line : lines) line.stop = 0;
  EXPECT_THAT(base_cells(corner), IsEmpty());
}

/// Triangles are turned as the wall is: their normals point towards it.
TEST(LayerFan, leaves_triangles_open_that_look_like_the_wall) {
  const Piece piece(1, 1);
  const std::array<Vec3, fan_nodes> points = base_points(piece.lines());
  for (const auto& [a, b, c] : open_triangles(piece.lines())) {
    EXPECT_LT(cross(points[b] - points[a], points[c] - points[a]).z, 0);
  }
}

}  // namespace
}  // namespace tetfarm
