// What `plan` says, called as main calls it: figures that follow from one another.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/progress_display.h"
#include "cli/seen_times.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

constexpr const char* cube_off =
    "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
    "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
    "3 3 0 4\n3 3 4 7\n";

class PlanOfACube : public ::testing::Test {
 protected:
  PlanOfACube() {
    write_file_atomically(folder_.path() / "cube.off", cube_off);
    command_.job.input = (folder_.path() / "cube.off").string();
    command_.job.size = 0.2;
    command_.job.subdomains = 4;
    command_.job.output = folder_.path().string();
  }
  Json json() {
    command_.job.json = true;
    const Said said = said_by([&] { return plan_command(command_); });
    command_.job.json = false;
    EXPECT_EQ(said.error, "");
    return Json::parse(said.out);
  }
  std::string text() {
    const Said said = said_by([&] { return plan_command(command_); });
    EXPECT_EQ(said.err, "");
    return said.out;
  }
  std::map<std::string, int> counts() {
    std::map<std::string, int> counts;
    const Json plan = json();
    for (const auto& [kind, task] : plan["tasks"].items()) counts[kind] = task["count"];
    return counts;
  }

  const TempFolder folder_;
  PlanCommand command_;
};

TEST_F(PlanOfACube, counts_the_tasks_of_each_kind) {
  using Counts = std::map<std::string, int>;
  EXPECT_EQ(counts(), (Counts{{"inspect", 1},
                              {"decompose", 3},
                              {"mesh", 4},
                              {"order", 1},
                              {"extract", 4},
                              {"cosmetic", 4},
                              {"number", 1},
                              {"write", 4},
                              {"assemble", 1}}));
  command_.job.groups = 2;
  EXPECT_EQ(counts(), (Counts{{"inspect", 1},
                              {"decompose", 3},
                              {"assimilate", 1},
                              {"mesh", 2},
                              {"order", 1},
                              {"extract", 2},
                              {"cosmetic", 2},
                              {"number", 1},
                              {"write", 2},
                              {"assemble", 1}}));
  command_.job.groups.reset();
  command_.job.subdomains = 1;
  EXPECT_EQ(counts(),
            (Counts{{"inspect", 1}, {"mesh", 1}, {"number", 1}, {"write", 1}, {"assemble", 1}}));
}

TEST_F(PlanOfACube, has_no_turns_where_the_job_wants_none) {
  write_file_atomically(folder_.path() / "job.toml",
                        "[geometry]\nsurface = \"cube.off\"\n[cosmetics]\nacross_cuts = false\n");
  command_.job.input = (folder_.path() / "job.toml").string();
  const auto of_kinds = counts();
  EXPECT_FALSE(of_kinds.contains("order"));
  EXPECT_FALSE(of_kinds.contains("cosmetic"));
  EXPECT_EQ(of_kinds.at("mesh"), 4);
}

TEST_F(PlanOfACube, has_the_memory_of_the_largest_task_of_a_kind) {
  command_.job.subdomains = 5;
  const Json plan = json();
  double largest = 0;
  double last = 0;
  for (const Json& node : plan["subdomains"]) {
    if (node["parts"] != 1) continue;
    last = node["bytes"];
    largest = std::max(largest, last);
  }
  EXPECT_LT(last, largest) << "or this says nothing";
  EXPECT_EQ(plan["tasks"]["mesh"]["bytes"], largest);
}

TEST_F(PlanOfACube, tells_programs_what_the_job_and_each_sub_domain_come_to) {
  const Json plan = json();
  EXPECT_EQ(plan["type"], "plan");
  EXPECT_EQ(plan["name"], "cube");
  EXPECT_EQ(plan["needles"], 0);
  EXPECT_EQ(plan["groups"], 0);
  EXPECT_EQ(plan["max_memory_bytes"], 0);
  EXPECT_EQ(plan["learnt_from_tasks"], 0);
  ASSERT_EQ(plan["subdomains"].size(), 7U);
  const Json& root = plan["subdomains"][0];
  EXPECT_EQ(root["path"], "root");
  EXPECT_EQ(root["parts"], 4);
  EXPECT_EQ(root["elements"], plan["estimated_elements"]);
  EXPECT_EQ(root["triangles"], plan["surface_triangles"]);
  double of_leaves = 0;
  double largest_mesh = 0;
  double of_meshes = 0;
  for (const Json& node : plan["subdomains"]) {
    EXPECT_LE(node["seconds_low"], node["seconds"]);
    EXPECT_GE(node["seconds_high"], node["seconds"]);
    if (node["parts"] != 1) continue;
    of_leaves += node["elements"].get<double>();
    of_meshes += node["seconds"].get<double>();
    largest_mesh = std::max(largest_mesh, node["bytes"].get<double>());
  }
  EXPECT_NEAR(of_leaves, plan["estimated_elements"].get<double>(), 1e-6 * of_leaves);
  EXPECT_EQ(plan["tasks"]["mesh"]["bytes"], largest_mesh);
  EXPECT_NEAR(plan["tasks"]["mesh"]["seconds"].get<double>(), of_meshes, 1e-9);
  double sum = 0;
  for (const auto& [kind, task] : plan["tasks"].items()) {
    sum += task["seconds"].get<double>();
    EXPECT_GT(task["bytes"], 0) << kind;
  }
  EXPECT_NEAR(plan["seconds"].get<double>(), sum, 1e-9);
}

/// A line of the tree, as it should be.
std::string line_of(const Json& node, const char* leaf_task) {
  const std::string path = node["path"];
  const std::size_t depth = path == "root" ? 0 : path.size();
  char line[200];
  std::snprintf(line, sizeof line, "%-32s %-10s %10s %10s %9.0f %8.2f\n",
                (std::string(depth, ' ') + path).c_str(),
                node["parts"] == 1 ? leaf_task : "decompose", short_count(node["elements"]).c_str(),
                short_count(node["triangles"]).c_str(), node["bytes"].get<double>() / 1e6,
                node["seconds"].get<double>());
  return line;
}

/// The page that people should see of a plan that programs see so.
std::string page_of(const Json& plan, const char* leaf_task) {
  std::string page =
      "sub-domain                       task         elements  triangles        MB  seconds\n";
  for (const Json& node : plan["subdomains"]) page += line_of(node, leaf_task);
  page += "\ntasks          number      MB, at most      seconds   range\n";
  for (const auto& [kind, task] : plan["tasks"].items()) {
    char line[200];
    std::snprintf(line, sizeof line, "%-12s %8d %16.0f %12.2f   %s\n", kind.c_str(),
                  task["count"].get<int>(), task["bytes"].get<double>() / 1e6,
                  task["seconds"].get<double>(),
                  range_text(task["seconds_low"], task["seconds_high"]).c_str());
    page += line;
  }
  return page;
}

TEST_F(PlanOfACube, shows_people_the_same_as_programs) {
  EXPECT_THAT(text(), StartsWith(page_of(json(), "mesh") + "\nabout "));
  command_.job.groups = 2;
  EXPECT_THAT(text(), StartsWith(page_of(json(), "assimilate") + "\nabout "));
}

TEST_F(PlanOfACube, ends_with_its_range_and_where_the_times_come_from) {
  const Json plan = json();
  const std::string page = text();
  EXPECT_THAT(page, HasSubstr("\n" + range_text(plan["seconds_low"], plan["seconds_high"]) +
                              " on one core, most likely " +
                              range_text(plan["seconds"], plan["seconds"]) + "\n"));
  EXPECT_THAT(page,
              ::testing::EndsWith(
                  "the times were measured with other surfaces on another machine; --store "
                  "DIR takes them from the tasks of a store or the output folder of a run\n"));
  EXPECT_THAT(page, Not(HasSubstr("have an angle below")));
}

TEST_F(PlanOfACube, tells_what_layers_come_to) {
  EXPECT_THAT(text(), Not(HasSubstr("layers")));
  EXPECT_FALSE(json().contains("layers"));
  command_.job.layers = {"*:first=0.01,growth=1.5,count=3"};
  EXPECT_THAT(text(), HasSubstr("\nlayers on \"surface\": 3 layers, 0.01 to 0.0225 high, 0.0475 "
                                "together; median edge 1, isotropic from layer 12\n"));
  EXPECT_EQ(json()["layers"][0]["layers"], 3);
}

TEST_F(PlanOfACube, of_a_surface_that_cannot_be_meshed_is_none) {
  std::string open = cube_off;
  open.replace(open.find("8 12 0"), 6, "8 11 0");
  open.erase(open.find("3 3 4 7\n"));
  write_file_atomically(command_.job.input, open);
  const Said said = said_by([&] { return plan_command(command_); });
  EXPECT_EQ(said.code, ExitCode::bad_geometry);
  EXPECT_THAT(said.error, StartsWith(command_.job.input + ": the surface cannot be meshed"));
}

TEST_F(PlanOfACube, is_within_a_limit_of_memory) {
  command_.job.subdomains.reset();
  command_.job.size = 0.02;
  command_.job.max_memory = "100MB";
  const Json plan = json();
  EXPECT_EQ(plan["max_memory_bytes"], 100'000'000);
  EXPECT_GT(plan["subdomains"].size(), 1U);
  EXPECT_LE(plan["tasks"]["mesh"]["bytes"], 100e6);
}

TEST_F(PlanOfACube, warns_of_a_disk_that_is_too_small_for_it) {
  EXPECT_EQ(said_by([&] { return plan_command(command_); }).err, "");
  command_.job.subdomains = 1;
  command_.job.force = true;
  command_.job.size = 0.0005;
  const Said said = said_by([&] { return plan_command(command_); });
  EXPECT_EQ(said.error, "");
  EXPECT_THAT(said.err, StartsWith("warning: the disk here has only "));
  EXPECT_THAT(said.err, ::testing::EndsWith(" MiB free\n"));
}

TEST_F(PlanOfACube, for_a_frequency_tells_the_size_and_is_that_of_the_size) {
  const Json by_size = json();
  command_.job.size.reset();
  command_.job.wave.frequency = "2";
  command_.job.wave.speed = 4;
  const Json by_wave = json();
  EXPECT_EQ(by_wave["estimated_elements"], by_size["estimated_elements"]);
  EXPECT_EQ(by_wave["subdomains"], by_size["subdomains"]);
  EXPECT_EQ(by_wave["size"], 0.2);
  EXPECT_EQ(by_wave["wavelength"], 2);
  EXPECT_FALSE(by_size.contains("size"));
  EXPECT_THAT(text(), HasSubstr("\nsize 0.2 (10 to a wavelength of 2)\nthe surface has edges of "
                                "up to 1.41421, longer than the 0.2 that the frequency allows"));
}

}  // namespace
}  // namespace tetfarm
