#include <gmock/gmock.h>

#include "coordinator/views/http_server.h"

namespace tetfarm {
namespace {

constexpr const char* secret = "0123456789abcdef";

/// Of a GET of / with these header fields, each with its line end.
int refusal_with(const std::string& fields, const std::string& token) {
  return parse_http_request("GET / HTTP/1.1\r\n" + fields + "\r\n", token).refusal;
}

TEST(HttpRequestLine, is_a_method_a_path_and_a_version) {
  struct Case {
    const char* line;
    int refusal;
    const char* path;
    bool is_head;
  };
  for (const Case& one :
       std::initializer_list<Case>{{"GET / HTTP/1.1", 0, "/", false},
                                   {"GET /metrics?name=a?b HTTP/1.0", 0, "/metrics", false},
                                   {"GET /? HTTP/1.1", 0, "/", false},
                                   {"HEAD /healthz HTTP/1.1", 0, "/healthz", true},
                                   {"POST / HTTP/1.1", 405, "/", false},
                                   {"get / HTTP/1.1", 405, "/", false},
                                   {"DELETE /metrics HTTP/1.1", 405, "/metrics", false},
                                   {"GET metrics HTTP/1.1", 400, "", false},
                                   {"GET http://localhost/ HTTP/1.1", 400, "", false},
                                   {"GET / HTTP/2.0", 400, "", false},
                                   {"GET / http/1.1", 400, "", false},
                                   {"GET /", 400, "", false},
                                   {"", 400, "", false}}) {
    const HttpRequest request =
        parse_http_request(std::string(one.line) + "\r\nHost: localhost\r\n\r\n", "");
    EXPECT_EQ(request.refusal, one.refusal) << one.line;
    EXPECT_EQ(request.path, one.path) << one.line;
    EXPECT_EQ(request.is_head, one.is_head) << one.line;
  }
}

TEST(HttpRequestFields, end_with_an_empty_line_and_have_names) {
  EXPECT_EQ(refusal_with("Host: localhost\r\n", ""), 0);
  EXPECT_EQ(refusal_with("Host: localhost\n", ""), 0) << "a bare line end";
  EXPECT_EQ(refusal_with("X:\r\nHOST:\t localhost \t\r\nY: z\r\n", ""), 0);
  EXPECT_EQ(refusal_with("Host: localhost\r\nno colon\r\n", ""), 400);
  EXPECT_EQ(refusal_with("Host: localhost\r\n: no name\r\n", ""), 400);
  EXPECT_EQ(parse_http_request("GET / HTTP/1.1\r\nHost: localhost\r\n", "").refusal, 400)
      << "the empty line is missing";
  EXPECT_EQ(refusal_with("X-Host: localhost\r\n", ""), 403);
}

TEST(HttpRequestHost, is_this_one_by_a_name_that_nobody_else_can_have) {
  for (const char* host : {"localhost", "LocalHost:8080", "127.0.0.1", "127.0.0.1:80", "127.1.2.3",
                           "[::1]", "[::1]:8080"}) {
    EXPECT_EQ(refusal_with(std::string("Host: ") + host + "\r\n", ""), 0) << host;
  }
  for (const char* host : {"", "localhosts", "127.0.0.1.org", "127.a", "128.0.0.1", "27.0.0.1",
                           "[::2]", "[fe80::1]", "10.0.0.1:8080", "::1"}) {
    EXPECT_EQ(refusal_with(std::string("Host: ") + host + "\r\n", ""), 403) << host;
  }
  EXPECT_EQ(refusal_with(std::string("Host: far.org\r\nAuthorization: Bearer ") + secret + "\r\n",
                         secret),
            0)
      << "who has the token may call it as he likes";
}

TEST(HttpRequestToken, is_the_whole_word_after_bearer) {
  for (const char* said :
       {"Bearer 0123456789abcdef", "bearer \t0123456789abcdef  ", "BEARER 0123456789abcdef"}) {
    EXPECT_EQ(refusal_with(std::string("Authorization: ") + said + "\r\n", secret), 0) << said;
  }
  for (const char* said : {"", "0123456789abcdef", "Bearer", "Bearer ", "Bearer 0123456789abcde",
                           "Bearer 0123456789abcdeg", "Bearer 1123456789abcdef",
                           "Bearer 0123456789ABCDEF", "Bearer 0123456789abcdef0123456789abcdef",
                           "Token 0123456789abcdef", "Basic 0123456789abcdef"}) {
    EXPECT_EQ(refusal_with(std::string("Authorization: ") + said + "\r\n", secret), 401) << said;
  }
}

TEST(HttpRequestToken, is_the_password_that_a_browser_asks_for) {
  for (const char* said : {
           "Basic OjAxMjM0NTY3ODlhYmNkZWY=",      // ":0123456789abcdef"
           "basic YTowMTIzNDU2Nzg5YWJjZGVm",      // "a:0123456789abcdef"
           "Basic YWI6MDEyMzQ1Njc4OWFiY2RlZg==",  // "ab:0123456789abcdef"
       }) {
    EXPECT_EQ(refusal_with(std::string("Authorization: ") + said + "\r\n", secret), 0) << said;
  }
  for (const char* said : {
           "Basic MDEyMzQ1Njc4OWFiY2RlZg==",      // "0123456789abcdef": no colon
           "Basic MDEyMzQ1Njc4OWFiY2RlZjphYg==",  // "0123456789abcdef:ab"
           "Basic YWI6MDEyMzQ1Njc4OWFiY2Rl",      // "ab:0123456789abcde"
           "Basic YTpiOjAxMjM0NTY3ODlhYmNkZWY=",  // "a:b:0123456789abcdef"
       }) {
    EXPECT_EQ(refusal_with(std::string("Authorization: ") + said + "\r\n", secret), 401) << said;
  }
  // "a:" and bytes of all values up to the last letters of the alphabet.
  EXPECT_EQ(refusal_with("Authorization: Basic YTr/+/79/Pn4AH8/Pj0wOQ==\r\n",
                         "\xff\xfb\xfe\xfd\xfc\xf9\xf8\x7f?>=09"),
            401)
      << "there is a zero in it";
  EXPECT_EQ(refusal_with("Authorization: Basic YTr/+/79/Pn4f38/Pj0wOQ==\r\n",
                         "\xff\xfb\xfe\xfd\xfc\xf9\xf8\x7f\x7f?>=09"),
            0);
}

TEST(HttpRequestToken, is_asked_for_by_every_page_but_health) {
  for (const char* path : {"/", "/metrics", "/readyz", "/healthz/x"}) {
    EXPECT_EQ(parse_http_request(std::string("GET ") + path + " HTTP/1.1\r\n\r\n", secret).refusal,
              401)
        << path;
  }
  EXPECT_EQ(parse_http_request("GET /healthz HTTP/1.1\r\n\r\n", secret).refusal, 0);
  EXPECT_EQ(parse_http_request("GET /healthz?x HTTP/1.1\r\n\r\n", secret).refusal, 0);
  EXPECT_EQ(parse_http_request("POST /healthz HTTP/1.1\r\n\r\n", secret).refusal, 405);
  EXPECT_EQ(parse_http_request("GET /healthz HTTP/1.1\r\n\r\n", "").refusal, 403)
      << "without a token the name counts";
}

}  // namespace
}  // namespace tetfarm
