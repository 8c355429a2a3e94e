#include "mesh/core/patch_type.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(PatchTypes, are_read_from_the_words_that_they_are_written_with) {
  for (const std::string_view word : patch_type_words) {
    const auto type = patch_type_of(word);
    ASSERT_TRUE(type) << word;
    EXPECT_EQ(word_of(*type), word);
    EXPECT_NE(*type, PatchType::unspecified);
  }
  EXPECT_EQ(patch_type_of("wall"), PatchType::wall);
  EXPECT_EQ(patch_type_of("interface"), PatchType::coupled);
  EXPECT_EQ(patch_type_of(""), PatchType::unspecified);
  EXPECT_EQ(word_of(PatchType::unspecified), "");
  EXPECT_FALSE(patch_type_of("Wall"));
}

TEST(PatchTypes, of_a_short_list_are_unspecified_behind_its_end) {
  const std::vector<PatchType> types = {PatchType::slip};
  EXPECT_EQ(type_of_patch(types, 0), PatchType::slip);
  EXPECT_EQ(type_of_patch(types, 1), PatchType::unspecified);
  EXPECT_TRUE(has_types(types));
  EXPECT_FALSE(has_types({}));
  EXPECT_FALSE(has_types(std::vector<PatchType>(3, PatchType::unspecified)));
}

}  // namespace
}  // namespace tetfarm
