#include "dashboard/fetched_answers.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/dashboard/fake_farm.h"

namespace tetfarm {
namespace {

/// A farm whose clock stands still unless a test moves it.
class AnswersOfAFarm : public ::testing::Test {
 protected:
  ApiAnswer ask(const ApiRequest& request) { return answers_.answer(request, farm_, look_); }
  ApiAnswer ask(ApiSubject subject, const std::string& job, std::uint64_t number = 0) {
    ApiRequest request;
    request.subject = subject;
    request.job = job;
    request.number = number;
    return ask(request);
  }
  static nlohmann::json json_of(const ApiAnswer& answer) {
    return nlohmann::json::parse(*answer.body);
  }

  FakeFarm farm_;
  FarmLook look_;
  std::int64_t now_ms_ = 0;
  FetchedAnswers answers_{[this] { return LookTime{now_ms_, now_ms_}; }};
};

TEST_F(AnswersOfAFarm, tables_are_fetched_once_for_all_who_ask_within_two_seconds) {
  farm_.rows_of_page = 2;
  farm_.add_tasks(5);
  ApiRequest request;
  request.subject = ApiSubject::tasks;
  request.job = "job-1";
  for (const std::uint32_t limit : {3U, 5U, 3U}) {
    request.limit = limit;
    EXPECT_EQ(json_of(ask(request))["rows"].size(), limit);
  }
  EXPECT_EQ(farm_.times("TASKS"), 3) << "the pages of one table";
  now_ms_ += 2'000;
  ask(request);
  EXPECT_EQ(farm_.times("TASKS"), 6);
}

TEST_F(AnswersOfAFarm, single_jobs_are_fetched_once_within_two_seconds) {
  farm_.add_job(5, "done");
  for (int i = 0; i < 10; ++i) EXPECT_EQ(json_of(ask(ApiSubject::job, "job-5"))["job"], "job-5");
  EXPECT_EQ(farm_.times("job"), 1);
  now_ms_ += 2'000;
  ask(ApiSubject::job, "job-5");
  EXPECT_EQ(farm_.times("job"), 2);
}

TEST_F(AnswersOfAFarm, what_is_not_there_is_not_found) {
  EXPECT_EQ(ask(ApiSubject::job, "job-77").status, 404);
  EXPECT_EQ(ask(ApiSubject::task, "", 99).status, 404);
}

TEST_F(AnswersOfAFarm, acts_are_done_each_time_and_tell_what_came_of_them) {
  EXPECT_EQ(json_of(ask(ApiSubject::cancel_job, "job-5"))["found"], true);
  ask(ApiSubject::cancel_job, "job-5");
  EXPECT_EQ(farm_.times("cancel job-5"), 2);
  EXPECT_EQ(json_of(ask(ApiSubject::retry_job, "job-5"))["count"], 2);
  EXPECT_EQ(farm_.times("retry job-5 0"), 1);
  EXPECT_EQ(json_of(ask(ApiSubject::drain_worker, "", 3))["count"], 1);
  EXPECT_EQ(farm_.times("drain 3"), 1);
}

TEST_F(AnswersOfAFarm, a_host_is_taken_out_of_quarantine_by_its_name) {
  ApiRequest request;
  request.subject = ApiSubject::retry_host;
  request.host = "node 7";
  EXPECT_EQ(json_of(ask(request))["count"], 1);
  EXPECT_EQ(farm_.times("retry  0node 7"), 1);
}

TEST_F(AnswersOfAFarm, a_job_gets_the_priority_that_is_asked_for) {
  ApiRequest request;
  request.subject = ApiSubject::set_priority;
  request.job = "job-5";
  request.priority = -7;
  EXPECT_EQ(json_of(ask(request)),
            nlohmann::json({{"set", true}, {"priority", -7}, {"state", "running"}}));
  EXPECT_EQ(farm_.times("priority job-5 -7"), 1);
  request.job = "job-404";
  EXPECT_EQ(ask(request).status, 404);
}

TEST_F(AnswersOfAFarm, a_task_is_retried_as_one_of_its_job) {
  ask(ApiSubject::retry_task, "", 31);
  EXPECT_EQ(farm_.times("retry job-5 31"), 1);
}

TEST_F(AnswersOfAFarm, what_the_coordinator_refuses_is_forbidden_to_act_and_else_its_own_trouble) {
  farm_.refuses = "a viewer may not do this";
  const ApiAnswer act = ask(ApiSubject::cancel_job, "job-5");
  EXPECT_EQ(act.status, 403);
  EXPECT_EQ(json_of(act)["error"], "a viewer may not do this");
  EXPECT_EQ(ask(ApiSubject::job, "job-5").status, 502);
}

TEST_F(AnswersOfAFarm, an_unknown_column_is_a_bad_request) {
  ApiRequest request;
  request.subject = ApiSubject::attempts;
  request.job = "job-1";
  request.columns = {"colour"};
  EXPECT_EQ(ask(request).status, 400);
}

TEST_F(AnswersOfAFarm, silence_is_told_to_the_caller) {
  farm_.is_silent = true;
  EXPECT_THROW(ask(ApiSubject::job, "job-5"), NoAnswer);
}

}  // namespace
}  // namespace tetfarm
