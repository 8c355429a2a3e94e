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

TEST(QueryJson, of_a_task_has_all_that_is_known_of_it) {
  wire::TaskLine task;
  task.set_task(31);
  task.set_job("job-7");
  task.set_kind("mesh");
  task.set_path(5);
  task.set_state("done");
  task.set_attempt(40);
  task.set_worker(4);
  task.set_host("node1");
  task.set_crashes(1);
  task.set_losses(2);
  task.set_oom_count(3);
  task.set_seconds(2.5);
  task.set_peak_rss_bytes(100);
  task.set_memory_bytes(200);
  task.set_expected_seconds(3.5);
  task.set_cpu_seconds(4.5);
  task.set_expected_bytes(300);
  task.set_expected_elements(400);
  task.set_elements(500);
  task.set_min_dihedral_deg(21.5);
  task.set_exit_code(6);
  task.set_message("why");
  EXPECT_EQ(task_json(task),
            R"({"type":"task","task":31,"job":"job-7","kind":"mesh","path":5,"place":"LR",)"
            R"("state":"done","attempt":40,"worker":"worker-4","host":"node1","errors":1,)"
            R"("losses":2,"out_of_memory":3,"seconds":2.5,"peak_rss_bytes":100,)"
            R"("memory_bytes":200,"expected_seconds":3.5,"cpu_seconds":4.5,)"
            R"("expected_bytes":300.0,"expected_elements":400.0,"elements":500.0,)"
            R"("min_dihedral_deg":21.5,)"
            R"("exit_code":6,"message":"why","doing":"","doing_stage":"","doing_pass":0,)"
            R"("doing_done":0,"doing_total":0,"share":0.0})");
}

wire::AttemptLine whole_attempt() {
  wire::AttemptLine attempt;
  attempt.set_attempt(40);
  attempt.set_job("job-7");
  attempt.set_task(31);
  attempt.set_kind("mesh");
  attempt.set_path(5);
  attempt.set_worker(4);
  attempt.set_host("node1");
  attempt.set_process(471);
  attempt.set_state("done");
  attempt.set_races(true);
  attempt.set_started_ms(1000);
  attempt.set_ended_ms(3500);
  attempt.set_memory_bytes(100);
  attempt.set_peak_rss_bytes(200);
  attempt.set_message("why");
  return attempt;
}

constexpr const char* json_of_whole_attempt =
    R"({"type":"attempt","attempt":40,"job":"job-7","task":31,"kind":"mesh","path":5,)"
    R"("worker":"worker-4","host":"node1","process":471,"state":"done","races":true,)"
    R"("started_ms":1000,"ended_ms":3500,"seconds":2.5,"memory_bytes":100,)"
    R"("peak_rss_bytes":200,"message":"why"})";

TEST(QueryJson, of_an_attempt_has_all_that_is_known_of_it) {
  EXPECT_EQ(attempt_json(whole_attempt(), false), json_of_whole_attempt);
}

TEST(QueryJson, of_a_worker_and_of_an_event_has_all_that_is_known_of_it) {
  wire::WorkerLine worker;
  worker.set_worker(4);
  worker.set_host("node1");
  worker.set_process(471);
  worker.set_state("busy");
  worker.set_task(31);
  worker.set_cores(8);
  worker.set_memory_bytes(100);
  worker.set_program_version("0.1.0");
  worker.set_seen_ms(1000);
  worker.set_done(5);
  worker.set_not_done(6);
  worker.set_busy_seconds(2.5);
  worker.set_host_in_quarantine(true);
  EXPECT_EQ(worker_json(worker),
            R"({"type":"worker","worker":"worker-4","host":"node1","process":471,"state":"busy",)"
            R"("task":31,"cores":8,"memory_bytes":100,"version":"0.1.0","since_ms":1000,)"
            R"("attempts_done":5,"attempts_not_done":6,"busy_seconds":2.5,)"
            R"("host_in_quarantine":true})");
  wire::EventLine event;
  event.set_event(9);
  event.set_wall_ms(1000);
  event.set_job("job-7");
  event.set_task(31);
  event.set_attempt(40);
  event.set_worker(4);
  event.set_what("crashed");
  event.set_message("why");
  EXPECT_EQ(event_json(event),
            R"({"type":"event","event":9,"wall_ms":1000,"job":"job-7","task":31,"attempt":40,)"
            R"("worker":"worker-4","what":"crashed","message":"why"})");
}

TEST(QueryJson, of_an_explanation_has_reasons_limits_attempts_and_inputs) {
  wire::Explanation explanation;
  explanation.mutable_task()->set_task(31);
  explanation.set_subdomain_state("leaf");
  explanation.add_reasons("first");
  explanation.add_reasons("second");
  explanation.set_expected_seconds(1.5);
  explanation.set_limit_seconds(2.5);
  explanation.set_room_bytes(100);
  *explanation.add_attempts() = whole_attempt();
  wire::InputLine& input = *explanation.add_inputs();
  input.set_name("surface");
  input.set_hash("abc");
  input.set_size(7);
  input.set_is_there(true);
  input.set_made_by(30);
  const Json json = Json::parse(explanation_json(explanation));
  EXPECT_EQ(json["subdomain"], "leaf");
  EXPECT_EQ(json["reasons"], Json({"first", "second"}));
  EXPECT_EQ(json["expected_seconds"], 1.5);
  EXPECT_EQ(json["limit_seconds"], 2.5);
  EXPECT_EQ(json["room_bytes"], 100);
  EXPECT_EQ(json["attempts"][0].dump(), json_of_whole_attempt);
  EXPECT_EQ(json["inputs"][0].dump(),
            R"({"name":"surface","hash":"abc","size":7,"is_there":true,"made_by_task":30})");
}

}  // namespace
}  // namespace tetfarm
