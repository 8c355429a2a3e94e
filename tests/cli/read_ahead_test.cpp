#include "cli/read_ahead.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

/// Parts of one node each; the part `broken` cannot be read.
class NumberedParts : public MeshSource {
 public:
  explicit NumberedParts(std::size_t broken) : broken_(broken) {}
  std::size_t size() const override { return 5; }
  NumberedPart part(std::size_t i) const override {
    if (i == broken_) throw InvalidInput("broken", "part " + std::to_string(i));
    NumberedPart part;
    part.number = static_cast<std::int32_t>(i);
    part.nodes = {{static_cast<double>(i), 0, 0}};
    return part;
  }
  bool takes_threads() const override { return true; }
  std::vector<CellMark> cell_marks() const override { return {CellMark::pml_depth}; }
  bool has_feet() const override { return true; }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  std::size_t broken_;
};

TEST(ReadAhead, gives_the_parts_in_whatever_order_they_are_asked_for) {
  const ReadAhead mesh(std::make_unique<NumberedParts>(99));
  for (const std::size_t i : {0u, 1u, 2u, 3u, 4u, 0u, 3u, 3u, 1u, 4u}) {
    EXPECT_EQ(mesh.part(i).number, static_cast<std::int32_t>(i));
    EXPECT_EQ(mesh.part(i).nodes.front().x, static_cast<double>(i));
  }
}

TEST(ReadAhead, has_the_marks_and_feet_that_the_mesh_has) {
  const ReadAhead mesh(std::make_unique<NumberedParts>(99));
  EXPECT_EQ(mesh.cell_marks(), std::vector{CellMark::pml_depth});
  EXPECT_TRUE(mesh.has_feet());
}

TEST(ReadAhead, a_part_that_cannot_be_read_fails_when_it_is_asked_for) {
  const ReadAhead mesh(std::make_unique<NumberedParts>(2));
  EXPECT_EQ(mesh.part(0).number, 0);
  EXPECT_EQ(mesh.part(1).number, 1);
  EXPECT_THROW(mesh.part(2), InvalidInput);
  EXPECT_EQ(mesh.part(3).number, 3);
}

}  // namespace
}  // namespace tetfarm
