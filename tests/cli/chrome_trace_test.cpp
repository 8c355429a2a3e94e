#include "cli/chrome_trace.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tetfarm {
namespace {

using nlohmann::json;

wire::AttemptLine attempt(std::uint64_t id, std::uint64_t task, const std::string& state,
                          std::int64_t started_ms, std::int64_t ended_ms) {
  wire::AttemptLine line;
  line.set_attempt(id);
  line.set_task(task);
  line.set_kind("mesh");
  line.set_path(5);
  line.set_worker(id);
  line.set_host(id == 1 ? "host-a" : "host-b");
  line.set_process(70 + static_cast<std::int64_t>(id));
  line.set_state(state);
  line.set_started_ms(started_ms);
  line.set_ended_ms(ended_ms);
  line.set_message("not \xff UTF-8, a \"quote\"");
  return line;
}

wire::EventLine event(std::uint64_t task, const std::string& what, std::int64_t wall_ms) {
  wire::EventLine line;
  line.set_task(task);
  line.set_what(what);
  line.set_wall_ms(wall_ms);
  return line;
}

/// Those of a phase, in the order of the file.
std::vector<json> of_phase(const json& trace, const std::string& phase) {
  std::vector<json> found;
  for (const json& one : trace.at("traceEvents")) {
    if (one.at("ph") == phase) found.push_back(one);
  }
  return found;
}

/// A task that crashed on one host, was done on another, and one that runs still.
json some_trace() {
  return json::parse(
      chrome_trace({attempt(1, 7, "crashed", 1100, 1300), attempt(2, 7, "done", 2300, 2800),
                    attempt(3, 8, "running", 3000, 0)},
                   {event(7, "ready", 1000), event(7, "crashed", 1300)}, 4000));
}

TEST(ChromeTrace, has_a_slice_for_each_attempt_on_the_row_of_its_process) {
  const std::vector<json> slices = of_phase(some_trace(), "X");
  ASSERT_EQ(slices.size(), 3U);
  EXPECT_EQ(slices[0]["ts"], 100'000) << "microseconds since the first event";
  EXPECT_EQ(slices[0]["dur"], 200'000);
  EXPECT_EQ(slices[0]["name"], "mesh crashed");
  EXPECT_EQ(slices[0]["cname"], "terrible");
  EXPECT_EQ(slices[1]["name"], "mesh");
  EXPECT_EQ(slices[1]["args"]["place"], "LR");
  EXPECT_NE(slices[0]["pid"], slices[1]["pid"]) << "another host";
  EXPECT_EQ(slices[1]["pid"], slices[2]["pid"]);
  EXPECT_NE(slices[1]["tid"], slices[2]["tid"]) << "another process";
  EXPECT_EQ(slices[2]["dur"], 1'000'000) << "it runs until now";
}

TEST(ChromeTrace, names_every_row) {
  const auto row_of = [](const json& event) {
    return std::pair<int, std::int64_t>(event["pid"], event["tid"]);
  };
  std::set<std::pair<int, std::int64_t>> named;
  for (const json& name : of_phase(some_trace(), "M")) {
    if (name["name"] == "thread_name") named.insert(row_of(name));
  }
  for (const json& slice : of_phase(some_trace(), "X")) {
    EXPECT_TRUE(named.contains(row_of(slice)));
  }
}

TEST(ChromeTrace, shows_how_long_a_task_waited_for_each_of_its_attempts) {
  const json trace = some_trace();
  const std::vector<json> begins = of_phase(trace, "b");
  const std::vector<json> ends = of_phase(trace, "e");
  ASSERT_EQ(begins.size(), 2U);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(begins[0]["ts"], 0) << "from when it was ready";
  EXPECT_EQ(ends[0]["ts"], 100'000);
  EXPECT_EQ(begins[1]["ts"], 300'000) << "from the end of the attempt before";
  EXPECT_EQ(ends[1]["ts"], 1'300'000);
  EXPECT_EQ(begins[1]["id"], ends[1]["id"]);
}

TEST(ChromeTrace, a_task_wanted_again_waits_from_then_on_and_an_attempt_that_races_never) {
  for (const char* what : {"again", "retried"}) {
    wire::AttemptLine rival = attempt(3, 7, "revoked", 2400, 2500);
    rival.set_races(true);
    const json trace = json::parse(
        chrome_trace({attempt(1, 7, "done", 1100, 1300), attempt(2, 7, "done", 2300, 2800), rival},
                     {event(7, "ready", 1000), event(7, what, 2000)}, 4000));
    const std::vector<json> begins = of_phase(trace, "b");
    ASSERT_EQ(begins.size(), 2U) << what;
    EXPECT_EQ(begins[1]["ts"], 1'000'000) << what;
    EXPECT_EQ(of_phase(trace, "X")[2]["args"]["races"], true);
  }
}

TEST(ChromeTrace, of_nothing_is_a_trace_too) {
  EXPECT_TRUE(json::parse(chrome_trace({}, {}, 5)).at("traceEvents").is_array());
}

}  // namespace
}  // namespace tetfarm
