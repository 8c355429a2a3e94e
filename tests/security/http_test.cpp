// The pages for people and Prometheus: who has no token, asks for what is no page, or never stops
// asking.
#include <random>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

using test::RawConnection;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string request(const std::string& path, const std::string& fields = "Host: localhost\r\n") {
  return "GET " + path + " HTTP/1.1\r\n" + fields + "\r\n";
}

class Http : public test::FarmUnderAttack {
 protected:
  /// What is answered to these bytes.
  static std::string answer_to(const std::string& bytes) {
    const RawConnection connection(farm().http_port());
    connection.send(bytes);
    connection.end_sending();
    return connection.hear();
  }
  static int status_of(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
  }
  static int status_to(const std::string& bytes) { return status_of(answer_to(bytes)); }
  static std::string bearer() {
    return "Authorization: Bearer " + test::contents(farm().folder() / "token") + "\r\n";
  }
};

TEST_F(Http, pages_are_served_to_those_who_have_the_token) {
  EXPECT_THAT(answer_to(request("/metrics", bearer())), HasSubstr("tetfarm_"));
  EXPECT_EQ(status_to(request("/", bearer())), 200);
}

TEST_F(Http, without_the_token_nothing_is_told_but_that_it_lives) {
  for (const char* path : {"/metrics", "/", "/metrics/", "/metrics?token=", "//metrics", "/nothing",
                           "/healthz/../metrics", "/healthz%2f..%2fmetrics"}) {
    const std::string answer = answer_to(request(path));
    EXPECT_EQ(status_of(answer), 401) << path;
    EXPECT_THAT(answer, Not(HasSubstr("tetfarm_"))) << path;
  }
  EXPECT_EQ(status_to(request("/healthz")), 200);
}

TEST_F(Http, guesses_of_the_token_are_all_refused) {
  const std::string token = test::contents(farm().folder() / "token");
  std::vector<std::string> guesses = {"",
                                      " ",
                                      "token",
                                      token + "x",
                                      " " + token.substr(1),
                                      token.substr(0, token.size() - 1),
                                      token + token,
                                      std::string(4000, 'x')};
  for (std::size_t length = 0; length < token.size(); length += 3) {
    guesses.push_back(token.substr(0, length));
  }
  for (const std::string& guess : guesses) {
    EXPECT_EQ(status_to(request("/metrics", "Authorization: Bearer " + guess + "\r\n")), 401)
        << guess;
  }
  for (const char* field : {"Authorization: Basic\r\n", "Authorization: Basic ====\r\n",
                            "Authorization: Basic Og==\r\n", "Authorization: Digest x\r\n",
                            "Authorisation: Bearer x\r\n", "Cookie: token=x\r\n"}) {
    EXPECT_EQ(status_to(request("/metrics", field)), 401) << field;
  }
}

TEST_F(Http, methods_that_change_something_are_refused) {
  for (const char* method :
       {"POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "get", "PROPFIND", "X"}) {
    const std::string answer =
        answer_to(std::string(method) + " / HTTP/1.1\r\n" + bearer() + "\r\n");
    EXPECT_EQ(status_of(answer), 405) << method;
    EXPECT_THAT(answer, Not(HasSubstr("nobody may guess")));
  }
}

TEST_F(Http, no_path_leads_to_a_file) {
  for (const char* path :
       {"/../../etc/passwd", "/../keys/coordinator.key", "/%2e%2e/%2e%2e/etc/shadow", "/token",
        "/store/tetfarm.db", "/..%00/", "/....//....//etc/passwd", "/coordinator.log"}) {
    const std::string answer = answer_to(request(path, bearer()));
    EXPECT_EQ(status_of(answer), 404) << path;
    EXPECT_THAT(answer, Not(HasSubstr("root:"))) << path;
  }
}

TEST_F(Http, two_requests_in_one_are_answered_once) {
  const std::string hidden = request("/metrics", bearer());
  for (const std::string& outer :
       {request("/healthz"), request("/healthz", "Content-Length: 0\r\nContent-Length: 99\r\n"),
        request("/healthz", "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n") + "0\r\n\r\n",
        request("/healthz", "Content-Length: " + std::to_string(hidden.size()) + "\r\n")}) {
    const std::string answer = answer_to(outer + hidden);
    EXPECT_EQ(status_of(answer), 200);
    EXPECT_EQ(answer.find("HTTP/1.1", 1), std::string::npos) << "a second answer";
    EXPECT_THAT(answer, Not(HasSubstr("tetfarm_")));
    EXPECT_THAT(answer, HasSubstr("Connection: close"));
  }
}

TEST_F(Http, heads_beyond_eight_kibibytes_are_refused) {
  EXPECT_EQ(status_to(request("/healthz", "X: " + std::string(9000, 'x') + "\r\n")), 431);
  EXPECT_EQ(status_to(request("/" + std::string(100'000, 'x'))), 431);
  std::string many;
  for (int i = 0; i < 100'000; ++i) many += "a:b\r\n";
  EXPECT_EQ(status_to(request("/healthz", many)), 431);
  EXPECT_EQ(status_to(std::string(5'000'000, '\n')), 431);
}

TEST_F(Http, bytes_that_are_no_request_are_bad_requests_or_cut_off) {
  for (const std::string& bytes :
       {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("GET http://elsewhere/ HTTP/1.1\r\n\r\n"), std::string("\0\0\0\0\r\n\r\n", 8),
        std::string("GET / HTTP/1.1\r\n no field\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\n: empty\r\n\r\n"),
        std::string("\x16\3\1\2\0\1\0\1\xfc\3\3\r\n\r\n", 15)}) {
    EXPECT_EQ(status_to(bytes), 400);
  }
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    std::string bytes(random() % 500, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    const int status = status_to(bytes + "\r\n\r\n");
    EXPECT_TRUE(status == 400 || status == 405) << status;
  }
}

TEST_F(Http, a_request_cut_after_each_byte_gets_no_page) {
  const std::string whole = request("/metrics", bearer());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_EQ(answer_to(whole.substr(0, length)), "");
  }
}

TEST_F(Http, a_hundred_unfinished_requests_keep_nobody_out) {
  std::vector<RawConnection> slow;
  for (int i = 0; i < 100; ++i) {
    slow.emplace_back(farm().http_port());
    slow.back().send("GET / HTTP/1.1\r\nX: ");
  }
  for (int i = 0; i < 28; ++i) {
    for (int more = 0; more < 10; ++more) {
      slow.emplace_back(farm().http_port());
      slow.back().send("GET / HTTP/1.1\r\nX: ");
    }
    for (const RawConnection& connection : slow) connection.send("x");
    EXPECT_EQ(status_to(request("/healthz")), 200);
    EXPECT_EQ(status_to(request("/readyz", bearer())), 200);
    EXPECT_EQ(status_to(request("/metrics", bearer())), 200);
  }
}

TEST_F(Http, who_does_not_read_a_page_holds_nobody_up) {
  std::vector<RawConnection> deaf;
  for (int i = 0; i < 20; ++i) {
    deaf.emplace_back(farm().http_port());
    deaf.back().send(request("/metrics", bearer()));
  }
  EXPECT_EQ(status_to(request("/healthz")), 200);
}

TEST_F(Http, a_browser_is_told_to_run_and_load_nothing) {
  const std::string answer = answer_to(request("/", bearer()));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, HasSubstr("Cache-Control: no-store"));
}

TEST_F(Http, a_jobs_name_with_markup_is_shown_as_text) {
  test::RawPeer anna = peer("anna");
  wire::Envelope marked = test::submission(farm(), "marked");
  marked.mutable_submit()->set_name("<img src=x onerror=alert(1)>\"'&");
  if (!anna.ask(marked).has_submitted()) return;  // refused is as good
  const std::string page = answer_to(request("/", bearer()));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("&lt;img"));
}

/// Without a token the pages are for this host alone, also where a browser is tricked.
TEST(HttpWithoutToken, serves_only_those_who_call_it_by_a_loopback_name) {
  test::Farm farm({}, test::Farm::Roots::surfaces, test::Farm::Token::none);
  for (const char* host :
       {"evil.example", "127.evil.example", "localhost.evil.example", "[::2]", "10.0.0.1", ""}) {
    const RawConnection connection(farm.http_port());
    connection.send(request("/metrics", std::string("Host: ") + host + "\r\n"));
    EXPECT_THAT(connection.hear(), StartsWith("HTTP/1.1 403")) << host;
  }
  const RawConnection connection(farm.http_port());
  connection.send(request("/metrics", "Host: 127.0.0.1:80\r\n"));
  EXPECT_THAT(connection.hear(), StartsWith("HTTP/1.1 200"));
}

TEST(HttpWithoutToken, is_refused_where_other_hosts_can_reach_it) {
  const test::TemporaryFolder folder;
  for (const char* address : {"0.0.0.0:0", "[::]:0"}) {
    const test::Ended ended = test::run_program(
        {"coordinator", "--store", "store", "--listen", "tcp://127.0.0.1:*", "--http", address},
        folder.path());
    EXPECT_EQ(ended.code, 2) << address;
    EXPECT_THAT(ended.err, HasSubstr("--http-token"));
  }
}

TEST(HttpToken, is_refused_when_it_is_short_or_others_may_read_it) {
  const test::TemporaryFolder folder;
  const auto start = [&] {
    return test::run_program({"coordinator", "--store", "store", "--listen", "tcp://127.0.0.1:*",
                              "--http", "127.0.0.1:0", "--http-token", "token"},
                             folder.path())
        .code;
  };
  test::write_contents(folder.path() / "token", "a token that is long enough");
  std::filesystem::permissions(folder.path() / "token", static_cast<std::filesystem::perms>(0644));
  EXPECT_EQ(start(), 2);
  std::filesystem::permissions(folder.path() / "token", static_cast<std::filesystem::perms>(0600));
  test::write_contents(folder.path() / "token", "short");
  EXPECT_EQ(start(), 2);
}

}  // namespace
}  // namespace tetfarm
