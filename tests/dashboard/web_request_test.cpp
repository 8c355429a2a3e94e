#include "dashboard/web_request.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

const std::string secret = "a token that is long";

WebRequest get(const std::string& target) {
  WebRequest request;
  request.method = "GET";
  request.target = target;
  request.host = "localhost:8470";
  return request;
}

WebRequest post() {
  WebRequest request = get("/api/v1/jobs/job-1/cancel");
  request.method = "POST";
  request.act = "yes";
  return request;
}

WebRules rules(bool acts, const std::string& token = "") {
  WebRules rules;
  rules.acts = acts;
  rules.token = token;
  return rules;
}

int status(const WebRequest& request, const WebRules& rules) {
  const std::optional<ApiError> refusal = refusal_of(request, rules);
  if (!refusal) return 200;
  EXPECT_FALSE(refusal->error.empty() || refusal->help.empty());
  return refusal->status;
}

TEST(WebRequest, without_a_token_must_name_a_loopback_name) {
  WebRequest request = get("/");
  EXPECT_EQ(status(request, rules(false)), 200);
  for (const char* host : {"", "evil.example", "LOCALHOST.evil.example", "10.1.2.3:8470"}) {
    request.host = host;
    EXPECT_EQ(status(request, rules(false)), 403) << host;
  }
  request.host = "LocalHost";
  EXPECT_EQ(status(request, rules(false)), 200);
}

TEST(WebRequest, needs_the_token_where_there_is_one_for_pages_too) {
  for (const char* target : {"/", "/app.js", "/api/v1/farm", "/api/v1/changes", "/nothing"}) {
    WebRequest request = get(target);
    EXPECT_EQ(status(request, rules(false, secret)), 401);
    request.authorization = "Bearer " + secret;
    request.host = "head.example:8470";
    EXPECT_EQ(status(request, rules(false, secret)), 200);
  }
}

TEST(WebRequest, that_acts_is_refused_unless_acts_are_allowed) {
  EXPECT_EQ(status(post(), rules(false)), 403);
  EXPECT_EQ(status(post(), rules(true)), 200);
}

TEST(WebRequest, that_acts_is_refused_without_the_field_that_forms_cannot_send) {
  WebRequest request = post();
  for (const char* act : {"", "no", "yes please"}) {
    request.act = act;
    EXPECT_EQ(status(request, rules(true)), 403) << act;
  }
}

TEST(WebRequest, that_acts_is_refused_from_the_page_of_another_server) {
  WebRequest request = post();
  request.origin = "http://localhost:8470";
  EXPECT_EQ(status(request, rules(true)), 200);
  for (const char* origin : {"http://evil.example", "null", "http://localhost:8471"}) {
    request.origin = origin;
    EXPECT_EQ(status(request, rules(true)), 403) << origin;
  }
}

TEST(WebRequest, of_other_methods_is_refused) {
  WebRequest request = get("/api/v1/farm");
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "TRACE", "get"}) {
    request.method = method;
    EXPECT_EQ(status(request, rules(true)), 405) << method;
  }
  request = post();
  request.target = "/index.html";
  EXPECT_EQ(status(request, rules(true)), 405);
}

TEST(WebRequest, for_what_is_no_path_is_malformed) {
  for (const char* target : {"", "*", "http://elsewhere/", "localhost:8470"}) {
    EXPECT_EQ(status(get(target), rules(true)), 400) << target;
  }
}

}  // namespace
}  // namespace tetfarm
