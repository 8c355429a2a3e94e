/// A coordinator, workers that come over TCP, and clients, as processes of their own.
#pragma once

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "store/job_database.h"
#include "tests/system/farm_cases.h"

namespace tetfarm::test {

class Daemon : public ::testing::Test {
 protected:
  /// `more`: words for the coordinator.
  explicit Daemon(std::vector<std::string> more = {})
      : more_(std::move(more)), coordinator_(start_coordinator("tcp://127.0.0.1:*")) {
    endpoint_ = endpoint_of(*coordinator_);
  }

  std::unique_ptr<Program> start_coordinator(const std::string& endpoint) {
    std::vector<std::string> words = {"coordinator", "--store",    "store",
                                      "--listen",    endpoint,     "--heartbeat-ms",
                                      "200",         "--lease-ms", "2000"};
    words.insert(words.end(), more_.begin(), more_.end());
    return std::make_unique<Program>(words, folder_.path());
  }

  std::unique_ptr<Program> start_worker(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"worker", "--connect", endpoint_, "--store", "store"};
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<Program>(words, folder_.path());
  }

  static std::string name_of(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/comm");
    std::string name;
    std::getline(file, name);
    return name;
  }

  static void pause_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

  /// The process of the task that the worker runs, if it runs one.
  static std::optional<pid_t> task_of(const Program& worker) {
    for (const pid_t process : descendants(worker.process())) {
      if (name_of(process) == "tetfarm-task") return process;
    }
    return {};
  }

  /// The same, stopped: a task that takes as long as we like.
  static pid_t stop_task_of(const Program& worker) {
    for (int i = 0; i < 4000; ++i) {
      const std::optional<pid_t> task = task_of(worker);
      if (task && ::kill(*task, SIGSTOP) == 0) return *task;
      pause_ms(5);
    }
    ADD_FAILURE() << "the worker runs no task";
    return -1;
  }

  std::vector<AttemptRow> attempts() const {
    return JobDatabase(folder_.path() / "store" / "tetfarm.db").history().attempts_of({}, {}, 1000);
  }
  bool comes_true(const std::function<bool(const std::vector<AttemptRow>&)>& wish) const {
    for (int i = 0; i < 400; ++i) {
      if (wish(attempts())) return true;
      pause_ms(50);
    }
    return false;
  }

  Ended ask(std::vector<std::string> words) {
    words.insert(words.end(), {"--connect", endpoint_});
    return run_program(words, folder_.path());
  }

  std::string submit(const std::string& input, int subdomains = 4) {
    const Ended ended =
        ask({"submit", input, "--subdomains", std::to_string(subdomains), "--store", "store"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find('\n'));
  }

  Ended wait_for(const std::string& job) {
    return ask({"wait", job, "-o", "out", "--store", "store", "--json", "--progress", "none"});
  }

  std::vector<std::string> more_;
  TemporaryFolder folder_;
  std::string endpoint_;
  std::unique_ptr<Program> coordinator_;
};

}  // namespace tetfarm::test
