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

TEST(ChromeTrace, has_all_that_is_known_of_an_attempt) {
  wire::AttemptLine line = attempt(4, 9, "done", 2000, 2500);
  line.set_message("why");
  line.set_peak_rss_bytes(77);
  const json slice =
      of_phase(json::parse(chrome_trace({line}, {event(0, "ready", 1000)}, 5000)), "X").at(0);
  json expected = {{"name", "mesh"}, {"cat", "mesh"}, {"ph", "X"}, {"ts", 1'000'000},
                   {"dur", 500'000}, {"pid", 2},      {"tid", 74}};
  expected["cname"] = slice["cname"];
  expected["args"] = {{"place", "LR"},    {"task", 9},      {"attempt", 4},
                      {"result", "done"}, {"races", false}, {"peak_rss_bytes", 77},
                      {"message", "why"}};
  EXPECT_EQ(slice, expected);
}

TEST(ChromeTrace, colours_what_runs_what_failed_and_what_nobody_knows) {
  const auto colour = [](const std::string& state, const std::string& kind) {
    wire::AttemptLine line = attempt(1, 7, state, 1000, 2000);
    line.set_kind(kind);
    line.set_path(0);
    const json slice = of_phase(json::parse(chrome_trace({line}, {}, 5000)), "X").at(0);
    EXPECT_EQ(slice["args"]["place"], "");
    return slice["cname"].get<std::string>();
  };
  EXPECT_EQ(colour("running", "mesh"), "white");
  EXPECT_EQ(colour("lost", "mesh"), "terrible");
  EXPECT_EQ(colour("done", "unheard_of"), "grey");
  EXPECT_NE(colour("done", "mesh"), colour("done", "write"));
}

TEST(ChromeTrace, names_rows_after_hosts_and_workers) {
  std::vector<std::string> names;
  for (const json& row : of_phase(some_trace(), "M")) {
    names.push_back(row["name"].get<std::string>() + " " + std::to_string(row["pid"].get<int>()) +
                    " " + std::to_string(row["tid"].get<int>()) + ": " +
                    row["args"]["name"].get<std::string>());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"process_name 1 0: waiting for a worker",
                                             "process_name 2 0: host-a", "process_name 3 0: host-b",
                                             "thread_name 2 71: worker-1 (process 71)",
                                             "thread_name 3 72: worker-2 (process 72)",
                                             "thread_name 3 73: worker-3 (process 73)"}));
}

TEST(ChromeTrace, of_waiting_says_which_task_where) {
  const json begin = of_phase(some_trace(), "b").at(0);
  EXPECT_EQ(begin["name"], "mesh");
  EXPECT_EQ(begin["cat"], "waiting");
  EXPECT_EQ(begin["pid"], 1);
  EXPECT_EQ(begin["id"], 1);
  EXPECT_EQ(begin["args"], json({{"task", 7}, {"place", "LR"}}));
  // An attempt that begins the moment that its task is ready has not waited.
  const json none = json::parse(
      chrome_trace({attempt(1, 7, "done", 1000, 1300)}, {event(7, "ready", 1000)}, 4000));
  EXPECT_TRUE(of_phase(none, "b").empty());
}

}  // namespace
}  // namespace tetfarm
