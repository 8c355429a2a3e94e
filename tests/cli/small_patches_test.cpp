#include "cli/small_patches.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Patches that are triangles of the given sizes, each in a part of its own.
class Triangles : public MeshSource {
 public:
  explicit Triangles(const std::vector<std::pair<std::string, double>>& patches) {
    for (const auto& [name, size] : patches) {
      NumberedPart part;
      part.nodes = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
      part.faces = {{0, 1, 2}};
      part.patch_of_face = {static_cast<std::int32_t>(names_.size())};
      parts_.push_back(part);
      names_.push_back(name);
    }
  }
  std::size_t size() const override { return parts_.size(); }
  NumberedPart part(std::size_t i) const override { return parts_.at(i); }
  std::vector<std::string> patch_names() const override { return names_; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  std::vector<NumberedPart> parts_;
  std::vector<std::string> names_;
};

TEST(SmallPatches, are_shorter_than_two_fifths_of_the_whole) {
  EXPECT_THAT(small_patches(Triangles({{"wing", 3.9}, {"tail", 4.1}, {"walls", 10}})),
              ElementsAre("wing"));
  EXPECT_THAT(small_patches(Triangles({{"walls", 10}})), IsEmpty());
}

TEST(SmallPatches, are_not_guessed_where_the_outer_boundary_has_a_name) {
  EXPECT_THAT(small_patches(Triangles({{"wing", 1}, {"outer_box", 10}})), IsEmpty());
}

/// One that has a patch without triangles, and triangles of a patch that it does not name.
class OddPatches : public Triangles {
 public:
  OddPatches() : Triangles({{"wing", 1}, {"walls", 10}, {"extra", 100}}) {}
  std::vector<std::string> patch_names() const override { return {"wing", "walls"}; }
};

TEST(SmallPatches, are_of_those_that_have_a_name) {
  EXPECT_THAT(small_patches(OddPatches()), ElementsAre("wing"));
}

}  // namespace
}  // namespace tetfarm
