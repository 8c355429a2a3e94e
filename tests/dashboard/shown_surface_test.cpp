#include "dashboard/shown_surface.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>

#include "base/error.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

template <class Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number number{};
  EXPECT_LE(offset + sizeof number, bytes.size());
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

/// A tetrahedron far from the origin, with a face of each kind.
Subdomain far_tetrahedron() {
  SurfaceMesh surface = shapes::tetrahedron();
  for (Vec3& vertex : surface.vertices) vertex += Vec3{1e9, 0, 0};
  Subdomain subdomain = root_subdomain(surface);
  subdomain.triangle_origin[1].owner = 5;
  subdomain.triangle_origin[2].owner = top_of_layers;
  return subdomain;
}

TEST(ShownSurface, has_a_head_vertices_seen_from_its_origin_triangles_and_pieces) {
  const Subdomain subdomain = far_tetrahedron();
  const std::vector<std::int32_t> pieces = {7, -1, -2, 8};
  const std::string bytes = shown_surface(subdomain, pieces, 100, "x");
  EXPECT_EQ(bytes.substr(0, 8), "TFSHOWN\n");
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 8), 1U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 12), 4U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 16), 4U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 20), 4U);
  ASSERT_EQ(bytes.size(), shown_surface_head + 4 * 12 + 4 * 16);
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = number_at<double>(bytes, 24) +
                     static_cast<double>(number_at<float>(bytes, shown_surface_head + 12 * i));
    EXPECT_NEAR(x, subdomain.vertices[i].x, 1e-6) << "numbers of 32 bits alone lose it";
    EXPECT_EQ(number_at<std::int32_t>(bytes, bytes.size() - 16 + 4 * i), pieces[i]);
    const std::size_t corner = shown_surface_head + 48 + 12 * i;
    EXPECT_EQ(number_at<std::int32_t>(bytes, corner), subdomain.triangles[i][0]);
  }
}

TEST(ShownSurface, has_at_most_64_bytes_and_52_for_each_triangle_asked_for) {
  const Subdomain subdomain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 5));
  const std::vector<std::int32_t> pieces(subdomain.triangles.size(), 0);
  for (const std::size_t most : {1U, 16U, 1024U, 16'384U}) {
    const std::string bytes = shown_surface(subdomain, pieces, most, "x");
    EXPECT_LE(bytes.size(), 64 + 52 * most);
    EXPECT_EQ(number_at<std::uint32_t>(bytes, 20), subdomain.triangles.size());
  }
}

TEST(ShownSurface, says_what_each_triangle_is_a_piece_of) {
  const Subdomain subdomain = far_tetrahedron();
  EXPECT_THAT(numbers_in_input(subdomain), ElementsAre(0, 3));
  const std::vector<std::int32_t> patches = {4, 6};
  EXPECT_THAT(pieces_of_boundary(subdomain, patches), ElementsAre(4, -1, -2, 6));
  EXPECT_THAT(pieces_of_boundary(subdomain, {}), ElementsAre(-3, -1, -2, -3));
}

TEST(ShownSurface, of_coordinates_that_are_no_numbers_of_32_bits_is_refused) {
  const std::vector<std::int32_t> pieces(4, 0);
  for (const double wrong : {std::nan(""), HUGE_VAL, -1e31, 1e300}) {
    Subdomain subdomain = far_tetrahedron();
    subdomain.vertices[2].y = wrong;
    EXPECT_THROW(shown_surface(subdomain, pieces, 100, "x"), CorruptFile) << wrong;
  }
}

}  // namespace
}  // namespace tetfarm
