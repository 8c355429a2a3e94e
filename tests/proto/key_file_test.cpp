#include "proto/key_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class KeyFile : public testing::Test {
 protected:
  std::filesystem::path key() const { return secret_key_path(folder_.path(), "anna"); }
  TempFolder folder_;
};

TEST_F(KeyFile, what_is_written_is_read_back) {
  const KeyPair made = write_new_key(folder_.path(), "anna");
  const KeyPair read = read_secret_key(key());
  EXPECT_EQ(read.secret_bytes, made.secret_bytes);
  EXPECT_EQ(read.public_key, made.public_key) << "the public half follows from the secret one";
  EXPECT_EQ(read_public_key(public_key_path(folder_.path(), "anna")), made.public_key);
  EXPECT_EQ(public_key_of_hex(hex_of(made.public_key), ""), made.public_key);
  EXPECT_NE(write_new_key(folder_.path(), "bob").public_key, made.public_key);
}

TEST_F(KeyFile, only_its_owner_may_read_a_new_secret_key) {
  const mode_t old = ::umask(0);
  const std::filesystem::path inner = folder_.path() / "keys";
  write_new_key(inner, "anna");
  ::umask(old);
  struct stat about {};
  ASSERT_EQ(::stat(secret_key_path(inner, "anna").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 07777U, 0600U);
  ASSERT_EQ(::stat(inner.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 07777U, 0700U);
}

TEST_F(KeyFile, a_secret_key_that_others_may_use_is_refused) {
  write_new_key(folder_.path(), "anna");
  for (const mode_t mode : {0640U, 0604U, 0620U, 0602U, 0644U, 0610U}) {
    ASSERT_EQ(::chmod(key().c_str(), mode), 0);
    EXPECT_THAT([&] { read_secret_key(key()); },
                ThrowsMessage<UsageError>(HasSubstr("other users may read this secret key")))
        << mode;
  }
  ASSERT_EQ(::chmod(key().c_str(), 0400), 0);
  EXPECT_NO_THROW(read_secret_key(key()));
}

TEST_F(KeyFile, a_secret_key_of_another_user_is_refused) {
  write_new_key(folder_.path(), "anna");
  std::filesystem::path of_another = key();
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(key().c_str(), 65534, 65534), 0);
  } else {
    of_another = "/etc/passwd";
  }
  EXPECT_THAT([&] { read_secret_key(of_another); },
              ThrowsMessage<UsageError>(HasSubstr("belongs to another user")));
}

TEST_F(KeyFile, a_key_is_never_replaced) {
  write_new_key(folder_.path(), "anna");
  const std::string before = read_file(key());
  EXPECT_THROW(write_new_key(folder_.path(), "anna"), UsageError);
  EXPECT_EQ(read_file(key()), before);
}

TEST_F(KeyFile, what_is_no_key_is_refused) {
  write_new_key(folder_.path(), "anna");
  const std::string good = read_file(key());
  for (const std::string& text :
       {std::string(), std::string("tetfarm secret key "), good.substr(0, 60),
        "tetfarm public key " + good.substr(19), std::string(good.size(), 'x'),
        "tetfarm secret key " + std::string(64, 'G') + "\n"}) {
    std::ofstream(key(), std::ios::trunc) << text;
    EXPECT_THROW(read_secret_key(key()), UsageError) << text;
    if (!text.starts_with("tetfarm public")) {
      EXPECT_THROW(read_public_key(key()), UsageError) << text;
    }
  }
  EXPECT_THROW(read_secret_key(folder_.path() / "none"), IoError);
}

TEST_F(KeyFile, a_pipe_is_refused_without_waiting_for_it) {
  ASSERT_EQ(::mkfifo(key().c_str(), 0600), 0);
  EXPECT_THAT([&] { read_secret_key(key()); },
              ThrowsMessage<UsageError>(HasSubstr("is not a file")));
}

TEST_F(KeyFile, a_name_cannot_lead_out_of_the_folder) {
  for (const char* name : {"", ".", "..", "../anna", "a/b", ".hidden", "a b", "a\n"}) {
    EXPECT_FALSE(is_key_name(name)) << name;
    EXPECT_THROW(write_new_key(folder_.path(), name), UsageError) << name;
  }
  EXPECT_TRUE(is_key_name("node-17@cluster.example"));
  EXPECT_FALSE(is_key_name(std::string(65, 'a')));
}

}  // namespace
}  // namespace tetfarm
