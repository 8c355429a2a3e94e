// `tetfarm top`: once where there is no terminal, otherwise again and again until a key is pressed.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "base/clock.h"
#include "cli/commands.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/parsed.h"
#include "tests/cli/said.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

using TopOptions = PlainEnvironment;

TEST_F(TopOptions, arrive_where_they_belong) {
  const auto least = parsed_as<TopCommand>({"top", "--store", "s"});
  EXPECT_FALSE(least.once);
  EXPECT_EQ(least.interval_s, 2);
  EXPECT_EQ(least.view.store, "s");
  const auto all = parsed_as<TopCommand>(
      {"top", "--connect", "tcp://h:1", "--once", "--interval", "0.5", "--database", "d"});
  EXPECT_TRUE(all.once);
  EXPECT_EQ(all.interval_s, 0.5);
  EXPECT_EQ(all.view.client.endpoint, "tcp://h:1");
  EXPECT_EQ(all.view.database, "d");
  EXPECT_THAT(refusal_of({"top", "--interval", "0"}), HasSubstr("from 0.1 to 3600"));
}

/// A farm with a job and a worker that answers whoever asks.
class Top : public ::testing::Test {
 protected:
  FakeCoordinator coordinator_{[](const wire::Envelope& said) {
    wire::Envelope answer;
    if (said.has_status_request()) {
      answer.mutable_status_reply()->set_workers(1);
      wire::JobStatus& job = *answer.mutable_status_reply()->add_jobs();
      job.set_job("job-7");
      job.set_state("running");
      job.set_stage("mesh");
    }
    if (said.has_query()) {
      wire::WorkerLine& worker = *answer.mutable_query_reply()->add_workers();
      worker.set_worker(3);
      worker.set_state("idle");
    }
    return std::vector<wire::Envelope>{answer};
  }};
};

TEST_F(Top, is_one_snapshot_where_there_is_no_terminal) {
  TopCommand command;
  command.view.client.endpoint = coordinator_.endpoint();
  const Said said = said_by([&] { return top_command(command); });
  EXPECT_EQ(said.code, ExitCode::ok) << said.error;
  EXPECT_THAT(said.out, HasSubstr("1 job runs; "));
  EXPECT_THAT(said.out, HasSubstr("\njob-7"));
  EXPECT_THAT(said.out, HasSubstr("\nworker-3"));
  EXPECT_EQ(said.out.find('\033'), std::string::npos);
}

/// `tetfarm top` in a terminal of its own.
class TopInTerminal : public Top {
 protected:
  TopInTerminal() {
    const std::string program = test::built_program().string();
    const std::string endpoint = coordinator_.endpoint();
    winsize size{20, 60, 0, 0};
    process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ == 0) {
      ::execl(program.c_str(), "tetfarm", "top", "--connect", endpoint.c_str(), "--interval", "0.2",
              nullptr);
      ::_exit(127);
    }
  }
  ~TopInTerminal() override {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    ::close(terminal_);
  }
  /// Reads until the text was seen so often, for 10 s at most.
  bool sees(const std::string& text, int times) {
    const std::int64_t until_ms = steady_ms() + 10'000;
    while (count_of(text) < times && steady_ms() < until_ms) {
      pollfd waits{terminal_, POLLIN, 0};
      if (::poll(&waits, 1, 100) <= 0) continue;
      std::array<char, 4096> block;
      const ssize_t count = ::read(terminal_, block.data(), block.size());
      if (count <= 0) break;
      seen_.append(block.data(), static_cast<std::size_t>(count));
    }
    return count_of(text) >= times;
  }
  int count_of(const std::string& text) const {
    int count = 0;
    for (std::size_t at = seen_.find(text); at != std::string::npos;
         at = seen_.find(text, at + 1)) {
      ++count;
    }
    return count;
  }
  /// Its exit code; -1: it did not end.
  int code() {
    int status = 0;
    for (int i = 0; i < 200; ++i) {
      sees("nothing that it says", 0);
      if (::waitpid(process_, &status, WNOHANG) == process_) {
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      }
      ::usleep(20'000);
    }
    return -1;
  }

  int terminal_ = -1;
  pid_t process_ = -1;
  std::string seen_;
};

TEST_F(TopInTerminal, looks_again_until_q_is_pressed_and_leaves_the_screen_as_it_was) {
  ASSERT_TRUE(sees("job-7", 3)) << seen_;
  EXPECT_EQ(count_of("\033[?1049h"), 1);
  EXPECT_EQ(::write(terminal_, "x", 1), 1);
  ASSERT_TRUE(sees("q quits", 5)) << "other keys mean nothing";
  EXPECT_EQ(::write(terminal_, "q", 1), 1);
  EXPECT_TRUE(sees("\033[?1049l", 1));
  EXPECT_EQ(code(), 0);
}

TEST_F(TopInTerminal, leaves_the_screen_as_it_was_after_an_interruption) {
  ASSERT_TRUE(sees("job-7", 1)) << seen_;
  ::kill(process_, SIGINT);
  EXPECT_TRUE(sees("\033[?1049l", 1));
  EXPECT_EQ(code(), 0);
}

}  // namespace
}  // namespace tetfarm
