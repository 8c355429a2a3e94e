#include "proto/authorized_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

AuthorizedPeer peer(const std::string& name, Role role, char digit) {
  return {public_key_of_hex(std::string(64, digit), ""), role, name};
}

class AuthorizedKeysFile : public testing::Test {
 protected:
  AuthorizedKeys read() const { return read_authorized_keys(path_); }

  TempFolder folder_;
  std::filesystem::path path_ = authorized_keys_path(folder_.path());
};

TEST_F(AuthorizedKeysFile, who_is_authorised_is_found_by_the_key_until_revoked) {
  EXPECT_TRUE(read().peers.empty()) << "no file lets nobody in";
  authorize(path_, peer("anna", Role::submitter, 'a'));
  authorize(path_, peer("node-1", Role::worker, 'b'));
  const AuthorizedPeer* found = read().find(peer("", Role::viewer, 'b').key);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(read().find(peer("", Role::viewer, 'c').key), nullptr);
  revoke(path_, "node-1");
  EXPECT_EQ(read().find(peer("", Role::viewer, 'b').key), nullptr);
  revoke(path_, std::string(64, 'a'));
  EXPECT_TRUE(read().peers.empty());
}

TEST_F(AuthorizedKeysFile, keeps_the_role_and_the_name) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  const AuthorizedKeys list = read();
  const AuthorizedPeer* anna = list.find(peer("", Role::viewer, 'a').key);
  ASSERT_NE(anna, nullptr);
  EXPECT_EQ(anna->role, Role::submitter);
  EXPECT_EQ(anna->name, "anna");
}

TEST_F(AuthorizedKeysFile, a_name_or_a_key_is_there_only_once) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  EXPECT_THAT([&] { authorize(path_, peer("anna", Role::worker, 'b')); },
              ThrowsMessage<UsageError>(HasSubstr("anna")));
  EXPECT_THAT([&] { authorize(path_, peer("bob", Role::worker, 'a')); },
              ThrowsMessage<UsageError>(HasSubstr("as anna")));
  EXPECT_THROW(authorize(path_, peer("a b", Role::worker, 'c')), UsageError);
  EXPECT_EQ(read().peers.size(), 1U);
}

TEST_F(AuthorizedKeysFile, revoking_nobody_is_an_error) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  EXPECT_THROW(revoke(path_, "bob"), Error);
  EXPECT_EQ(read().peers.size(), 1U);
}

TEST_F(AuthorizedKeysFile, what_a_person_wrote_stays) {
  std::ofstream(path_) << "# our cluster\n" << std::string(64, 'a') << " worker node-1 # rack 4";
  authorize(path_, peer("anna", Role::submitter, 'b'));
  EXPECT_THAT(read_file(path_), HasSubstr("# our cluster\n"));
  EXPECT_THAT(read_file(path_), HasSubstr("# rack 4\n"));
  revoke(path_, "anna");
  EXPECT_EQ(read_file(path_),
            "# our cluster\n" + std::string(64, 'a') + " worker node-1 # rack 4\n");
}

TEST_F(AuthorizedKeysFile, a_list_that_others_may_write_is_refused) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  for (const mode_t mode : {0664U, 0646U, 0666U}) {
    ASSERT_EQ(::chmod(path_.c_str(), mode), 0);
    EXPECT_THROW(read(), UsageError) << mode;
  }
}

TEST(AuthorizedKeys, a_line_that_cannot_be_read_lets_nobody_in) {
  const std::string a(64, 'a');
  const std::string b(64, 'b');
  const AuthorizedKeys list = parse_authorized_keys(
      a + " worker one\n\n  # nothing\n" + b + " master two\n" + b + " worker\n" + b +
      " worker three four\nshort worker five\n" + a + " viewer six\n" + b + " viewer one\n");
  EXPECT_EQ(list.peers.size(), 1U);
  EXPECT_THAT(list.bad_lines,
              ElementsAre(HasSubstr("line 4: no role 'master'"), HasSubstr("line 5"),
                          HasSubstr("line 6"), HasSubstr("line 7: the key"),
                          HasSubstr("line 8: its key"), HasSubstr("line 9: its name")));
}

}  // namespace
}  // namespace tetfarm
