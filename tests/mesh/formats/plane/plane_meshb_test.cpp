#include "mesh/formats/plane/plane_meshb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Bytes of a file of any version, in either order.
class GmfBytes {
 public:
  GmfBytes(int version, bool is_turned, int dimension = 2)
      : version_(version), is_turned_(is_turned) {
    number<std::int32_t>(1);
    number<std::int32_t>(version);
    list(3, 4);
    number<std::int32_t>(dimension);
  }
  /// The head of a list whose content has so many bytes behind it.
  void list(std::int32_t keyword, std::size_t bytes) {
    number<std::int32_t>(keyword);
    place(bytes_.size() + (version_ < 3 ? 4U : 8U) + bytes);
  }
  void place(std::size_t place) {
    version_ < 3 ? number(static_cast<std::int32_t>(place))
                 : number(static_cast<std::int64_t>(place));
  }
  void integer(std::int64_t value) {
    version_ < 4 ? number(static_cast<std::int32_t>(value)) : number(value);
  }
  void integers(std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) integer(value);
  }
  void real(double value) { version_ == 1 ? number(static_cast<float>(value)) : number(value); }
  template <class Number>
  void number(Number value) {
    std::string bytes(sizeof value, ' ');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (is_turned_) std::reverse(bytes.begin(), bytes.end());
    bytes_ += bytes;
  }
  std::size_t integer_bytes() const { return version_ < 4 ? 4 : 8; }
  std::size_t real_bytes() const { return version_ == 1 ? 4 : 8; }
  std::string ended() {
    number<std::int32_t>(54);
    place(0);
    return bytes_;
  }

 private:
  int version_;
  bool is_turned_;
  std::string bytes_;
};

/// One triangle with an edge and a corner; `last` is the last of its nodes.
std::string one_triangle(int version, bool is_turned, int last = 3) {
  GmfBytes file(version, is_turned);
  const std::size_t n = file.integer_bytes();
  file.list(4, n + 3 * (2 * file.real_bytes() + n));
  file.integer(3);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{1.0, 0.0}, std::pair{0.25, 1.5}}) {
    file.real(x);
    file.real(y);
    file.integer(0);
  }
  file.list(5, 4 * n);
  file.integers({1, 1, 2, 7});
  file.list(6, 5 * n);
  file.integers({1, 1, 2, last, 4});
  file.list(13, 2 * n);
  file.integers({1, 2});
  return file.ended();
}

std::string refusal_of_meshb(const std::string& bytes) {
  return error_text_of<InvalidInput>([&] { read_plane_meshb(bytes, "a.meshb"); });
}

TEST(PlaneMeshb, reads_all_versions_in_either_order_of_bytes) {
  for (const int version : {1, 2, 3, 4}) {
    for (const bool is_turned : {false, true}) {
      const PlaneMesh mesh = read_plane_meshb(one_triangle(version, is_turned), "a.meshb");
      EXPECT_THAT(mesh.points, ElementsAre(Vec2{0, 0}, Vec2{1, 0}, Vec2{0.25, 1.5})) << version;
      EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2)));
      EXPECT_THAT(mesh.regions, ElementsAre(4));
      EXPECT_THAT(mesh.edges, ElementsAre(ElementsAre(0, 1)));
      EXPECT_THAT(mesh.patches, ElementsAre(7));
      EXPECT_THAT(mesh.corners, ElementsAre(1));
    }
  }
}

TEST(PlaneMeshb, refuses_vertices_that_are_not_there_with_the_byte) {
  EXPECT_EQ(refusal_of_meshb(one_triangle(3, false)), "");
  for (const int node : {0, 4, -7}) {
    EXPECT_THAT(
        refusal_of_meshb(one_triangle(3, false, node)),
        AllOf(HasSubstr("a.meshb: byte "),
              HasSubstr("there is no vertex " + std::to_string(node) + "; the file has 3")));
  }
}

TEST(PlaneMeshb, refuses_any_beginning_of_a_file) {
  const std::string whole = one_triangle(2, false);
  for (std::size_t end = 0; end < whole.size() - 40; ++end) {
    EXPECT_NE(refusal_of_meshb(whole.substr(0, end)), "") << end;
  }
}

TEST(PlaneMeshb, gives_back_what_it_wrote_bit_by_bit) {
  PlaneMesh mesh = square_ring();
  mesh.points[5] = {2 + 1.0 / 3, std::nextafter(1, 2)};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "ring.meshb";
  write_plane_meshb(mesh, path);
  const PlaneMesh back = read_plane_meshb(read_file(path), "ring.meshb");
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_EQ(back.edges, mesh.edges);
  EXPECT_EQ(back.patches, mesh.patches);
  EXPECT_EQ(back.corners, mesh.corners);
}

/// Two nodes, each with a number, a metric and a vector.
std::string all_kinds(int version, bool is_turned, int kind = 2, double last = 60) {
  GmfBytes file(version, is_turned);
  file.list(62, file.integer_bytes() + 16 + 12 * file.real_bytes());
  file.integer(2);
  for (const int number : {3, 1, 3, kind}) file.number<std::int32_t>(number);
  for (const double value : {0.5, 1.0, 2.0, 3.0, 10.0, 20.0, 0.25, 4.0, 5.0, 6.0, 50.0, last}) {
    file.real(value);
  }
  return file.ended();
}

TEST(PlaneSolb, reads_fields_of_all_kinds_in_all_versions) {
  for (const int version : {1, 2, 3, 4}) {
    for (const bool is_turned : {false, true}) {
      const NodeFields fields = read_plane_solb(all_kinds(version, is_turned), "a.solb");
      EXPECT_THAT(fields.scalars, ElementsAre(ElementsAre(0.5, 0.25))) << version;
      EXPECT_THAT(fields.metrics, ElementsAre(ElementsAre(Metric2{1, 2, 3}, Metric2{4, 5, 6})));
      EXPECT_THAT(fields.vectors, ElementsAre(ElementsAre(Vec2{10, 20}, Vec2{50, 60})));
    }
  }
}

TEST(PlaneSolb, refuses_other_kinds_and_what_is_no_number) {
  const auto refusal = [](const std::string& bytes) {
    return error_text_of<InvalidInput>([&] { read_plane_solb(bytes, "a.solb"); });
  };
  EXPECT_EQ(refusal(all_kinds(2, false)), "");
  EXPECT_THAT(refusal(all_kinds(2, false, 4)), HasSubstr("a symmetric tensor (3)"));
  EXPECT_THAT(refusal(all_kinds(2, false, 2, NAN)), HasSubstr("a number is nan"));
  EXPECT_THAT(refusal(one_triangle(2, false)), HasSubstr("no fields"));
  const std::string whole = all_kinds(2, false);
  for (std::size_t end = 0; end < whole.size() - 8; ++end) {
    EXPECT_NE(refusal(whole.substr(0, end)), "") << end;
  }
}

TEST(PlaneSolb, gives_back_metrics_bit_by_bit) {
  const std::vector<Metric2> metrics{{1.0 / 3, -2e-9, 1e12}, {1, 0, 1}, {std::sqrt(2), 0.1, 7}};
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "metric.solb";
  write_plane_solb(metrics, path);
  EXPECT_THAT(read_plane_fields(path).metrics, ElementsAre(metrics));
}

}  // namespace
}  // namespace tetfarm
