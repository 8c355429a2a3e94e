#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// What a leaf works out by the sums alone is where the frame of all parts has it.
class PlacesOfCells : public testing::Test {
 protected:
  void expect_those_of_the_frame(const std::vector<VtkhdfCounts>& parts, const VtkhdfNames& names) {
    VtkhdfCounts all;
    for (const VtkhdfCounts& part : parts) {
      all.tets += part.tets;
      all.faces += part.faces;
    }
    const VtkhdfFrame frame(folder_.path() / "frame", parts, names);
    const VtkhdfPlaces alone =
        places_of_cells(folder_.path() / "scratch", std::ssize(parts), all, names);
    EXPECT_EQ(alone.id_size, frame.places().id_size) << parts.size();
    EXPECT_EQ(alone.connectivity, frame.places().connectivity) << parts.size();
    EXPECT_EQ(alone.marks, frame.places().marks) << parts.size();
  }

  TempFolder folder_;
};

std::vector<VtkhdfCounts> some_parts(std::size_t count, std::int64_t tets) {
  std::vector<VtkhdfCounts> parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto more = static_cast<std::int64_t>(i % 7);
    parts[i] = {100 + more, tets + 3 * more, more};
  }
  return parts;
}

TEST_F(PlacesOfCells, are_those_of_the_frame_whatever_the_number_of_parts) {
  for (std::size_t count = 1; count < 3000; count += 1 + count / 20) {
    expect_those_of_the_frame(some_parts(count, 10), {{"wall"}, {}});
  }
  for (const std::size_t count : {4096U, 100'000U}) {
    expect_those_of_the_frame(some_parts(count, 1'000'000), {{"wall"}, {}});
  }
}

TEST_F(PlacesOfCells, are_those_of_the_frame_whatever_the_names) {
  std::vector<std::string> patches;
  for (int i = 0; i < 40; ++i) {
    patches.push_back(std::string(static_cast<std::size_t>(3 * i), 'p') + std::to_string(i));
    expect_those_of_the_frame(some_parts(37, 5), {patches, {"steel", "air"}});
    expect_those_of_the_frame(some_parts(37, 5), {patches, {}, {CellMark::layer}, true});
  }
}

TEST_F(PlacesOfCells, leave_no_file) {
  expect_those_of_the_frame(some_parts(3, 10), {{"wall"}, {}});
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "scratch"));
}

TEST(VtkhdfFrame, has_wide_ids_once_those_of_a_part_do_not_fit_32_bits) {
  const TempFolder folder;
  constexpr std::int64_t most = (std::int64_t{1} << 31U) - 1;
  const VtkhdfCounts fits = {10, most / 4, 1};
  const VtkhdfCounts is_too_large = {10, most / 4, 2};
  ASSERT_EQ(ids_of(fits), most);
  EXPECT_TRUE(has_narrow_ids(fits));
  EXPECT_FALSE(has_narrow_ids(is_too_large));
  const std::vector<VtkhdfCounts> narrow = {fits, fits, fits};
  const std::vector<VtkhdfCounts> wide = {fits, is_too_large};
  EXPECT_EQ(VtkhdfFrame(folder.path() / "a", narrow, {}).places().id_size, 4);
  EXPECT_EQ(VtkhdfFrame(folder.path() / "b", wide, {}).places().id_size, 8);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "a frame that is not finished stays";
}

}  // namespace
}  // namespace tetfarm
