#include "proto/authorized_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/support/error_text.h"

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

TEST_F(AuthorizedKeysFile, is_begun_with_what_it_is_and_has_a_line_for_each) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  authorize(path_, peer("node-1", Role::worker, 'b'));
  authorize(path_, peer("eye", Role::viewer, 'c'));
  EXPECT_EQ(path_.filename(), "authorized_keys");
  EXPECT_EQ(read_file(path_), "# Who may speak with this coordinator: public key, role, name.\n" +
                                  std::string(64, 'a') + " submitter anna\n" +
                                  std::string(64, 'b') + " worker node-1\n" + std::string(64, 'c') +
                                  " viewer eye\n");
}

TEST_F(AuthorizedKeysFile, refuses_with_what_is_wrong) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  EXPECT_EQ(error_text_of([&] { authorize(path_, peer("anna", Role::worker, 'b')); }),
            "anna: is already authorised");
  EXPECT_EQ(error_text_of([&] { authorize(path_, peer("bob", Role::worker, 'a')); }),
            "bob: its key is already authorised, as anna");
  EXPECT_EQ(error_text_of([&] { authorize(path_, peer("a b", Role::worker, 'c')); }),
            "a b: is not a valid name for a key");
  EXPECT_EQ(error_text_of([&] { revoke(path_, "bob"); }),
            "bob: no such name or key in " + path_.string());
  try {
    revoke(path_, "submitter");
    ADD_FAILURE() << "a role is no name";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
  }
  ::chmod(path_.c_str(), 0664);
  EXPECT_EQ(error_text_of([&] { read(); }),
            path_.string() +
                ": other users may write to the list of authorised keys: run chmod 644 on it");
  ::chmod(path_.c_str(), 0644);
  EXPECT_EQ(error_text_of([&] { read(); }), "");
  EXPECT_EQ(error_text_of([&] { revoke(folder_.path() / "none", "bob"); }),
            "bob: no such name or key in " + (folder_.path() / "none").string());
}

TEST_F(AuthorizedKeysFile, of_another_user_is_refused_but_not_that_of_root) {
  authorize(path_, peer("anna", Role::submitter, 'a'));
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  ASSERT_EQ(::chown(path_.c_str(), 65534, 65534), 0);
  EXPECT_EQ(error_text_of([&] { read(); }),
            path_.string() + ": the list of authorised keys belongs to another user");
}

TEST(AuthorizedKeys, lines_are_refused_with_their_numbers_and_what_is_wrong) {
  const std::string a(64, 'a');
  const std::string b(64, 'b');
  const AuthorizedKeys list = parse_authorized_keys(
      "\n" + a + " worker one # a comment\n" + b + " master two\n" + b + " worker\n" + b +
      " worker three four\n" + b.substr(1) + " worker five\n" + a + " viewer six\n" + b +
      " viewer one\n" + b + " viewer .hidden\n" + b + "\tviewer  seven");
  EXPECT_THAT(
      list.bad_lines,
      ElementsAre("line 3: no role 'master'", "line 4: not KEY ROLE NAME",
                  "line 5: not KEY ROLE NAME", "line 6: the key is not 64 hexadecimal digits",
                  "line 7: its key is on an earlier line", "line 8: its name is on an earlier line",
                  "line 9: not a valid name"));
  ASSERT_EQ(list.peers.size(), 2U);
  EXPECT_EQ(list.find(public_key_of_hex(b, ""))->name, "seven");
  EXPECT_EQ(list.find(public_key_of_hex(b, ""))->role, Role::viewer);
  EXPECT_EQ(list.find(public_key_of_hex(a, ""))->role, Role::worker);
}

}  // namespace
}  // namespace tetfarm
