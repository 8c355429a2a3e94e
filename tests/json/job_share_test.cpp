#include "json/job_share.h"

#include <gtest/gtest.h>

#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

wire::JobStatus job_at(const std::string& stage) {
  wire::JobStatus status;
  status.set_state("running");
  status.set_stage(stage);
  return status;
}

TEST(JobShare, is_nothing_at_the_beginning_and_all_only_of_a_job_that_is_done) {
  EXPECT_EQ(share_of_job(job_at(""), 0), 0);
  EXPECT_EQ(share_of_job(job_at("inspect"), 0), 0);
  EXPECT_LT(share_of_job(job_at("assemble"), 1), 1);
  wire::JobStatus done = job_at("assemble");
  done.set_state("done");
  EXPECT_EQ(share_of_job(done, 1), 1);
}

TEST(JobShare, rises_from_kind_to_kind_of_task) {
  double before = -1;
  for (const TaskKind kind : all_task_kinds) {
    if (kind <= TaskKind::collect || kind == TaskKind::remesh) continue;
    const double share = share_of_job(job_at(name_of(kind)), 0);
    EXPECT_GE(share, before) << name_of(kind);
    before = share;
  }
  EXPECT_GT(before, 0.9);
}

TEST(JobShare, counts_what_is_done_of_a_part) {
  wire::JobStatus status = job_at("decompose");
  (*status.mutable_numbers())["parts"] = 8;
  const double begun = share_of_job(status, 0);
  status.set_leaves_made(4);
  EXPECT_NEAR(share_of_job(status, 0) - begun, 0.07, 1e-9) << "half of the cuts";
  status = job_at("mesh");
  status.set_leaves_made(8);
  EXPECT_NEAR(share_of_job(status, 0.5) - share_of_job(status, 0), 0.225, 1e-9);
  status.set_stage("cosmetic");
  const double meshed = share_of_job(status, 1);
  status.set_leaves_mended(2);
  EXPECT_NEAR(share_of_job(status, 1) - meshed, 0.03, 1e-9);
  status.set_stage("write");
  const double improved = share_of_job(status, 1);
  (*status.mutable_numbers())["task_write_count"] = 8;
  EXPECT_NEAR(share_of_job(status, 1) - improved, 0.2, 1e-9);
}

TEST(JobShare, counts_sub_domains_of_other_parts_that_are_done_before) {
  wire::JobStatus status = job_at("mesh");
  status.set_leaves_made(8);
  const double before = share_of_job(status, 0.5);
  status.set_leaves_mended(4);
  EXPECT_GT(share_of_job(status, 0.5), before) << "there are no rounds";
}

TEST(JobShare, of_a_loop_counts_its_tasks) {
  wire::JobStatus status = job_at("solve");
  EXPECT_EQ(share_of_job(status, 0), 0) << "nothing is known of its cycles";
  (*status.mutable_numbers())["cycles"] = 5;
  status.set_tasks_done(4);
  EXPECT_DOUBLE_EQ(share_of_job(status, 0), 0.4);
  status.set_stage("collect");
  status.set_tasks_done(9);
  EXPECT_DOUBLE_EQ(share_of_job(status, 0), 0.9);
}

}  // namespace
}  // namespace tetfarm
