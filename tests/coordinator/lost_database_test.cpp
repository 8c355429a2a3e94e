// A coordinator whose database is taken away or becomes read-only while it runs: real processes,
// real sockets.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cerrno>

#include "base/file_system.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/child_coordinator.h"
#include "tests/coordinator/store_messages.h"
#include "tests/support/failing_writes.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using test::ChildCoordinator;
using test::Dealer;
using testing::AllOf;
using testing::HasSubstr;

class LostDatabase : public testing::Test, protected test::WithStore {
 protected:
  LostDatabase() : coordinator_(folder_.path(), options()) {}

  CoordinatorOptions options() const {
    CoordinatorOptions options;
    options.http_address = "127.0.0.1:0";
    options.on_http = [file = folder_.path() / "http"](const std::string& address) {
      write_file_atomically(file, address);
    };
    return options;
  }
  static wire::Envelope status_request() {
    wire::Envelope envelope;
    envelope.mutable_status_request();
    return envelope;
  }
  /// The whole answer, head and body.
  std::string get(const std::string& page) const {
    const fs::path told = folder_.path() / "http";
    while (!size_of_file(told)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::string address = read_file(told);
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.find(':') + 1))));
    ::inet_pton(AF_INET, "127.0.0.1", &where.sin_addr);
    EXPECT_EQ(::connect(fd, reinterpret_cast<sockaddr*>(&where), sizeof where), 0);
    const std::string request = "GET " + page + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    ::send(fd, request.data(), request.size(), MSG_NOSIGNAL);
    std::string answer;
    char buffer[4096];
    for (ssize_t n = 0; (n = ::recv(fd, buffer, sizeof buffer, 0)) > 0;) {
      answer.append(buffer, static_cast<std::size_t>(n));
    }
    ::close(fd);
    return answer;
  }
  /// Asks for the page until it has that text; what it said last.
  std::string get_until(const std::string& page, const std::string& text) const {
    std::string answer;
    for (int waited_ms = 0; waited_ms < test::patience_ms; waited_ms += 50) {
      answer = get(page);
      if (answer.find(text) != std::string::npos) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return answer;
  }
  void move_database(const std::string& from, const std::string& to) const {
    for (const char* part : {"", "-wal", "-shm"}) {
      fs::rename((folder_.path() / from).string() + part, (folder_.path() / to).string() + part);
    }
  }
  std::string log() const { return read_file(folder_.path() / "coordinator.log"); }

  test::FailingWrites disk_;
  ChildCoordinator coordinator_;
};

TEST_F(LostDatabase, is_noticed_without_anybody_asking) {
  EXPECT_THAT(get_until("/readyz", "ready"), HasSubstr("200 OK"));
  move_database("tetfarm.db", "away");
  EXPECT_THAT(get_until("/readyz", "503"),
              AllOf(HasSubstr("503"), HasSubstr("tetfarm.db: the database was removed")));
  EXPECT_THAT(get("/healthz"), HasSubstr("200 OK")) << "the process itself is well";
  EXPECT_THAT(log(), HasSubstr("[error] " + (folder_.path() / "tetfarm.db").string() +
                               ": the database was removed"));
}

TEST_F(LostDatabase, takes_no_job_from_that_moment_on_and_says_so) {
  Dealer client(coordinator_.endpoint());
  EXPECT_TRUE(client.ask(submission("k")).has_submitted());
  move_database("tetfarm.db", "away");
  const wire::Envelope answer = client.ask(submission("another"));
  EXPECT_THAT(answer.refused().reason(), HasSubstr("the database was removed"));
  EXPECT_FALSE(answer.refused().hello_again());
  const wire::StatusReply status = client.ask(status_request()).status_reply();
  ASSERT_EQ(status.jobs_size(), 1);
  EXPECT_EQ(status.jobs(0).state(), "stuck");
  EXPECT_THAT(status.jobs(0).message(), HasSubstr("the database was removed"));
  EXPECT_THAT(status.trouble(), HasSubstr("the database was removed"));
  wire::Envelope cancel;
  cancel.mutable_cancel()->set_job("job-1");
  EXPECT_TRUE(client.ask(cancel).has_refused());
}

TEST_F(LostDatabase, that_is_put_back_is_gone_on_with_and_no_task_is_lost) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  Dealer worker(coordinator_.endpoint());
  ASSERT_TRUE(worker.ask(hello()).has_welcome());
  wire::Envelope ready;
  ready.mutable_ready();
  const wire::Assign assign = worker.ask(ready).assign();
  move_database("tetfarm.db", "away");
  EXPECT_THAT(get_until("/readyz", "503"), HasSubstr("removed"));
  move_database("away", "tetfarm.db");
  EXPECT_THAT(get_until("/readyz", "200 OK"), HasSubstr("ready"));
  const wire::Envelope welcome = worker.ask(hello(assign.task(), assign.attempt()));
  EXPECT_TRUE(welcome.welcome().keep_running());
  EXPECT_TRUE(client.ask(submission("another")).has_submitted());
  EXPECT_THAT(log(), HasSubstr("the database can be written to again"));
}

TEST_F(LostDatabase, is_saved_by_a_coordinator_that_is_told_to_stop) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  for (const char* part : {"", "-wal", "-shm"}) {
    fs::remove((folder_.path() / "tetfarm.db").string() + part);
  }
  EXPECT_EQ(coordinator_.stop(SIGTERM), 0);
  std::string saved;
  for (const auto& entry : fs::directory_iterator(folder_.path())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("tetfarm.db.saved-")) saved = entry.path().string();
  }
  ASSERT_NE(saved, "");
  EXPECT_EQ(JobDatabase::open_to_read(saved).load().jobs.at(JobId{1}).name, "wing");
  EXPECT_THAT(log(), HasSubstr("saved in " + saved));
}

TEST_F(LostDatabase, whose_disk_becomes_read_only_is_waited_for_like_a_full_one) {
  Dealer client(coordinator_.endpoint());
  client.ask(submission("k"));
  disk_.fail_with(EROFS);
  const wire::Envelope answer = client.ask(submission("another"));
  EXPECT_THAT(answer.refused().reason(),
              AllOf(HasSubstr("tetfarm.db"), HasSubstr("Read-only file system")));
  EXPECT_EQ(client.ask(status_request()).status_reply().jobs(0).state(), "stuck");
  EXPECT_THAT(get("/readyz"), AllOf(HasSubstr("503"), HasSubstr("Read-only file system")));
  disk_.fail_with(0);
  EXPECT_THAT(get_until("/readyz", "200 OK"), HasSubstr("ready"));
  EXPECT_TRUE(client.ask(submission("another")).has_submitted());
}

/// How a coordinator ends that cannot write to its database, and what it says.
std::pair<int, std::string> start_with_read_only_database(const fs::path& store) {
  const fs::path words = store / "words";
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) _exit(99);
    CoordinatorOptions options;
    options.store = store;
    options.endpoints = {"ipc://" + (store / "socket").string()};
    options.on_listening = [](const std::vector<std::string>&) { _exit(98); };
    try {
      run_coordinator(options);
    } catch (const Error& error) {
      std::ofstream(words) << error.what();
      _exit(static_cast<int>(error.code()));
    }
    _exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(words)};
}

TEST(ReadOnlyAtStart, a_coordinator_ends_before_it_listens_and_says_what_to_do) {
  const TempFolder folder;
  {
    ChildCoordinator first(folder.path());
    wire::Envelope status;
    status.mutable_status_request();
    EXPECT_TRUE(Dealer(first.endpoint()).ask(status).has_status_reply());
    EXPECT_EQ(first.stop(SIGTERM), 0);
  }
  ::chmod(folder.path().c_str(), 0777);
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    ::chmod(entry.path().c_str(), entry.is_directory() ? 0777 : 0666);
  }
  ::chmod((folder.path() / "tetfarm.db").c_str(), 0444);
  const auto [code, words] = start_with_read_only_database(folder.path());
  EXPECT_EQ(code, 1);
  EXPECT_THAT(words, AllOf(HasSubstr("tetfarm.db"), HasSubstr("can be read but not written to"),
                           HasSubstr("--database DIR")));
}

}  // namespace
}  // namespace tetfarm
