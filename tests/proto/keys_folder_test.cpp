#include "proto/keys_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

OwnAccount account(const std::map<std::string, std::string>& variables, bool is_root = false) {
  const auto environment = [variables](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::string() : found->second;
  };
  return {environment, is_root};
}

TEST(KeysFolder, of_a_user_lies_in_the_configuration_of_that_user) {
  const TempFolder home;
  EXPECT_EQ(default_keys_folder(account({{"HOME", home.path()}})),
            home.path() / ".config/tetfarm/keys");
  EXPECT_EQ(default_keys_folder(account({{"HOME", home.path()}, {"XDG_CONFIG_HOME", "/c"}})),
            "/c/tetfarm/keys");
  EXPECT_EQ(default_keys_folder(account({{"HOME", home.path()}, {"XDG_CONFIG_HOME", "relative"}})),
            home.path() / ".config/tetfarm/keys");
}

TEST(KeysFolder, of_root_and_of_a_service_without_a_home_lies_in_etc) {
  const TempFolder home;
  EXPECT_EQ(default_keys_folder(account({{"HOME", home.path()}}, true)), "/etc/tetfarm/keys");
  EXPECT_EQ(default_keys_folder(account({{"XDG_CONFIG_HOME", "/c"}}, true)), "/c/tetfarm/keys");
  for (const char* none : {"", "/", "/nonexistent", "."}) {
    EXPECT_EQ(default_keys_folder(account({{"HOME", none}})), "/etc/tetfarm/keys") << none;
  }
}

TEST(KeysFolder, the_store_round_a_folder_is_found_also_before_the_folder_is_made) {
  const TempFolder folder;
  const std::filesystem::path real = std::filesystem::canonical(folder.path());
  std::filesystem::create_directories(real / "store/artifacts");
  EXPECT_EQ(store_round(real / "store/keys"), "") << "no store yet";
  std::ofstream(real / "store/store_id") << "0123\n";
  EXPECT_EQ(store_round(real / "store/keys"), real / "store");
  EXPECT_EQ(store_round(real / "store/a/../b"), real / "store");
  EXPECT_EQ(store_round(real / "store"), real / "store");
  EXPECT_EQ(store_round(real / "beside"), "");
}

}  // namespace
}  // namespace tetfarm
