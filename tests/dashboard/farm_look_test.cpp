#include "dashboard/farm_look.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/dashboard/fake_farm.h"

namespace tetfarm {
namespace {

using ::testing::SizeIs;

FarmSnapshot look_of(FakeFarm& farm, const FarmSnapshot& before = {}, std::int64_t at_ms = 0) {
  FarmLook look;
  return look.look(farm, before, {at_ms, at_ms});
}

TEST(FarmLook, shows_the_newest_jobs_first_with_their_shares) {
  FakeFarm farm;
  farm.rows_of_page = 2;
  for (int i = 1; i <= 3; ++i) farm.add_job(i, "done");
  const FarmSnapshot snapshot = look_of(farm);
  ASSERT_THAT(snapshot.jobs, SizeIs(3));
  EXPECT_EQ(snapshot.jobs[0].number, 3U);
  const auto newest = nlohmann::json::parse(snapshot.jobs[0].json);
  EXPECT_EQ(newest["job"], "job-3");
  EXPECT_EQ(newest["share"], 1.0);
  EXPECT_EQ(nlohmann::json::parse(snapshot.farm)["jobs"], 3);
  EXPECT_TRUE(snapshot.connected && snapshot.has_seen && !snapshot.at_rest);
}

TEST(FarmLook, of_a_thousand_jobs_and_one_leaves_the_oldest_out_and_counts_it) {
  FakeFarm farm;
  for (int i = 1; i <= 1001; ++i) farm.add_job(i, "done");
  const FarmSnapshot snapshot = look_of(farm);
  EXPECT_THAT(snapshot.jobs, SizeIs(1000));
  EXPECT_EQ(snapshot.jobs.back().number, 2U);
  EXPECT_EQ(nlohmann::json::parse(snapshot.farm)["jobs"], 1001);
}

TEST(FarmLook, asks_for_all_of_the_newest_sixteen_jobs_that_run_and_of_no_others) {
  FakeFarm farm;
  for (int i = 1; i <= 30; ++i) farm.add_job(i, i % 2 == 0 ? "running" : "done");
  for (int i = 31; i <= 40; ++i) farm.add_job(i, "running");
  const FarmSnapshot snapshot = look_of(farm);
  EXPECT_EQ(farm.times("job"), 16);
  EXPECT_TRUE(snapshot.running_jobs.contains("job-40"));
  EXPECT_FALSE(snapshot.running_jobs.contains("job-2"));
}

TEST(FarmLook, asks_for_new_events_only_and_keeps_the_others) {
  FakeFarm farm;
  for (std::uint64_t i = 1; i <= 5; ++i) farm.add_event(i);
  FarmSnapshot snapshot = look_of(farm);
  EXPECT_THAT(snapshot.events, SizeIs(5));
  farm.add_event(6);
  snapshot = look_of(farm, snapshot);
  ASSERT_THAT(snapshot.events, SizeIs(6));
  EXPECT_EQ(snapshot.events.back().number, 6U);
}

TEST(FarmLook, of_very_many_new_events_keeps_the_newest_thousand) {
  FakeFarm farm;
  farm.add_event(1);
  const FarmSnapshot before = look_of(farm);
  for (std::uint64_t i = 2; i <= 5000; ++i) farm.add_event(i);
  const FarmSnapshot snapshot = look_of(farm, before);
  EXPECT_THAT(snapshot.events, SizeIs(1000));
  EXPECT_EQ(snapshot.events.front().number, 4001U);
  EXPECT_EQ(snapshot.events.back().number, 5000U);
  EXPECT_EQ(farm.times("EVENTS"), 3);
}

TEST(FarmLook, a_job_that_is_done_is_told_of_with_its_figures_and_files) {
  FakeFarm farm;
  farm.add_job(4, "done");
  wire::JobStatus& status = farm.jobs[0];
  (*status.mutable_numbers())["min_dihedral_deg"] = 20.5;
  wire::Artifact& file = *status.add_files();
  file.set_name("wing.vtkhdf");
  file.set_size(77);
  wire::StatusReply reply;
  *reply.add_jobs() = status;
  const auto job = nlohmann::json::parse(FarmLook().job_body(reply, {1, 1}));
  EXPECT_EQ(job["result"]["min_dihedral_deg"], 20.5);
  EXPECT_FALSE(job["result"].contains("files"));
  EXPECT_EQ(job["files"], nlohmann::json::parse(R"([{"name":"wing.vtkhdf","size":77}])"));
  reply.mutable_jobs(0)->set_state("failed");
  const auto failed = nlohmann::json::parse(FarmLook().job_body(reply, {1, 1}));
  EXPECT_FALSE(failed.contains("result"));
  EXPECT_EQ(failed["files"].size(), 1) << "what shows why";
}

TEST(FarmLook, a_job_is_told_of_with_progress_in_one_object) {
  FakeFarm farm;
  farm.add_job(4, "running");
  farm.jobs[0].set_tasks_done(3);
  farm.jobs[0].set_tasks_running(1);
  const FarmSnapshot snapshot = look_of(farm);
  const auto job = nlohmann::json::parse(snapshot.running_jobs.at("job-4"));
  EXPECT_EQ(job["type"], "job");
  EXPECT_EQ(job["tasks"]["total"], 4);
  for (const char* key : {"share", "eta_seconds", "balance", "running", "quarantine"}) {
    EXPECT_TRUE(job.contains(key)) << key;
  }
}

TEST(FarmLook, at_rest_no_coordinator_is_connected) {
  FakeFarm farm;
  farm.rests = true;
  const FarmSnapshot snapshot = look_of(farm);
  EXPECT_TRUE(snapshot.at_rest);
  EXPECT_FALSE(snapshot.connected);
  EXPECT_EQ(snapshot.trouble, "");
}

TEST(FarmLook, what_was_seen_stays_when_nobody_answers) {
  FakeFarm farm;
  farm.add_job(1, "done");
  const FarmSnapshot before = look_of(farm, {}, 500);
  const FarmSnapshot snapshot = snapshot_without_answer(before, "no coordinator answers");
  EXPECT_FALSE(snapshot.connected);
  EXPECT_EQ(snapshot.trouble, "no coordinator answers");
  EXPECT_THAT(snapshot.jobs, SizeIs(1));
  EXPECT_EQ(snapshot.time_ms, 500);
}

TEST(FarmLook, takes_at_most_a_tenth_of_the_time) {
  EXPECT_EQ(rest_after_look_ms(0), 1'000);
  EXPECT_EQ(rest_after_look_ms(500), 5'000);
  EXPECT_EQ(rest_after_look_ms(1'000'000), 60'000);
}

}  // namespace
}  // namespace tetfarm
