// A run that is stopped, joined by a second one, or given more workers than it has work for.
#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::run_program;
using ::testing::HasSubstr;
using ::testing::Not;

class RunUnderWay : public ::testing::Test {
 protected:
  /// A run whose task is stopped by SIGSTOP: it takes as long as we like.
  std::unique_ptr<Program> run_that_stands_still(int workers) {
    input_ = test::sphere_in_box(folder_.path(), 4, 2);
    auto run =
        std::make_unique<Program>(test::run_words(input_, "out", workers, 1), folder_.path());
    for (int i = 0; i < 4000 && run->is_running(); ++i) {
      for (const pid_t process : test::descendants(run->process())) {
        if (name_of(process) == "tetfarm-task" && ::kill(process, SIGSTOP) == 0) return run;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "no task was seen";
    return run;
  }

  static std::string name_of(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/comm");
    std::string name;
    std::getline(file, name);
    return name;
  }

  Ended look(std::vector<std::string> words) {
    words.insert(words.end(), {"--store", "out"});
    return run_program(words, folder_.path());
  }

  test::TemporaryFolder folder_;
  std::string input_;
};

TEST_F(RunUnderWay, says_when_it_is_stopped_what_work_is_lost_and_is_stopped_then) {
  const auto run = run_that_stands_still(1);
  run->signal(SIGINT);
  const Ended ended = run->wait();
  EXPECT_EQ(ended.code, 75);
  EXPECT_THAT(ended.err, HasSubstr("lost, to be done again from the start: "));
  EXPECT_THAT(ended.err, HasSubstr(" s of work"));
  EXPECT_EQ(test::result_of(ended)["type"], "stopped");
  EXPECT_EQ(test::result_of(ended)["tasks_lost"].size(), 1U);
  const nlohmann::json job = test::result_of(look({"jobs", "--json"}));
  EXPECT_EQ(job["state"], "stopped");
  EXPECT_EQ(job["tasks_running"], 0);
  EXPECT_THAT(look({"jobs"}).out, Not(HasSubstr("running")));
  EXPECT_THAT(look({"status"}).out, HasSubstr("stopped"));
  EXPECT_EQ(run_program(test::run_words(input_, "out", 1, 1), folder_.path()).code, 0);
  EXPECT_EQ(test::result_of(look({"jobs", "--json"}))["state"], "done");
}

TEST_F(RunUnderWay, is_stopped_too_when_it_was_killed) {
  const auto run = run_that_stands_still(1);
  run->signal(SIGKILL);
  run->wait();
  // Its processes die with it, each when the kernel comes to it.
  const auto state = [&] {
    return test::result_of(look({"jobs", "--json", "--timeout", "0.2"})).value("state", "");
  };
  for (int i = 0; i < 100 && state() != "stopped"; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(state(), "stopped");
  EXPECT_THAT(look({"tasks", "--timeout", "0.2"}).out, Not(HasSubstr("running")));
}

TEST_F(RunUnderWay, keeps_a_second_run_out_of_its_folder_and_says_which_process_it_is) {
  const auto run = run_that_stands_still(1);
  const Ended second = run_program(test::run_words(input_, "out", 1, 1), folder_.path());
  EXPECT_EQ(second.code, 1);
  EXPECT_THAT(second.err, HasSubstr("error: out: another run is using this folder: process " +
                                    std::to_string(run->process()) + " on "));
}

TEST_F(RunUnderWay, has_no_more_workers_than_cores_while_there_is_one_task) {
  const auto run = run_that_stands_still(1000);
  const auto cores = static_cast<std::size_t>(std::thread::hardware_concurrency());
  EXPECT_LT(test::descendants(run->process()).size(), 3 * cores + 5);
  run->signal(SIGINT);
  EXPECT_THAT(run->wait().err, HasSubstr("note: -j 1000 is more than the "));
}

}  // namespace
}  // namespace tetfarm
