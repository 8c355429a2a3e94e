#include "json/query_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

wire::TaskLine task_that_runs() {
  wire::TaskLine task;
  task.set_task(3);
  task.set_path(6);
  task.set_worker(2);
  task.set_state("leased");
  *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  return task;
}

TEST(QueryJson, of_a_task_that_runs_keeps_the_word_of_programs_and_tells_what_it_does) {
  const Json json = Json::parse(task_json(task_that_runs()));
  EXPECT_EQ(json["state"], "leased");
  EXPECT_EQ(json["place"], "RL");
  EXPECT_EQ(json["worker"], "worker-2");
  EXPECT_EQ(json["doing_stage"], "edges");
  EXPECT_EQ(json["doing_done"], 312);
}

TEST(QueryJson, of_an_explanation_is_that_of_its_task_with_attempts_and_inputs) {
  wire::Explanation explanation;
  *explanation.mutable_task() = task_that_runs();
  explanation.add_attempts()->set_attempt(5);
  explanation.add_inputs()->set_name("surface");
  const Json json = Json::parse(explanation_json(explanation));
  EXPECT_EQ(json["type"], "explanation");
  EXPECT_EQ(json["task"], 3);
  EXPECT_EQ(json["attempts"][0]["attempt"], 5);
  EXPECT_EQ(json["inputs"][0]["is_there"], false);
}

TEST(QueryJson, of_an_attempt_has_its_log_on_demand_only) {
  wire::AttemptLine attempt;
  attempt.set_log("line");
  attempt.set_started_ms(1000);
  attempt.set_ended_ms(3500);
  EXPECT_FALSE(Json::parse(attempt_json(attempt, false)).contains("log"));
  EXPECT_EQ(Json::parse(attempt_json(attempt, true))["log"], "line");
  EXPECT_EQ(Json::parse(attempt_json(attempt, true))["seconds"], 2.5);
}

TEST(QueryJson, counts_the_failed_attempts_of_a_worker) {
  wire::WorkerLine worker;
  worker.set_not_done(2);
  EXPECT_EQ(Json::parse(worker_json(worker))["attempts_not_done"], 2);
}

}  // namespace
}  // namespace tetfarm
