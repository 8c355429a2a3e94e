/// What the system tests with real batch systems share: a coordinator on loopback, a pool, a job of
/// eight sub-domains, and the mesh that a local run makes of it.
#pragma once

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "pool/run_command.h"
#include "tests/system/farm_cases.h"

namespace tetfarm::test {

/// `condition` becomes true within `seconds`.
inline bool comes_true(double seconds, const std::function<bool()>& condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return true;
}

inline std::string shell(const std::string& line) {
  return run_command({{"bash", "-c", line}, ""}, 120'000).out;
}

inline std::string sources() { return TETFARM_SOURCE_DIR; }

class BatchFarm : public ::testing::Test {
 protected:
  static constexpr int most_jobs = 3;

  /// Whether the test can run. Where continuous integration is to have everything, what is missing
  /// is a failure.
  static bool is_there(bool installed, const std::string& what, const std::string& how) {
    if (installed) return true;
    const char* ci = std::getenv("CI");
    const std::string words = what + " is not installed: " + how;
    if (ci != nullptr && std::string(ci) == "1") {
      ADD_FAILURE() << words;
    } else {
      std::printf("%s\n", words.c_str());
    }
    return false;
  }

  void start_coordinator(const std::filesystem::path& folder) {
    folder_ = folder;
    coordinator_ = std::make_unique<Program>(
        std::vector<std::string>{"coordinator", "--store", "store", "--listen",
                                 endpoint_.empty() ? "tcp://127.0.0.1:*" : endpoint_,
                                 "--heartbeat-ms", "200", "--lease-ms", "3000"},
        folder_, launcher_);
    if (endpoint_.empty()) endpoint_ = endpoint_of(*coordinator_);
  }

  /// Squares along an edge of the box: a job of half a million tets, which a farm does in seconds,
  /// and one of four million, whose tasks are still there when something was killed.
  static constexpr int small_job = 36;
  static constexpr int larger_job = 80;

  /// The job, and the digest that it must have.
  void submit_job(int box_squares) {
    const std::string input = sphere_in_box(folder_, box_squares, 4);
    const Ended local = run_program(run_words(input, "local", 2, 8), folder_);
    digest_ = digest_of(local);
    ASSERT_EQ(digest_.size(), 32U) << local.err;
    const Ended submitted = ask({"submit", input, "--subdomains", "8", "--store", "store"});
    ASSERT_EQ(submitted.code, 0) << submitted.err;
    job_ = submitted.out.substr(0, submitted.out.find('\n'));
  }

  /// Pools of tests that run at the same time on this machine are not to be one.
  static std::string pool_name() { return "test" + std::to_string(::getpid()); }

  std::unique_ptr<Program> pool(const std::string& system, std::vector<std::string> more) {
    std::vector<std::string> words = {
        "pool",     system,      "--connect",  endpoint_,
        "--name",   pool_name(), "--max",      std::to_string(most_jobs),
        "--memory", "1GB",       "--interval", "0.5",
        "--idle",   "3",         "--grace",    "5",
        "--logs",   "logs",      "--json"};
    if (has_shared_store_) words.insert(words.end(), {"--store", "store"});
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<Program>(words, folder_, launcher_);
  }

  Ended ask(std::vector<std::string> words) {
    words.insert(words.end(), {"--connect", endpoint_});
    return Program(words, folder_, launcher_).wait(400);
  }
  nlohmann::json status() { return result_of(ask({"status", job_, "--json"})); }
  bool has_done(std::uint64_t tasks) {
    const nlohmann::json now = status();
    return now.is_object() && now.value("tasks_done", std::uint64_t{0}) >= tasks;
  }

  std::uint64_t lost_attempts() { return status().value("attempts_lost", std::uint64_t{0}); }

  /// Kills what runs tasks while some run, by `kill`, which says whether there was something, until
  /// an attempt is lost: one that dies between two tasks loses none.
  bool loses_an_attempt(const std::function<bool()>& kill) {
    constexpr double longer_than_a_lease = 5;
    const auto is_working = [this] {
      const nlohmann::json now = status();
      return now.is_object() && now.value("tasks_running", std::uint64_t{0}) > 0;
    };
    const auto is_one_lost = [this] { return lost_attempts() > 0; };
    return comes_true(120, [&] {
      return is_working() && kill() && comes_true(longer_than_a_lease, is_one_lost);
    });
  }

  void expect_the_mesh_of_a_local_run() {
    const Ended ended =
        ask({"wait", job_, "-o", "out", "--store", "store", "--json", "--progress", "none"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(digest_of(ended), digest_);
  }

  /// The workers' own words.
  void expect_that_files_came_over_the_connection() const {
    bool is_said = false;
    for (const auto& log : std::filesystem::directory_iterator(folder_ / "logs")) {
      is_said |= contents(log.path()).find("files are transferred over the connection") !=
                 std::string::npos;
    }
    EXPECT_TRUE(is_said);
  }

  std::filesystem::path folder_;
  std::vector<std::string> launcher_;  ///< of what runs where the batch system does
  bool has_shared_store_ = true;       ///< which the workers are told of
  std::string endpoint_;
  std::string job_;
  std::string digest_;
  std::unique_ptr<Program> coordinator_;
};

/// Looks again and again how many jobs there are, until it goes.
class JobCounter {
 public:
  explicit JobCounter(std::function<int()> count)
      : thread_([this, count = std::move(count)](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            most_ = std::max(most_.load(), count());
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
          }
        }) {}
  int most() const { return most_; }

 private:
  std::atomic<int> most_ = 0;
  std::jthread thread_;
};

}  // namespace tetfarm::test
