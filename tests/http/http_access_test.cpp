#include "http/http_access.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

const std::string secret = "a token that is long";

TEST(HttpAccess, takes_the_token_of_programs_and_the_password_of_browsers) {
  EXPECT_TRUE(has_http_token("Bearer " + secret, secret));
  EXPECT_TRUE(has_http_token("bearer   " + secret, secret));
  // "anna:a token that is long"
  EXPECT_TRUE(has_http_token("Basic YW5uYTphIHRva2VuIHRoYXQgaXMgbG9uZw==", secret));
}

TEST(HttpAccess, takes_nothing_else_for_the_token) {
  for (const char* said : {"", "Bearer", "Bearer ", "Bearer a token that is lon", "Basic Og==",
                           "Bearer a token that is longer", "Digest a token that is long",
                           "a token that is long", "Basic YSB0b2tlbiB0aGF0IGlzIGxvbmc="}) {
    EXPECT_FALSE(has_http_token(said, secret)) << said;
  }
}

TEST(HttpAccess, knows_the_loopback_names_of_this_host_and_no_names_like_them) {
  for (const char* host : {"localhost", "localhost:8470", "127.0.0.1", "127.1.2.3:1", "[::1]:80"}) {
    EXPECT_TRUE(is_loopback_name(host)) << host;
  }
  for (const char* host : {"", "evil.example", "127.evil.example", "localhost.evil.example",
                           "[::2]", "10.0.0.1", "127", "xlocalhost"}) {
    EXPECT_FALSE(is_loopback_name(host)) << host;
  }
}

TEST(HttpAccess, an_origin_is_the_same_only_as_the_host_and_port_that_were_asked) {
  EXPECT_TRUE(is_same_origin("http://127.0.0.1:8470", "127.0.0.1:8470"));
  EXPECT_TRUE(is_same_origin("https://Head", "head"));
  for (const char* origin :
       {"", "null", "http://127.0.0.1", "http://127.0.0.1:8471", "http://evil.example",
        "http://127.0.0.1:8470.evil.example", "ftp://127.0.0.1:8470", "http://127.0.0.1:8470/"}) {
    EXPECT_FALSE(is_same_origin(origin, "127.0.0.1:8470")) << origin;
  }
  EXPECT_FALSE(is_same_origin("http://", ""));
}

TEST(HttpAccess, refuses_a_token_that_others_may_read_or_that_is_short) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "token";
  EXPECT_EQ(read_http_token(""), "");
  write_file_atomically(file, secret + "\n");
  std::filesystem::permissions(file, static_cast<std::filesystem::perms>(0600));
  EXPECT_EQ(read_http_token(file), secret);
  std::filesystem::permissions(file, static_cast<std::filesystem::perms>(0640));
  EXPECT_THROW(read_http_token(file), UsageError);
  write_file_atomically(file, "short");
  std::filesystem::permissions(file, static_cast<std::filesystem::perms>(0600));
  EXPECT_THROW(read_http_token(file), UsageError);
  EXPECT_THROW(read_http_token(folder.path() / "nothing"), IoError);
}

}  // namespace
}  // namespace tetfarm
