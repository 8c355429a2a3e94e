#include "json/job_json.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Json result_of(const wire::JobStatus& status) { return Json::parse(result_json(status, 1, {})); }

TEST(JobJson, names_subdomains_that_could_not_be_cut_or_were_cut_further_by_their_ways) {
  wire::JobStatus status;
  (*status.mutable_texts())["uncut:5"] = "36 candidates refused: angle 30, intersection 6";
  (*status.mutable_texts())["cut_further:6"] = "mesh of sub-domain 6 ran out of memory";
  EXPECT_EQ(result_of(status)["uncut_subdomains"],
            Json({{"LR", "36 candidates refused: angle 30, intersection 6"}}));
  const Json further = {{"RL", "mesh of sub-domain 6 ran out of memory"}};
  EXPECT_EQ(result_of(status)["cut_further"], further);
  EXPECT_EQ(Json::parse(status_json(status))["cut_further"], further);
}

TEST(JobJson, has_figures_of_tets_without_forced_angles_only_where_there_are_such_tets) {
  wire::JobStatus status;
  EXPECT_TRUE(result_of(status)["unforced"].is_null());
  auto& numbers = *status.mutable_numbers();
  numbers["unforced_elements"] = 1000;
  numbers["unforced_min_dihedral_deg"] = 14.3;
  numbers["unforced_worst_x"] = 0.5;
  EXPECT_EQ(result_of(status)["unforced"],
            Json({{"elements", 1000}, {"min_dihedral_deg", 14.3}, {"worst_at", {0.5, 0.0, 0.0}}}));
}

TEST(JobJson, of_a_job_with_layers_counts_cells_by_type_and_tells_how_much_of_the_wall_has_them) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  numbers["elements"] = 70;
  EXPECT_FALSE(result_of(status).contains("layers"));
  EXPECT_FALSE(result_of(status).contains("prisms"));
  numbers["layers_wall_triangles"] = 12;
  EXPECT_EQ(result_of(status)["tets"], 70) << "nothing grew";
  for (const auto& [name, number] :
       std::initializer_list<std::pair<const char*, double>>{{"tets", 40},
                                                             {"pyramids", 10},
                                                             {"prisms", 20},
                                                             {"layers_full", 7},
                                                             {"layers_partial", 3},
                                                             {"layers_none", 2},
                                                             {"layers_with_first", 10},
                                                             {"layers_first_within_2", 5},
                                                             {"layers_first_within_10", 9},
                                                             {"layers_short_no_room", 4},
                                                             {"layers_short_ridge", 1}}) {
    numbers[name] = number;
  }
  const Json result = result_of(status);
  EXPECT_EQ(result["elements"], 70);
  EXPECT_EQ(result["tets"], 40);
  EXPECT_EQ(result["pyramids"], 10);
  EXPECT_EQ(result["prisms"], 20);
  EXPECT_EQ(result["layers"], Json({{"wall_triangles", 12},
                                    {"full", 7},
                                    {"partial", 3},
                                    {"none", 2},
                                    {"by_reason", {{"no_room", 4}, {"ridge", 1}}},
                                    {"first_height_within_2_percent", 50.0},
                                    {"first_height_within_10_percent", 90.0}}));
  numbers["layers_min_scaled_jacobian"] = 0.25;
  numbers["task_grow_cpu_seconds"] = 0.5;
  EXPECT_EQ(result_of(status)["layers"]["min_scaled_jacobian"], 0.25);
  EXPECT_FALSE(result_of(status)["layers"].contains("top_jump_99"));
  numbers["layers_top_jump_99"] = 2.5;
  EXPECT_EQ(result_of(status)["layers"]["top_jump_99"], 2.5);
  EXPECT_EQ(result_of(status)["layers"]["prisms_per_second"], 40);
  numbers["prisms"] = 0;
  EXPECT_FALSE(result_of(status)["layers"].contains("prisms_per_second")) << "layers in tets";
  numbers["prisms"] = 20;
  EXPECT_FALSE(result.contains("boundary_quads"));
  numbers["quads"] = 60;
  EXPECT_EQ(result_of(status)["boundary_quads"], 60);
  numbers["layers_planes"] = 2;
  numbers["layers_plane_triangles_before"] = 30;
  numbers["layers_plane_triangles_after"] = 25;
  numbers["layers_plane_quads"] = 60;
  const Json layers = result_of(status)["layers"];
  EXPECT_EQ(layers["planes"], 2);
  EXPECT_EQ(layers["plane_triangles_before"], 30);
  EXPECT_EQ(layers["plane_triangles_after"], 25);
  EXPECT_EQ(layers["plane_quads"], 60);
}

TEST(JobJson, of_regions_has_their_names_volumes_and_figures) {
  wire::JobStatus status;
  (*status.mutable_texts())["region_1_name"] = "fluid";
  (*status.mutable_texts())["region_1_dihedral_histogram"] = "3 0 7";
  (*status.mutable_numbers())["region_1_volume"] = 2.5;
  (*status.mutable_numbers())["region_1_elements"] = 10;
  const Json regions = result_of(status)["regions"];
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0]["name"], "fluid");
  EXPECT_EQ(regions[0]["volume"], 2.5);
  EXPECT_EQ(regions[0]["dihedral_histogram"], Json({3, 0, 7}));
}

TEST(JobJson, is_not_forged_by_the_names_and_words_of_others) {
  const std::string forged = "x\njob-9    wing     done\x1b[2J\xff";
  wire::StatusReply reply;
  wire::JobStatus& job = *reply.add_jobs();
  job.set_name(forged);
  job.set_message(forged);
  job.add_quarantine()->set_reason(forged);
  reply.add_hosts()->set_host(forged);
  reply.add_at_work()->set_host(forged);
  for (const std::string& json : {status_json(job), farm_events_json(reply, true)}) {
    EXPECT_THAT(json, AllOf(HasSubstr("\\u001b[2J\ufffd"), Not(HasSubstr("\x1b"))));
  }
}

TEST(JobJson, of_workers_is_given_on_demand_only) {
  wire::StatusReply reply;
  reply.add_at_work()->set_worker(3);
  EXPECT_EQ(farm_events_json(reply, false), "");
  EXPECT_THAT(farm_events_json(reply, true), HasSubstr("\"worker\":\"worker-3\""));
}

/// Figures whose values tell them apart.
wire::JobStatus finished_job() {
  wire::JobStatus status;
  status.set_job("job-7");
  status.set_name("wing");
  status.set_peak_rss_bytes_worker(123);
  status.set_attempts_lost(4);
  auto& numbers = *status.mutable_numbers();
  double next = 1;
  for (const char* name : {"elements",
                           "nodes",
                           "boundary_triangles",
                           "subdomains",
                           "min_dihedral_deg",
                           "max_dihedral_deg",
                           "mean_radius_ratio",
                           "volume",
                           "worst_x",
                           "worst_y",
                           "worst_z",
                           "forced_dihedral_deg",
                           "forced_x",
                           "forced_y",
                           "forced_z",
                           "smallest_height",
                           "near_cuts_elements",
                           "near_cuts_min_dihedral_deg",
                           "near_cuts_max_dihedral_deg",
                           "near_cuts_mean_radius_ratio",
                           "near_cuts_smallest_height",
                           "away_from_cuts_elements",
                           "min_dihedral_gate_deg"}) {
    numbers[name] = next++;
  }
  auto& texts = *status.mutable_texts();
  texts["digest"] = "d1g";
  texts["near_cuts_dihedral_histogram"] = "1 2 3";
  return status;
}

TEST(JobJson, of_a_result_has_each_figure_under_its_name) {
  const Json json = Json::parse(result_json(finished_job(), 72.5, {"out/a", "out/b"}));
  const Json expected = Json::parse(R"({
    "type":"result", "job":"job-7", "name":"wing", "elements":1, "nodes":2,
    "boundary_triangles":3, "subdomains":4, "min_dihedral_deg":5.0, "max_dihedral_deg":6.0,
    "mean_radius_ratio":7.0, "volume":8.0, "worst_at":[9.0,10.0,11.0],
    "forced_dihedral_deg":12.0, "forced_at":[13.0,14.0,15.0], "smallest_height":16.0,
    "unforced":null,
    "gates":[{"key":"min_dihedral", "limit_deg":23.0, "smallest_deg":5.0, "at":[9.0,10.0,11.0],
              "passed":false}],
    "remarks":[],
    "near_cuts":{"elements":17, "min_dihedral_deg":18.0, "max_dihedral_deg":19.0,
                 "mean_radius_ratio":20.0, "smallest_height":21.0,
                 "dihedral_histogram":[1,2,3]},
    "away_from_cuts":{"elements":22, "min_dihedral_deg":0.0, "max_dihedral_deg":0.0,
                      "mean_radius_ratio":0.0, "smallest_height":0.0, "dihedral_histogram":[]},
    "regions":[], "uncut_subdomains":{}, "cut_further":{}, "seconds":72.5,
    "peak_rss_bytes_worker":123, "attempts_lost":4, "balance":{}, "tasks":{}, "digest":"d1g",
    "files":["out/a","out/b"]})");
  for (const auto& [key, value] : expected.items()) EXPECT_EQ(json[key], value) << key;
  EXPECT_EQ(json.size(), expected.size() + 1) << "and `surface`";
}

TEST(JobJson, of_balance_has_what_is_known_so_far) {
  wire::JobStatus status;
  EXPECT_EQ(balance_json(status), Json::object());
  auto& numbers = *status.mutable_numbers();
  numbers["balance_estimated"] = 1.25;
  EXPECT_EQ(balance_json(status), Json({{"estimated", 1.25}}));
  numbers["balance_elements"] = 1.5;
  numbers["assimilated_groups"] = 4;
  double next = 2;
  for (const char* name : {"faces", "leaf_estimated", "leaf_faces"}) {
    numbers[std::string("assimilated_") + name + "_max"] = next * 10;
    numbers[std::string("assimilated_") + name + "_mean"] = 10;
    ++next;
  }
  numbers["assimilated_leaves"] = 9;
  numbers["assimilated_communication_nodes_max"] = 77;
  numbers["assimilated_communication_nodes_sum"] = 99;
  EXPECT_EQ(balance_json(status), Json({{"estimated", 1.25},
                                        {"elements", 1.5},
                                        {"faces", 2.0},
                                        {"leaves", 9.0},
                                        {"leaves_estimated", 3.0},
                                        {"leaves_faces", 4.0},
                                        {"communication_nodes_max", 77.0},
                                        {"communication_nodes_sum", 99.0}}));
}

TEST(JobJson, of_tasks_has_those_kinds_that_there_were) {
  wire::JobStatus status;
  double next = 1;
  for (const char* name : {"count", "bytes", "expected_bytes", "of_expected_bytes", "seconds",
                           "cpu_seconds", "expected_seconds"}) {
    (*status.mutable_numbers())[std::string("task_mesh_") + name] = next++;
  }
  EXPECT_EQ(tasks_json(status), Json({{"mesh",
                                       {{"count", 1.0},
                                        {"bytes", 2.0},
                                        {"expected_bytes", 3.0},
                                        {"of_expected_bytes", 4.0},
                                        {"seconds", 5.0},
                                        {"cpu_seconds", 6.0},
                                        {"expected_seconds", 7.0}}}}));
}

/// A job that runs, with values that tell its counts apart.
wire::JobStatus running_job() {
  wire::JobStatus job;
  job.set_job("job-7");
  job.set_name("wing");
  job.set_state("running");
  job.set_stage("mesh");
  job.add_after("job-3");
  job.add_after("job-5");
  job.add_waits_for("job-5");
  job.set_leaves_made(1);
  job.set_leaves_meshed(2);
  job.set_leaves_mended(3);
  job.set_elements(4);
  job.set_estimated_elements(5);
  job.set_tasks_done(6);
  job.set_tasks_ready(7);
  job.set_tasks_running(8);
  job.set_attempts_lost(9);
  job.set_crashes(10);
  job.set_oom_count(11);
  job.set_elements_under_way(12);
  job.set_peak_rss_bytes_worker(13);
  job.set_seconds(14);
  job.set_created_ms(15);
  job.set_finished_ms(16);
  job.set_message("why");
  job.set_exit_code(6);
  auto& numbers = *job.mutable_numbers();
  numbers["forecast_bytes"] = 17;
  numbers["forecast_disk_bytes"] = 18;
  numbers["forecast_seconds"] = 19;
  wire::TaskInQuarantine& task = *job.add_quarantine();
  task.set_task(31);
  task.set_kind("mesh");
  task.set_path(5);
  task.set_reason("crashed");
  task.set_exit_code(1);
  return job;
}

TEST(JobJson, of_a_job_that_runs_has_each_count_under_its_name) {
  EXPECT_EQ(
      status_json(running_job()),
      R"({"type":"job","job":"job-7","name":"wing","state":"running","stage":"mesh","priority":0,)"
      R"("after":["job-3","job-5"],"waits_for":["job-5"],)"
      R"("subdomains":1,"subdomains_meshed":2,"subdomains_mended":3,"elements":4,)"
      R"("estimated_elements":5.0,"expected_task_bytes":17.0,"expected_disk_bytes":18.0,)"
      R"("expected_cpu_seconds":19.0,"tasks_done":6,"tasks_ready":7,"tasks_running":8,)"
      R"("attempts_lost":9,"crashes":10,"out_of_memory":11,"quarantine":[{"task":31,)"
      R"("kind":"mesh","path":5,"reason":"crashed","exit_code":1}],"running":[],)"
      R"("elements_under_way":12.0,"peak_rss_bytes_worker":13,"seconds":14.0,)"
      R"("balance":{},"cut_further":{},"message":"why","exit_code":6})");
  EXPECT_EQ(
      job_json(running_job()),
      R"({"type":"job","job":"job-7","name":"wing","state":"running","stage":"mesh","priority":0,)"
      R"("after":["job-3","job-5"],"waits_for":["job-5"],)"
      R"("subdomains":1,"subdomains_meshed":2,"elements":4,"estimated_elements":5.0,)"
      R"("tasks_done":6,"tasks_ready":7,"tasks_running":8,"tasks_in_quarantine":1,)"
      R"("created_ms":15,"finished_ms":16,"seconds":14.0,"message":"why","exit_code":6})");
}

TEST(JobJson, of_a_farm_has_who_is_there_and_what_was_refused) {
  wire::StatusReply reply;
  reply.set_workers(2);
  reply.add_jobs();
  reply.set_security("keys");
  reply.set_connections(3);
  reply.set_authorized_keys(4);
  (*reply.mutable_refused())["version"] = 6;
  (*reply.mutable_refused())["garbage"] = 5;
  const std::string farm =
      R"({"type":"farm","workers":2,"jobs":1,"security":"keys","connections":3,)"
      R"("authorized_keys":4,"refused":{"garbage":5,"version":6})";
  EXPECT_EQ(farm_json(reply), farm + "}");
  reply.set_trouble("the disk is full");
  EXPECT_EQ(farm_json(reply), farm + R"(,"trouble":"the disk is full"})");
}

TEST(JobJson, of_hosts_and_workers_is_a_line_for_each) {
  wire::StatusReply reply;
  wire::HostInQuarantine& host = *reply.add_hosts();
  host.set_host("node5");
  host.set_reason("crashes");
  host.set_since_ms(1000);
  wire::WorkerStatus& worker = *reply.add_at_work();
  worker.set_worker(4);
  worker.set_host("node1");
  worker.set_process(471);
  worker.set_task(31);
  worker.set_drains(true);
  worker.set_memory_bytes(100);
  const std::string hosts =
      "{\"type\":\"host_in_quarantine\",\"host\":\"node5\",\"reason\":\"crashes\","
      "\"since_ms\":1000}\n";
  EXPECT_EQ(farm_events_json(reply, false), hosts);
  EXPECT_EQ(farm_events_json(reply, true),
            hosts +
                "{\"type\":\"worker\",\"worker\":\"worker-4\",\"host\":\"node1\","
                "\"process\":471,\"task\":31,\"drains\":true,\"memory_bytes\":100}\n");
}

TEST(JobJson, of_files_and_errors_is_one_line) {
  EXPECT_EQ(copy_json("backup", "a.db"), R"({"type":"backup","file":"a.db"})");
  EXPECT_EQ(error_json("it broke", 3), R"({"type":"error","message":"it broke","exit_code":3})");
}

TEST(JobJson, of_regions_has_all_whose_names_are_told_one_after_the_other) {
  wire::JobStatus status;
  for (const int region : {1, 2, 4}) {
    (*status.mutable_texts())["region_" + std::to_string(region) + "_name"] = "r";
    (*status.mutable_numbers())["region_" + std::to_string(region) + "_elements"] = 5;
  }
  const Json regions = result_of(status)["regions"];
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[1]["number"], 2);
}

}  // namespace
}  // namespace tetfarm
