#include "proto/key_file.h"

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

TEST_F(KeyFile, is_one_line_of_text_that_says_what_it_is) {
  const KeyPair pair = write_new_key(folder_.path(), "anna");
  EXPECT_EQ(read_file(key()), "tetfarm secret key " + hex_of({pair.secret_bytes}) + "\n");
  EXPECT_EQ(read_file(public_key_path(folder_.path(), "anna")),
            "tetfarm public key " + hex_of(pair.public_key) + "\n");
  EXPECT_EQ(key().filename(), "anna.key");
  EXPECT_EQ(public_key_path(folder_.path(), "anna").filename(), "anna.pub");
  EXPECT_EQ(hex_of(pair.public_key).size(), 64U);
}

TEST_F(KeyFile, is_refused_with_what_is_wrong) {
  const std::string path = key().string();
  write_new_key(folder_.path(), "anna");
  EXPECT_EQ(error_text_of([&] { write_new_key(folder_.path(), "anna"); }),
            path + ": there is already a key; a new one would lock out everyone who uses it");
  EXPECT_EQ(error_text_of([&] { write_new_key(folder_.path(), "a/b"); }),
            "a/b: a key's name may only have letters, digits, '.', '_', '-' and '@'");
  std::ofstream(key(), std::ios::trunc) << "tetfarm secret key 12\n";
  EXPECT_EQ(error_text_of([&] { read_secret_key(key()); }),
            path + ": is not a secret key of tetfarm");
  EXPECT_EQ(error_text_of([&] { read_public_key(key()); }),
            path + ": is not a public key of tetfarm");
  std::ofstream(key(), std::ios::trunc) << "tetfarm public key " << std::string(64, 'a') << "\n"
                                        << std::string(300, 'x');
  EXPECT_EQ(error_text_of([&] { read_public_key(key()); }),
            path + ": is not a public key of tetfarm")
      << "what is larger than a key is none";
  ::chmod(key().c_str(), 0644);
  EXPECT_EQ(error_text_of([&] { read_secret_key(key()); }),
            path +
                ": other users may read this secret key: run chmod 600 on it, and make a new key "
                "if anyone has read it");
  const std::filesystem::path none = folder_.path() / "none";
  EXPECT_EQ(error_text_of([&] { read_secret_key(none); }),
            none.string() + ": cannot open: No such file or directory");
  EXPECT_EQ(error_text_of([&] { read_public_key(none); }),
            none.string() + ": cannot open: No such file or directory");
}

TEST_F(KeyFile, has_digits_of_sixteen_kinds_in_small_letters) {
  const std::string digits = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";
  EXPECT_EQ(hex_of(public_key_of_hex(digits, "")), digits);
  EXPECT_EQ(public_key_of_hex(digits, "").bytes.substr(0, 8), "\x01\x23\x45\x67\x89\xab\xcd\xef");
  for (const std::string& text :
       {digits.substr(1), digits + "0", "0123456789ABCDEF" + digits.substr(16),
        "g" + digits.substr(1), digits.substr(1) + "g", std::string()}) {
    EXPECT_EQ(error_text_of([&] { public_key_of_hex(text, "line 7"); }),
              "line 7: is not a public key of 64 hexadecimal digits")
        << text;
  }
}

TEST_F(KeyFile, may_have_a_name_of_up_to_64_plain_characters) {
  EXPECT_TRUE(is_key_name(std::string(64, 'a')));
  EXPECT_FALSE(is_key_name(std::string(65, 'a')));
  for (const char* name : {"a", "A", "0", "z9", "Z", "_", "-", "@", "a.b"}) {
    EXPECT_TRUE(is_key_name(name)) << name;
  }
  for (const char* name : {"a:b", "a`", "a[", "a/", "a\xc3\xa9", "{a", ".a"}) {
    EXPECT_FALSE(is_key_name(name)) << name;
  }
}

}  // namespace
}  // namespace tetfarm
