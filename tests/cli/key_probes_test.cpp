#include "cli/key_probes.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>

#include "base/file_system.h"
#include "proto/authorized_keys.h"
#include "proto/key_file.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A folder with the keys of a coordinator and of one peer, in order.
class KeyProbes : public ::testing::Test {
 protected:
  KeyProbes() {
    pair_ = write_new_key(keys(), "coordinator");
    const KeyPair anna = write_new_key(folder_.path() / "anna", "anna");
    authorize(authorized_keys_path(keys()), {anna.public_key, Role::submitter, "anna"});
    to_look_at_.wanted = keys();
    to_look_at_.standard = folder_.path() / "nowhere";
  }
  fs::path keys() const { return folder_.path() / "keys"; }
  Findings found() const { return look_at_keys(to_look_at_); }
  /// Those that are not well, as "VERDICT: what was found".
  std::vector<std::string> wrong() const {
    std::vector<std::string> texts;
    for (const Finding& finding : found()) {
      EXPECT_EQ(finding.check, "keys");
      if (finding.verdict == Verdict::ok) continue;
      EXPECT_NE(finding.remedy, "") << finding.found;
      texts.push_back(std::string(name_of(finding.verdict)) + ": " + finding.found);
    }
    return texts;
  }

  TempFolder folder_;
  KeyPair pair_;
  KeysToLookAt to_look_at_;
};

TEST_F(KeyProbes, find_nothing_wrong_with_keys_that_are_in_order) {
  EXPECT_THAT(wrong(), ::testing::IsEmpty());
  EXPECT_EQ(found().size(), 3U) << "the folder, its secret key, the list";
}

TEST_F(KeyProbes, find_a_secret_key_that_others_may_read) {
  ::chmod(secret_key_path(keys(), "coordinator").c_str(), 0644);
  const std::vector<std::string> texts = wrong();
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("problem: "));
  EXPECT_THAT(texts[0], HasSubstr("coordinator.key: other users may read this secret key"));
}

TEST_F(KeyProbes, look_at_every_secret_key_of_the_folder) {
  write_new_key(keys(), "spare");
  ::chmod(secret_key_path(keys(), "spare").c_str(), 0640);
  ::chmod(secret_key_path(keys(), "coordinator").c_str(), 0604);
  EXPECT_THAT(wrong(),
              ::testing::ElementsAre(HasSubstr("coordinator.key"), HasSubstr("spare.key")));
}

TEST_F(KeyProbes, find_folders_and_lists_that_others_may_write) {
  ::chmod(keys().c_str(), 0750);
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("warning: ")));
  ::chmod(keys().c_str(), 0770);
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("problem: ")));
  ::chmod(keys().c_str(), 0700);
  ::chmod(authorized_keys_path(keys()).c_str(), 0666);
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("problem: ")));
}

TEST_F(KeyProbes, find_halves_of_different_pairs) {
  write_public_key(public_key_path(keys(), "coordinator"), make_key_pair().public_key);
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("is not the public half of")));
}

TEST_F(KeyProbes, hold_the_key_against_that_of_the_coordinator_which_uses_the_store) {
  to_look_at_.store = folder_.path() / "store";
  fs::create_directory(to_look_at_.store);
  write_public_key(published_key_path(to_look_at_.store), pair_.public_key);
  EXPECT_THAT(wrong(), ::testing::IsEmpty());
  EXPECT_EQ(found().size(), 4U);
  to_look_at_.own.coordinator = published_key_path(to_look_at_.store).string();
  EXPECT_THAT(wrong(), ::testing::IsEmpty());
  write_public_key(published_key_path(to_look_at_.store), make_key_pair().public_key);
  to_look_at_.own.coordinator = public_key_path(keys(), "coordinator").string();
  EXPECT_THAT(wrong(),
              ::testing::ElementsAre(HasSubstr("is not the key of the coordinator that uses"),
                                     HasSubstr("is not the key of the coordinator that uses")));
}

TEST_F(KeyProbes, look_at_the_key_of_a_worker_or_client) {
  const fs::path anna = secret_key_path(folder_.path() / "anna", "anna");
  to_look_at_.own.own = anna.string();
  EXPECT_THAT(wrong(), ::testing::IsEmpty());
  ::chmod(anna.c_str(), 0644);
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("anna.key")));
  to_look_at_.own.own = (folder_.path() / "none.key").string();
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("none.key")));
}

TEST_F(KeyProbes, say_where_keys_were_looked_for_in_vain) {
  to_look_at_.wanted = folder_.path() / "empty";
  EXPECT_THAT(wrong(), ::testing::ElementsAre(HasSubstr("has no coordinator's key")));
  to_look_at_.wanted.clear();
  EXPECT_THAT(wrong(), ::testing::IsEmpty());
  EXPECT_THAT(found().front().found, HasSubstr("no coordinator.key in "));
}

}  // namespace
}  // namespace tetfarm
