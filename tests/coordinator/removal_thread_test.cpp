#include "coordinator/removal_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

class Removals : public testing::Test {
 protected:
  bool has(const StoredArtifact& file) const { return store_.has(file.hash, file.size); }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  StoredArtifact mesh_ = store_.publish("a mesh");
  StoredArtifact result_ = store_.publish("the result");
};

TEST_F(Removals, what_was_given_is_gone_when_the_thread_has_ended_and_nothing_else) {
  std::optional<RemovalThread> removals(store_);
  removals->give({mesh_.hash});
  removals.reset();
  EXPECT_FALSE(has(mesh_));
  EXPECT_TRUE(has(result_));
}

TEST_F(Removals, what_is_gone_already_is_no_trouble) {
  RemovalThread removals(store_);
  const std::string absent(32, '0');
  removals.give({absent});
  removals.keep(absent);
  EXPECT_THAT(removals.take_troubles(), testing::IsEmpty());
}

TEST_F(Removals, a_file_that_is_asked_for_stays_or_is_gone_for_certain) {
  for (int i = 0; i < 200; ++i) {
    store_.publish("a mesh");
    RemovalThread removals(store_);
    removals.give({mesh_.hash, result_.hash});
    const bool was_spared = removals.keep(mesh_.hash);
    EXPECT_EQ(has(mesh_), was_spared) << i;
  }
}

TEST_F(Removals, what_cannot_be_removed_is_told) {
  std::filesystem::remove(store_.path_of(mesh_.hash));
  std::filesystem::create_directories(store_.path_of(mesh_.hash) / "full");
  RemovalThread removals(store_);
  removals.give({mesh_.hash});
  std::vector<std::string> troubles;
  while (troubles.empty()) troubles = removals.take_troubles();
  EXPECT_THAT(troubles, testing::ElementsAre(testing::HasSubstr(mesh_.hash)));
}

}  // namespace
}  // namespace tetfarm
