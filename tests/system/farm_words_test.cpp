// What the commands that act upon a farm say, and that all tell the same of a job.
#include <algorithm>

#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Ended;
using ::testing::HasSubstr;

class FarmWords : public test::Daemon {};

TEST_F(FarmWords, tell_the_same_elements_of_a_job_and_what_cannot_be_cancelled) {
  const auto worker = start_worker();
  const std::string job = submit(test::sphere_in_box(folder_.path(), 6, 2));
  const nlohmann::json waited = test::result_of(wait_for(job));
  ASSERT_GT(waited["elements"], 0);
  EXPECT_EQ(test::result_of(ask({"jobs", "--json"}))["elements"], waited["elements"]);
  EXPECT_EQ(test::result_of(ask({"status", job, "--json"}))["elements"], waited["elements"]);
  const Ended cancel = ask({"cancel", job});
  EXPECT_EQ(cancel.code, 1);
  EXPECT_EQ(cancel.out, "");
  EXPECT_THAT(cancel.err, HasSubstr(job + " is already done: there is nothing to cancel"));
  EXPECT_EQ(ask({"drain", "--all"}).out, "1 worker is draining\n");
}

TEST_F(FarmWords, of_a_waiting_task_say_what_is_known_of_it) {
  const std::string job = submit(test::sphere_in_box(folder_.path(), 4, 1));
  const Ended explained = ask({"explain", "1"});
  EXPECT_THAT(explained.out, HasSubstr("no worker is connected"));
  EXPECT_THAT(explained.out, ::testing::Not(HasSubstr(" and ,")));
  EXPECT_THAT(ask({"cancel", job}).out, HasSubstr(job + " cancelled"));
  EXPECT_THAT(ask({"cancel", job}).out, HasSubstr(job + " was already cancelled"));
  EXPECT_EQ(ask({"drain", "--all"}).out, "0 workers are draining\n");
}

TEST_F(FarmWords, of_priorities_say_what_they_are_and_let_the_urgent_job_go_first) {
  const std::string first = submit(test::sphere_in_box(folder_.path(), 4, 1));
  const std::string second = submit(test::sphere_in_box(folder_.path(), 5, 1));
  EXPECT_EQ(ask({"priority", second, "10"}).out, second + " has priority 10\n");
  EXPECT_EQ(test::result_of(ask({"status", second, "--json"}))["priority"], 10);
  const auto worker = start_worker();
  wait_for(first);
  wait_for(second);
  std::map<std::string, std::int64_t> ended;
  std::istringstream lines(ask({"events", "--all", "--json"}).out);
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json event = nlohmann::json::parse(line);
    if (event["what"] == "assigned") ended.emplace(event["job"], event["event"]);
  }
  EXPECT_LT(ended.at(second), ended.at(first)) << "its first task was handed out first";
  const Ended late = ask({"priority", first, "1"});
  EXPECT_EQ(late.code, 1);
  EXPECT_THAT(late.err, HasSubstr(first + " is already done"));
  EXPECT_EQ(ask({"priority", "job-99", "1"}).code, 5);
}

TEST_F(FarmWords, of_a_job_that_waits_for_another_name_that_also_after_a_crash) {
  const std::string first = submit(test::sphere_in_box(folder_.path(), 4, 1));
  const Ended submitted = ask({"submit", test::sphere_in_box(folder_.path(), 5, 1), "--subdomains",
                               "2", "--store", "store", "--after", first});
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string second = submitted.out.substr(0, submitted.out.find('\n'));
  const Ended unknown =
      ask({"submit", test::sphere_in_box(folder_.path(), 5, 1), "--after", "job-11"});
  EXPECT_EQ(unknown.code, 5);
  EXPECT_THAT(unknown.err, HasSubstr("no job job-11 to wait for; did you mean `job-1`?"));
  coordinator_.reset();  // kill -9
  coordinator_ = start_coordinator(endpoint_);
  const nlohmann::json told = test::result_of(ask({"status", second, "--json"}));
  EXPECT_EQ(told["state"], "waiting");
  EXPECT_EQ(told["waits_for"], nlohmann::json::array({first}));
  EXPECT_THAT(ask({"jobs"}).out, HasSubstr("waits for " + first));
  EXPECT_THAT(ask({"status"}).out, HasSubstr("waits for " + first));
  EXPECT_THAT(ask({"explain", "2"}).out, HasSubstr("its job waits for " + first));
  const auto worker = start_worker();
  EXPECT_EQ(wait_for(second).code, 0);
  std::vector<std::string> assigned;
  std::istringstream lines(ask({"events", "--all", "--json"}).out);
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json event = nlohmann::json::parse(line);
    if (event["what"] == "assigned" || event["what"] == "job done")
      assigned.push_back(event["job"]);
  }
  EXPECT_TRUE(std::is_sorted(assigned.begin(), assigned.end())) << "one after the other";
}

}  // namespace
}  // namespace tetfarm
