#include "mesh/spacing/tree_array.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TreeArray, of_its_own_grows_and_is_changed) {
  TreeArray<std::int32_t> array = {1, 2};
  for (std::int32_t i = 3; i < 100; ++i) array.push_back(i);
  array[1] = 7;
  array.resize(4);
  array.resize(5, 9);
  EXPECT_THAT(array, ElementsAre(1, 7, 3, 4, 9));
}

TEST(TreeArray, a_copy_has_its_own_elements_wherever_they_were) {
  const std::vector<std::int32_t> elsewhere = {1, 2, 3};
  const auto view = TreeArray<std::int32_t>::elsewhere(elsewhere);
  EXPECT_EQ(view.data(), elsewhere.data());
  TreeArray<std::int32_t> copy = view;
  copy[0] = 5;
  TreeArray<std::int32_t> copy_of_copy = copy;
  copy_of_copy[0] = 6;
  EXPECT_THAT(copy, ElementsAre(5, 2, 3));
  EXPECT_THAT(copy_of_copy, ElementsAre(6, 2, 3));
  EXPECT_THAT(elsewhere, ElementsAre(1, 2, 3));
}

TEST(TreeArray, moves_leave_elements_where_they_are) {
  const std::vector<std::int32_t> elsewhere = {1, 2, 3};
  auto view = TreeArray<std::int32_t>::elsewhere(elsewhere);
  TreeArray<std::int32_t> moved = std::move(view);
  EXPECT_EQ(moved.data(), elsewhere.data());
  TreeArray<std::int32_t> own = {4};
  const std::int32_t* const place = own.data();
  moved = std::move(own);
  EXPECT_EQ(moved.data(), place);
  moved.push_back(5);
  EXPECT_THAT(moved, ElementsAre(4, 5));
}

TEST(TreeArray, that_lies_elsewhere_is_not_changed) {
  const std::vector<std::int32_t> elsewhere = {1, 2, 3};
  auto view = TreeArray<std::int32_t>::elsewhere(elsewhere);
  EXPECT_DEATH(view.push_back(4), "");
  EXPECT_DEATH(view[0] = 4, "");
}

}  // namespace
}  // namespace tetfarm
