#include "http/http_listener.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

TEST(HttpListener, tells_the_free_port_that_it_got) {
  const HttpListener first("127.0.0.1:0", false);
  const HttpListener second("localhost:0", false);
  EXPECT_TRUE(first.address().starts_with("127.0.0.1:"));
  EXPECT_FALSE(first.address().ends_with(":0"));
  EXPECT_NE(first.address(), second.address());
  EXPECT_FALSE(first.is_version_6());
}

TEST(HttpListener, refuses_a_port_that_is_not_free) {
  const HttpListener first("127.0.0.1:0", false);
  EXPECT_THROW(HttpListener(first.address(), false), UsageError);
}

TEST(HttpListener, refuses_addresses_that_other_hosts_reach_without_a_token) {
  EXPECT_THROW(HttpListener("0.0.0.0:0", false), UsageError);
  EXPECT_THROW(HttpListener("[::]:0", false), UsageError);
  EXPECT_NO_THROW(HttpListener("0.0.0.0:0", true));
}

TEST(HttpListener, refuses_what_is_no_address) {
  for (const char* text : {"", "127.0.0.1", ":80", "somewhere.example:80", "127.0.0.1:http"}) {
    EXPECT_THROW(HttpListener(text, true), UsageError) << text;
  }
}

}  // namespace
}  // namespace tetfarm
