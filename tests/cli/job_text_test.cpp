#include "cli/job_text.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <string>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

wire::JobStatus status_of_leaf_left_whole() {
  wire::JobStatus status;
  (*status.mutable_texts())["digest"] = "d";
  (*status.mutable_texts())["uncut:5"] = "36 candidates refused: angle 30, intersection 6";
  return status;
}

TEST(JobText, says_which_subdomain_could_not_be_cut_and_why) {
  const std::string text = result_text(status_of_leaf_left_whole(), 1, {});
  EXPECT_THAT(text, HasSubstr("sub-domain LR is larger than planned"));
  EXPECT_THAT(text, HasSubstr("36 candidates refused: angle 30, intersection 6"));
}

TEST(JobText, says_which_subdomain_was_cut_further_and_why) {
  wire::JobStatus status;
  (*status.mutable_texts())["cut_further:5"] = "mesh of sub-domain 5 ran out of memory";
  EXPECT_THAT(result_text(status, 1, {}),
              HasSubstr("sub-domain LR was cut further than planned: mesh of sub-domain 5 ran"));
}

TEST(JobText, of_many_subdomains_that_could_not_be_cut_names_a_few) {
  wire::JobStatus status;
  for (int heap = 512; heap < 930; ++heap) {
    (*status.mutable_texts())["uncut:" + std::to_string(heap)] = "too few elements";
  }
  const std::string text = result_text(status, 1, {});
  EXPECT_THAT(text, HasSubstr("and 413 more (--json lists all)"));
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 12);
}

TEST(JobText, of_a_mesh_with_layers_names_its_cells_and_how_much_of_the_wall_has_them) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  numbers["elements"] = 70;
  EXPECT_THAT(result_text(status, 1, {}),
              AllOf(HasSubstr("done       70 tets, "), Not(HasSubstr("layers"))));
  for (const auto& [name, number] :
       std::initializer_list<std::pair<const char*, double>>{{"tets", 50},
                                                             {"pyramids", 0},
                                                             {"prisms", 20},
                                                             {"layers_wall_triangles", 12},
                                                             {"layers_full", 7},
                                                             {"layers_partial", 3},
                                                             {"layers_none", 2},
                                                             {"layers_with_first", 8},
                                                             {"layers_first_within_2", 6},
                                                             {"layers_first_within_10", 8}}) {
    numbers[name] = number;
  }
  EXPECT_THAT(
      result_text(status, 1, {}),
      AllOf(HasSubstr("done       50 tets, 20 prisms, "),
            HasSubstr("layers: all on 7 of 12 triangles, fewer on 3, none on 2; first height "
                      "within 2 % on 75.00 %, within 10 % on 100.00 %\n")));
  numbers["layers_min_scaled_jacobian"] = 0.25;
  EXPECT_THAT(result_text(status, 1, {}),
              HasSubstr("within 10 % on 100.00 %; least Jacobian 0.25\n"));
  for (const auto& [name, number] :
       std::map<std::string, double>{{"layers_scaled_jacobian_1_percent", 0.875},
                                     {"layers_top_jump_median", 1.25},
                                     {"layers_top_jump_99", 2.5}}) {
    numbers[name] = number;
  }
  EXPECT_THAT(result_text(status, 1, {}),
              HasSubstr("; least Jacobian 0.25, of all but 1 % 0.875; tets on top over last "
                        "prisms: median 1.25, of all but 1 % 2.5\n"));
}

TEST(JobText, says_where_in_the_tree_a_task_in_quarantine_is) {
  wire::StatusReply reply;
  reply.set_workers(1);
  wire::JobStatus& job = *reply.add_jobs();
  job.set_state("running");
  wire::TaskInQuarantine& task = *job.add_quarantine();
  task.set_task(7);
  task.set_kind("mesh");
  task.set_path(6);
  task.set_reason("crashed");
  EXPECT_THAT(status_text(reply), HasSubstr("in quarantine: task 7, mesh RL: crashed"));
  EXPECT_THAT(status_text(reply), HasSubstr("1 worker, 1 job, "));
}

TEST(JobText, counts_one_subdomain_as_one) {
  wire::JobStatus status;
  (*status.mutable_numbers())["subdomains"] = 1;
  EXPECT_THAT(result_text(status, 1, {}), HasSubstr(" 1 sub-domain, "));
}

wire::JobStatus status_of_angles(double smallest, double largest) {
  wire::JobStatus status;
  (*status.mutable_numbers())["min_dihedral_deg"] = smallest;
  (*status.mutable_numbers())["max_dihedral_deg"] = largest;
  return status;
}

TEST(JobText, tells_a_small_angle_from_none) {
  const std::string text = result_text(status_of_angles(0.00213, 179.995), 1, {});
  EXPECT_THAT(text, HasSubstr("dihedral 0.0021 to 179.9950 deg"));
  EXPECT_THAT(text, HasSubstr("worst 0.0021 deg at "));
}

TEST(JobText, names_flat_tets_in_red_where_there_are_colours) {
  const std::string red = "\033[31mdihedral ";
  EXPECT_THAT(result_text(status_of_angles(0.2, 150), 1, {}, true),
              HasSubstr(red + "0.20 to 150.00 deg\033[0m"));
  EXPECT_THAT(result_text(status_of_angles(20, 179.5), 1, {}, true), HasSubstr(red));
  EXPECT_THAT(result_text(status_of_angles(12, 160), 1, {}, true), Not(HasSubstr("\033")));
  EXPECT_THAT(result_text(status_of_angles(0.2, 150), 1, {}), Not(HasSubstr("\033")));
}

TEST(JobText, says_how_good_the_mesh_is_where_the_surface_forces_nothing) {
  wire::JobStatus status = status_of_angles(0.0002, 170);
  auto& numbers = *status.mutable_numbers();
  numbers["unforced_elements"] = 1000;
  numbers["unforced_min_dihedral_deg"] = 14.3;
  EXPECT_THAT(result_text(status, 1, {}),
              HasSubstr("where the surface forces no small angles: smallest dihedral 14.30 deg"));
}

TEST(JobText, is_silent_when_all_were_cut) {
  EXPECT_THAT(result_text(wire::JobStatus(), 1, {}), Not(HasSubstr("larger than planned")));
}

TEST(JobText, is_not_forged_by_the_names_and_words_of_others) {
  const std::string forged = "x\njob-9    wing     done\x1b[2J\xff";
  const std::string shown = "x\\njob-9    wing     done\\u001b[2J\\xff";
  wire::StatusReply reply;
  wire::JobStatus& job = *reply.add_jobs();
  job.set_job("job-1");
  job.set_name(forged);
  job.set_state("running");
  job.set_message(forged);
  job.add_quarantine()->set_reason(forged);
  reply.add_hosts()->set_host(forged);
  reply.mutable_hosts(0)->set_reason(forged);
  reply.add_at_work()->set_host(forged);
  reply.mutable_at_work(0)->set_tag(forged);
  (*job.mutable_texts())["region_1_name"] = forged;
  for (const std::string& text :
       {status_text(reply), workers_text(reply), result_text(job, 1, {forged})}) {
    EXPECT_THAT(text, AllOf(HasSubstr(shown), Not(HasSubstr("\njob-9")), Not(HasSubstr("\x1b"))));
  }
}

/// Of a job with something to say in every line.
wire::JobStatus status_of_everything() {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  const auto put = [&numbers](const std::string& what, double x, double y, double z) {
    numbers[what + "_x"] = x;
    numbers[what + "_y"] = y;
    numbers[what + "_z"] = z;
  };
  numbers["elements"] = 1'234'567;
  numbers["nodes"] = 23'456;
  numbers["subdomains"] = 8;
  numbers["min_dihedral_deg"] = 12.5;
  numbers["max_dihedral_deg"] = 160.25;
  numbers["mean_radius_ratio"] = 0.8125;
  put("worst", 1, 2.5, -3);
  numbers["forced_dihedral_deg"] = 15;
  put("forced", 4, 5, 6);
  numbers["unforced_elements"] = 100;
  numbers["unforced_min_dihedral_deg"] = 18;
  put("unforced_worst", 7, 8, 9);
  numbers["near_cuts_elements"] = 10;
  numbers["near_cuts_min_dihedral_deg"] = 13;
  numbers["near_cuts_smallest_height"] = 0.0625;
  numbers["away_from_cuts_min_dihedral_deg"] = 14;
  numbers["away_from_cuts_smallest_height"] = 0.125;
  for (const auto& [name, bytes, expected] :
       {std::tuple{"mesh", 30e6, 90e6}, {"write", 50e6, 60e6}}) {
    const std::string task = std::string("task_") + name;
    numbers[task + "_count"] = 2;
    numbers[task + "_bytes"] = bytes;
    numbers[task + "_expected_bytes"] = expected;
  }
  numbers["balance_estimated"] = 1.25;
  numbers["balance_elements"] = 1.5;
  numbers["assimilated_groups"] = 4;
  numbers["assimilated_leaves"] = 9;
  numbers["assimilated_faces_max"] = 30;
  numbers["assimilated_faces_mean"] = 20;
  numbers["assimilated_communication_nodes_max"] = 77;
  auto& texts = *status.mutable_texts();
  texts["region_1_name"] = "fluid";
  numbers["region_1_elements"] = 1'000'000;
  numbers["region_1_min_dihedral_deg"] = 12.5;
  texts["region_2_name"] = "solid";
  numbers["region_2_elements"] = 234'567;
  numbers["region_2_min_dihedral_deg"] = 16;
  return status;
}

TEST(JobText, of_a_result_is_all_that_a_person_should_know) {
  EXPECT_EQ(
      result_text(status_of_everything(), 72, {"out/wing.vtkhdf", "out/wing.su2"}),
      "done       1.2M tets, 23.5k nodes, 8 sub-domains, dihedral 12.50 to 160.25 deg, mean radius "
      "ratio 0.812   01:12\n"
      "           worst 12.50 deg at (1, 2.5, -3); the surface allows at most 15.00 deg, at (4, 5, "
      "6)\n"
      "           where the surface forces no small angles: smallest dihedral 18.00 deg, at (7, 8, "
      "9)\n"
      "           near the cuts: smallest dihedral 13.00 deg, smallest height 0.0625; elsewhere: "
      "14.00 deg, 0.125\n"
      "           fluid: 1.0M tets, smallest dihedral 12.50 deg\n"
      "           solid: 234.6k tets, smallest dihedral 16.00 deg\n"
      "           memory of a task: at most 50 MB; expected limit 90 MB\n"
      "           largest/mean: 1.250 of estimated elements, 1.500 of elements, 1.500 of faces; 9 "
      "leaves in 4 groups, at most 77 communication nodes\n"
      "           out/wing.vtkhdf\n"
      "           out/wing.su2\n");
}

TEST(JobText, leaves_out_of_a_result_what_explains_nothing) {
  wire::JobStatus status = status_of_angles(19.99, 150);
  auto& numbers = *status.mutable_numbers();
  numbers["forced_dihedral_deg"] = 20;
  numbers["unforced_elements"] = 5;
  numbers["unforced_min_dihedral_deg"] = 19.99;
  const std::string text = result_text(status, 1, {});
  EXPECT_THAT(text, HasSubstr("worst 19.99 deg at (0, 0, 0)\n"));
  EXPECT_THAT(text, Not(HasSubstr("allows at most")));
  EXPECT_THAT(text, Not(HasSubstr("forces no small angles")));
  EXPECT_THAT(text, Not(HasSubstr("near the cuts")));
  EXPECT_THAT(text, Not(HasSubstr("largest/mean"))) << "there is one sub-domain";
  numbers["min_dihedral_deg"] = 20;
  EXPECT_THAT(result_text(status, 1, {}), Not(HasSubstr("worst")));
}

TEST(JobText, angles_are_bad_within_a_degree_of_flat) {
  const std::string red = "\033[31m";
  EXPECT_THAT(result_text(status_of_angles(1, 179), 1, {}, true), Not(HasSubstr(red)));
  EXPECT_THAT(result_text(status_of_angles(0.99, 150), 1, {}, true), HasSubstr(red));
  EXPECT_THAT(result_text(status_of_angles(12, 179.01), 1, {}, true), HasSubstr(red));
}

TEST(JobText, of_five_subdomains_names_all) {
  wire::JobStatus status;
  for (int heap = 8; heap < 13; ++heap) {
    (*status.mutable_texts())["uncut:" + std::to_string(heap)] = "too few elements";
  }
  EXPECT_THAT(result_text(status, 1, {}), Not(HasSubstr("more (--json lists all)")));
  (*status.mutable_texts())["uncut:13"] = "too few elements";
  EXPECT_THAT(result_text(status, 1, {}), HasSubstr("and 1 more (--json lists all)\n"));
}

TEST(JobText, of_a_farm_is_its_state_and_that_of_each_job) {
  wire::StatusReply reply;
  reply.set_workers(2);
  reply.set_dropped_messages(3);
  reply.set_trouble("the disk is full");
  reply.set_security("insecure");
  wire::JobStatus& running = *reply.add_jobs();
  running.set_job("job-1");
  running.set_name("wing");
  running.set_state("running");
  running.set_stage("mesh");
  running.set_leaves_made(8);
  running.set_leaves_meshed(5);
  running.set_estimated_elements(2e6);
  (*running.mutable_numbers())["forecast_seconds"] = 12;
  (*running.mutable_numbers())["forecast_bytes"] = 1e8;
  (*running.mutable_numbers())["forecast_disk_bytes"] = 2e8;
  (*running.mutable_numbers())["balance_estimated"] = 1.25;
  wire::RunningTask& task = *running.add_running();
  task.set_task(11);
  task.set_kind("mesh");
  task.set_path(5);
  task.set_seconds(72);
  *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  wire::TaskInQuarantine& bad = *running.add_quarantine();
  bad.set_task(7);
  bad.set_kind("inspect");
  bad.set_reason("crashed");
  wire::JobStatus& failed = *reply.add_jobs();
  failed.set_job("job-22");
  failed.set_name("duct");
  failed.set_state("failed");
  failed.set_stage("inspect");
  failed.set_message("open edge");
  failed.set_leaves_made(1);
  (*failed.mutable_numbers())["forecast_seconds"] = 12;
  *failed.add_quarantine() = bad;
  wire::HostInQuarantine& host = *reply.add_hosts();
  host.set_host("node5");
  host.set_reason("3 tasks crashed");
  EXPECT_EQ(status_text(reply),
            "2 workers, 2 jobs, messages and handshakes refused: 3\n"
            "the disk is full\n"
            "INSECURE: anyone who can reach this coordinator may submit and cancel jobs and hand "
            "in results\n"
            "job-1    wing                 running    mesh       5/8 sub-domains\n"
            "         expected: about 2.0 M elements, 100 MB of memory per task, 200 MB of disk, "
            "12 s on one core\n"
            "         largest/mean: 1.250 of estimated elements\n"
            "         task 11, mesh LR, 01:12: recovery pass 3: 312 of 1,204 edges\n"
            "         in quarantine: task 7, inspect: crashed\n"
            "job-22   duct                 failed     inspect    0/1 sub-domains\n"
            "         open edge\n"
            "host in quarantine: node5: 3 tasks crashed (tetfarm retry --host node5)\n");
}

TEST(JobText, of_workers_is_a_line_for_each) {
  wire::StatusReply reply;
  wire::WorkerStatus& idle = *reply.add_at_work();
  idle.set_worker(3);
  idle.set_host("node1");
  idle.set_process(471);
  idle.set_memory_bytes((std::uint64_t{2} << 30U) + 5);
  wire::WorkerStatus& busy = *reply.add_at_work();
  busy.set_worker(1234567);
  busy.set_host("node2");
  busy.set_process(9);
  busy.set_tag("night/12_3");
  busy.set_task(31);
  busy.set_drains(true);
  EXPECT_EQ(workers_text(reply),
            "worker-3      node1 process 471, 2048 MiB\n"
            "worker-1234567 node2 process 9, 0 MiB (night/12_3), task 31, draining\n");
}

}  // namespace
}  // namespace tetfarm
