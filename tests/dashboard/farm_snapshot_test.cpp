#include "dashboard/farm_snapshot.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FarmSnapshot seen() {
  FarmSnapshot snapshot;
  snapshot.has_seen = true;
  snapshot.connected = true;
  snapshot.endpoint = "tcp://head:5555";
  snapshot.time_ms = 1000;
  snapshot.farm = R"({"type":"farm","workers":2})";
  snapshot.jobs = {{2, R"({"job":"job-2"})"}, {1, R"({"job":"job-1"})"}};
  snapshot.workers = {R"({"worker":"worker-1"})"};
  snapshot.events = {{7, R"({"event":7})"}, {8, R"({"event":8})"}};
  return snapshot;
}

TEST(FarmSnapshot, bodies_are_json_of_all_that_was_seen) {
  const auto farm = nlohmann::json::parse(farm_body(seen()));
  EXPECT_EQ(farm["workers"], 2);
  EXPECT_EQ(farm["connected"], true);
  EXPECT_EQ(farm["time_ms"], 1000);
  EXPECT_EQ(nlohmann::json::parse(jobs_body(seen()))["jobs"][0]["job"], "job-2");
  EXPECT_EQ(nlohmann::json::parse(workers_body(seen()))["workers"].size(), 1U);
  EXPECT_EQ(events_body(seen(), 1), R"({"events":[{"event":8}]})");
  EXPECT_EQ(nlohmann::json::parse(events_body(seen(), 99))["events"].size(), 2U);
  EXPECT_EQ(jobs_body(FarmSnapshot()), R"({"jobs":[]})");
}

TEST(FarmSnapshot, tells_nothing_when_only_time_has_passed) {
  FarmSnapshot later = seen();
  later.time_ms = 2000;
  EXPECT_EQ(messages_of_changes(seen(), later, false), "");
  EXPECT_THAT(messages_of_changes(seen(), later, true), HasSubstr("event: farm\ndata: {"));
}

TEST(FarmSnapshot, tells_of_the_jobs_that_changed_and_no_others) {
  FarmSnapshot later = seen();
  later.jobs[1].json = R"({"job":"job-1","state":"done"})";
  EXPECT_EQ(messages_of_changes(seen(), later, false),
            "event: jobs\ndata: {\"jobs\":[{\"job\":\"job-1\",\"state\":\"done\"}]}\n\n");
}

TEST(FarmSnapshot, tells_of_new_events_once) {
  FarmSnapshot later = seen();
  later.events.push_back({9, R"({"event":9})"});
  EXPECT_EQ(messages_of_changes(seen(), later, false),
            "event: events\ndata: {\"events\":[{\"event\":9}]}\n\n");
  EXPECT_EQ(messages_of_changes(later, later, false), "");
}

TEST(FarmSnapshot, tells_that_nobody_answers_any_more) {
  FarmSnapshot later = seen();
  later.connected = false;
  later.trouble = "no coordinator answers";
  const std::string told = messages_of_changes(seen(), later, false);
  EXPECT_THAT(told, HasSubstr(R"("connected":false,"trouble":"no coordinator answers")"));
  EXPECT_THAT(told, Not(HasSubstr("event: jobs")));
}

TEST(FarmSnapshot, the_first_look_tells_of_all_jobs_even_of_none_and_of_no_old_events) {
  const std::string told = messages_of_changes(FarmSnapshot(), seen(), false);
  EXPECT_THAT(told, HasSubstr("job-1"));
  EXPECT_THAT(told, HasSubstr("event: farm"));
  EXPECT_THAT(told, Not(HasSubstr("event: events")));
  FarmSnapshot without_jobs = seen();
  without_jobs.jobs.clear();
  EXPECT_THAT(messages_of_changes(FarmSnapshot(), without_jobs, false),
              HasSubstr("event: jobs\ndata: {\"jobs\":[]}"));
}

TEST(FarmSnapshot, a_watcher_who_comes_is_told_of_farm_and_jobs_as_soon_as_they_are_seen) {
  EXPECT_EQ(first_messages(FarmSnapshot()), "");
  EXPECT_THAT(first_messages(seen()), HasSubstr("event: farm"));
  EXPECT_THAT(first_messages(seen()), HasSubstr("job-2"));
}

}  // namespace
}  // namespace tetfarm
