// The dashboard of a farm, asked by who has no token, is no honest page, or never stops asking.
#include <list>
#include <random>

#include "tests/security/farm_under_attack.h"
#include "tests/support/served_dashboard.h"

namespace tetfarm {
namespace {

using test::RawConnection;
using test::WebReply;
using ::testing::HasSubstr;
using ::testing::Not;

class AttackedDashboard : public test::FarmUnderAttack {
 protected:
  /// Asks with the key of a viewer, and asks for a token.
  AttackedDashboard()
      : dashboard_({"--connect", farm().endpoint(), "--key", "vera.key", "--coordinator-key",
                    "keys/coordinator.pub", "--http-token", "token", "--acts"},
                   farm().folder()) {}
  void TearDown() override {
    EXPECT_EQ(dashboard_.get("/api/v1/farm", bearer()).status, 200) << "it serves on";
    dashboard_.program().signal(SIGTERM);
    EXPECT_EQ(dashboard_.program().wait(20).code, 0);
    FarmUnderAttack::TearDown();
  }
  static std::string bearer() {
    return "Authorization: Bearer " + test::contents(farm().folder() / "token") + "\r\n";
  }

  test::ServedDashboard dashboard_;
};

TEST_F(AttackedDashboard, tells_nothing_without_the_token) {
  for (const char* target :
       {"/", "/app.js", "/api/v1", "/api/v1/farm", "/api/v1/changes", "/api/v1/jobs/job-1/cancel",
        "/api/v1/jobs/job-1/surfaces", "/api/v1/jobs/job-1/surfaces/1", "/healthz", "/?token=x"}) {
    const WebReply reply = dashboard_.get(target);
    EXPECT_EQ(reply.status, 401) << target;
    EXPECT_THAT(reply.head, HasSubstr("WWW-Authenticate: Basic"));
    EXPECT_THAT(reply.body, Not(HasSubstr("connected")));
  }
  EXPECT_EQ(dashboard_.get("/api/v1/farm", bearer()).json()["connected"], true);
}

TEST_F(AttackedDashboard, gives_no_file_but_the_surface_of_a_subdomain) {
  const std::string surfaces = "/api/v1/jobs/job-1/surfaces/";
  for (const char* part :
       {"..", "../../store_id", "..%2f..%2fstore_id", "%2e%2e/%2e%2e/tetfarm.db", "0", "-1", "1/..",
        "1%00", "18446744073709551616", "0x1", "1?triangles=0", "1?triangles=4294967297",
        "1?triangles=-1", "1?triangles=1e9", "1?hash=00000000000000000000000000000000",
        "1?triangles=64&triangles=999999"}) {
    const WebReply reply = dashboard_.get(surfaces + part, bearer());
    EXPECT_TRUE(reply.status == 400 || reply.status == 404) << part << ": " << reply.status;
    EXPECT_THAT(reply.head, HasSubstr("Content-Type: application/json")) << part;
  }
  for (const char* path : {"1", "2", "9223372036854775807", "18446744073709551615"}) {
    EXPECT_EQ(dashboard_.get(surfaces + path, bearer()).status, 404) << path;
  }
}

TEST_F(AttackedDashboard, a_viewers_key_lets_nobody_act_whatever_the_dashboard_allows) {
  const WebReply reply = dashboard_.act("/api/v1/jobs/job-1/cancel", bearer());
  EXPECT_EQ(reply.status, 403);
  EXPECT_THAT(reply.json()["error"].get<std::string>(), HasSubstr("viewer"));
}

TEST_F(AttackedDashboard, names_with_markup_come_out_as_json_that_browsers_do_not_take_for_pages) {
  test::RawPeer anna = peer("anna");
  wire::Envelope marked = test::submission(farm(), "marked for the dashboard");
  marked.mutable_submit()->set_name("<script>alert(1)</script>\"'&");
  if (!anna.ask(marked).has_submitted()) return;  // refused is as good
  for (const char* target : {"/api/v1/jobs", "/api/v1/events"}) {
    const WebReply reply = dashboard_.get(target, bearer());
    EXPECT_THAT(reply.head, HasSubstr("Content-Type: application/json; charset=utf-8"));
    EXPECT_THAT(reply.head, HasSubstr("X-Content-Type-Options: nosniff"));
    EXPECT_FALSE(reply.json().is_discarded());
  }
  const WebReply page = dashboard_.get("/<script>alert(1)</script>", bearer());
  EXPECT_THAT(page.body, Not(HasSubstr("alert(1)")));
}

TEST_F(AttackedDashboard, heads_without_end_and_bodies_are_refused) {
  const std::vector<std::string> attacks = {
      "GET / HTTP/1.1\r\nX: " + std::string(100'000, 'x'),
      "GET /" + std::string(100'000, 'x') + " HTTP/1.1\r\n\r\n",
      "POST /api/v1/jobs/job-1/cancel HTTP/1.1\r\nContent-Length: 1000000000\r\n\r\nx",
      "POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nFFFFFFFFF\r\n",
      "GET / HTTP/1.1\r\nContent-Length: 0\r\nContent-Length: 5\r\n\r\nhello",
      std::string(5'000'000, '\n'),
      std::string("\x16\3\1\2\0\1\0\1\xfc\3\3\r\n\r\n", 15)};
  for (const std::string& attack : attacks) {
    const RawConnection connection(dashboard_.port());
    connection.send(attack);
    connection.end_sending();
    const WebReply reply = test::ServedDashboard::reply_of(connection.hear());
    EXPECT_TRUE(reply.status == 0 || reply.status >= 400) << reply.status;
  }
}

TEST_F(AttackedDashboard, bytes_that_are_no_request_get_no_page) {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    std::string bytes(random() % 500, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    const RawConnection connection(dashboard_.port());
    connection.send(bytes + "\r\n\r\n");
    connection.end_sending();
    const WebReply reply = test::ServedDashboard::reply_of(connection.hear());
    EXPECT_TRUE(reply.status == 0 || reply.status >= 400) << reply.status;
  }
}

TEST_F(AttackedDashboard, hundreds_of_unfinished_requests_keep_nobody_out) {
  std::list<RawConnection> slow;
  for (int i = 0; i < 400; ++i) {
    slow.emplace_back(dashboard_.port());
    slow.back().send("GET / HTTP/1.1\r\nX: ");
    if (i % 40 != 39) continue;
    EXPECT_EQ(dashboard_.get("/api/v1/farm", bearer()).status, 200) << i;
  }
}

TEST_F(AttackedDashboard, watchers_that_never_read_keep_nobody_out) {
  std::list<RawConnection> deaf;
  for (int i = 0; i < 250; ++i) {
    deaf.emplace_back(dashboard_.port());
    deaf.back().send("GET /api/v1/changes HTTP/1.1\r\nHost: x\r\n" + bearer() + "\r\n");
  }
  EXPECT_EQ(dashboard_.get("/api/v1/farm", bearer()).status, 200);
  EXPECT_EQ(dashboard_.get("/api/v1/changes", bearer()).status, 503) << "200 watch already";
}

TEST_F(AttackedDashboard, many_questions_at_once_cost_the_coordinator_one_client) {
  std::list<RawConnection> askers;
  for (int i = 0; i < 200; ++i) {
    askers.emplace_back(dashboard_.port());
    askers.back().send("GET /api/v1/jobs HTTP/1.1\r\nHost: x\r\nConnection: close\r\n" + bearer() +
                       "\r\n");
  }
  for (const RawConnection& asker : askers) {
    EXPECT_EQ(test::ServedDashboard::reply_of(asker.hear()).status, 200);
  }
  EXPECT_LE(farm().status().connections(), 3U);
}

}  // namespace
}  // namespace tetfarm
