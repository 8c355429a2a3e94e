#include "cli/job_text.h"

#include <gmock/gmock.h>

#include <algorithm>

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

}  // namespace
}  // namespace tetfarm
