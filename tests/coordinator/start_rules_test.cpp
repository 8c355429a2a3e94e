#include "coordinator/start_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

class FindKeys : public testing::Test {
 protected:
  KeyPlaces places(const std::string& wanted = "") const {
    return {wanted.empty() ? "" : at(wanted), at("standard"), at("old")};
  }
  std::filesystem::path at(const std::string& name) const {
    return std::filesystem::canonical(folder_.path()) / name;
  }
  void put_key(const std::string& folder) const {
    std::filesystem::create_directories(at(folder));
    std::ofstream(at(folder) / "coordinator.key") << "a key";
  }

  const TempFolder folder_;
};

TEST_F(FindKeys, takes_the_folder_that_is_named_and_no_other) {
  put_key("standard");
  put_key("mine");
  EXPECT_EQ(find_keys(places("mine")).folder, at("mine"));
  EXPECT_THAT(find_keys(places("mine")).warning, IsEmpty());
  EXPECT_THAT([&] { find_keys(places("none")); },
              ThrowsMessage<UsageError>(HasSubstr("keys new coordinator --keys")));
}

TEST_F(FindKeys, takes_the_standard_folder_without_a_warning) {
  put_key("standard");
  const KeysInUse found = find_keys(places());
  EXPECT_EQ(found.folder, at("standard"));
  EXPECT_THAT(found.warning, IsEmpty());
  EXPECT_THAT(found.remark, HasSubstr(at("standard").string()));
}

TEST_F(FindKeys, takes_the_old_folder_and_says_where_to_move_it) {
  put_key("old");
  const KeysInUse found = find_keys(places());
  EXPECT_EQ(found.folder, at("old"));
  EXPECT_THAT(found.warning,
              AllOf(HasSubstr(at("old").string()), HasSubstr(at("standard").string())));
}

TEST_F(FindKeys, does_not_choose_between_two) {
  put_key("old");
  put_key("standard");
  EXPECT_THAT([&] { find_keys(places()); },
              ThrowsMessage<UsageError>(
                  AllOf(HasSubstr(at("old").string()), HasSubstr(at("standard").string()))));
  std::filesystem::remove_all(at("old"));
  std::filesystem::create_directory_symlink(at("standard"), at("old"));
  EXPECT_EQ(find_keys(places()).folder, at("standard")) << "the same folder twice";
}

TEST_F(FindKeys, says_where_it_looked_when_there_are_none) {
  const KeysInUse found = find_keys(places());
  EXPECT_THAT(found.folder.string(), IsEmpty());
  EXPECT_THAT(found.remark,
              AllOf(HasSubstr(at("old").string()), HasSubstr(at("standard").string())));
}

TEST_F(FindKeys, warns_of_keys_in_a_store) {
  std::filesystem::create_directories(at("store/artifacts"));
  std::ofstream(at("store/store_id")) << "0123\n";
  put_key("store/secret");
  EXPECT_THAT(find_keys(places("store/secret")).warning, HasSubstr(at("store").string()));
}

}  // namespace
}  // namespace tetfarm
