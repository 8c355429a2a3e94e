#include "coordinator/views/status_server.h"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/coordinator/views/farm_in_rows.h"
#include "tests/coordinator/views/loopback.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A server that listens, and a client that reads one page after the other.
class StatusServerTest : public FarmInRows {
 protected:
  static HttpOptions options() {
    HttpOptions options;
    options.address = "127.0.0.1:0";
    return options;
  }
  /// "STATUS TYPE|BODY".
  std::string page(const std::string& path) { return page(path, database_.history()); }
  std::string page(const std::string& path, const JobHistory& history) {
    const int fd = connect_to(server_.address());
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    EXPECT_GT(::send(fd, request.data(), request.size(), MSG_NOSIGNAL), 0);
    std::string text;
    for (int i = 0; i < 100; ++i) {
      server_.serve(context(history), {refusals_, database_trouble_, 17});
      char buffer[65536];
      const ssize_t n = ::recv(fd, buffer, sizeof buffer, MSG_DONTWAIT);
      if (n == 0) break;
      if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
    }
    ::close(fd);
    const std::string type = "Content-Type: ";
    const std::size_t begin = text.find(type) + type.size();
    return text.substr(9, 3) + " " + text.substr(begin, text.find("\r\n", begin) - begin) + "|" +
           text.substr(text.find("\r\n\r\n") + 4);
  }

  StatusServer server_{options(), folder_.path(), 2500};
  Refusals refusals_;
  std::string database_trouble_;
};

const std::string plain = " text/plain; charset=utf-8|";

TEST_F(StatusServerTest, is_well_and_ready_unless_something_is_wrong) {
  EXPECT_EQ(page("/healthz"), "200" + plain + "ok\n");
  EXPECT_EQ(page("/readyz"), "200" + plain + "ready\n");
  server_.note_failed_commit();
  EXPECT_EQ(page("/readyz"), "503" + plain + "the last database transaction failed\n");
  EXPECT_EQ(page("/healthz"), "200" + plain + "ok\n") << "it lives all the same";
  server_.note({}, 0.1);
  EXPECT_EQ(page("/readyz"), "200" + plain + "ready\n");
  server_.note_failed_commit();
  state_->out_of_resources("No space left on device", now_);
  EXPECT_EQ(page("/readyz"), "503" + plain + "no room: No space left on device\n");
  database_trouble_ = "the database cannot be written to";
  EXPECT_EQ(page("/readyz"), "503" + plain + "not ready: the database cannot be written to\n");
}

TEST_F(StatusServerTest, has_a_page_for_people_and_figures_for_monitoring_and_nothing_else) {
  const std::string people = page("/");
  EXPECT_THAT(people, StartsWith("200 text/html; charset=utf-8|<!DOCTYPE html>\n"));
  EXPECT_THAT(people, HasSubstr("<td>duct</td>"));
  refusals_.count(Refusal::stale, "x", 0);
  server_.note_failed_commit();
  ChangeSet changes;
  changes.events.resize(5);
  server_.note(changes, 0.1);
  const std::string figures = page("/metrics");
  EXPECT_THAT(figures, StartsWith("200 text/plain; version=0.0.4; charset=utf-8|# HELP "));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_connections 17\n"));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_refusals_total{reason=\"stale\"} 1\n"));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_commits_failed_total 1\n"));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_events_total 5\n"));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_commit_seconds_count 1\n"));
  EXPECT_THAT(figures, HasSubstr("\ntetfarm_start_time_seconds 2.5\n"));
  const auto space = std::filesystem::space(folder_.path());
  std::array<char, 40> size{};
  std::snprintf(size.data(), size.size(), "%.9g", static_cast<double>(space.capacity));
  EXPECT_THAT(figures, HasSubstr(std::string("\ntetfarm_store_size_bytes ") + size.data() + "\n"));
  for (const char* path : {"/metricsx", "/index.html", "//", "/healthz/"}) {
    EXPECT_EQ(page(path), "404" + plain + "no such page\n") << path;
  }
}

TEST_F(StatusServerTest, says_what_is_wrong_with_a_database_that_cannot_be_read_and_goes_on) {
  sqlite3* empty = nullptr;
  ASSERT_EQ(sqlite3_open(":memory:", &empty), SQLITE_OK);
  EXPECT_THAT(page("/", JobHistory(empty)),
              testing::MatchesRegex("503" + std::string(" text/plain; charset=utf-8.") +
                                    ".*no such table.*\n"));
  sqlite3_close(empty);
  EXPECT_EQ(page("/healthz"), "200" + plain + "ok\n");
}

TEST(StatusServer, counts_without_listening_where_no_address_is_given) {
  StatusServer server({}, "/", 0);
  EXPECT_EQ(server.address(), "");
  std::vector<zmq::pollitem_t> items;
  server.add_poll_items(items);
  EXPECT_TRUE(items.empty());
  server.note({}, 0.1);
}

}  // namespace
}  // namespace tetfarm
