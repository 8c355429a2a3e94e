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

}  // namespace
}  // namespace tetfarm
