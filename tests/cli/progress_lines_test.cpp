#include "cli/progress_lines.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/transfer_display.h"
#include "tests/cli/said.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* sound_tet =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

wire::JobStatus meshing(double share) {
  wire::JobStatus status;
  status.set_job("job-7");
  status.set_state("running");
  status.set_stage("mesh");
  status.set_leaves_made(8);
  status.set_estimated_elements(1e6);
  status.set_elements_under_way(share * 1e6);
  return status;
}

TEST(ProgressLines, come_at_a_new_stage_at_once_and_else_once_a_second_at_most) {
  ProgressLines lines;
  wire::JobStatus status = meshing(0);
  EXPECT_NE(lines.due(status, 1, 10'000, 1), "");
  EXPECT_EQ(lines.due(meshing(0.1), 1, 10'999, 1), "");
  EXPECT_NE(lines.due(meshing(0.1), 1, 11'000, 1), "");
  status = meshing(0.1);
  status.set_stage("order");
  EXPECT_NE(lines.due(status, 1, 11'010, 1), "");
}

TEST(ProgressLines, come_every_five_seconds_where_nothing_changes) {
  ProgressLines lines;
  EXPECT_NE(lines.due(meshing(0.1), 1, 10'000, 1), "");
  EXPECT_EQ(lines.due(meshing(0.1), 1, 14'999, 1), "");
  EXPECT_NE(lines.due(meshing(0.1), 1, 15'000, 1), "");
  EXPECT_EQ(lines.due(meshing(0.1), 1, 16'500, 1), "");
  EXPECT_NE(lines.due(meshing(0.1), 2, 16'600, 1), "") << "a worker has come";
}

TEST(ProgressLines, tell_shares_that_never_fall_and_a_time_left_once_there_is_a_rate) {
  ProgressLines lines;
  const json first = json::parse(lines.due(meshing(0.2), 1, 10'000, 77));
  EXPECT_TRUE(first["eta_seconds"].is_null());
  EXPECT_EQ(first["time_ms"], 77);
  const json second = json::parse(lines.due(meshing(0.4), 3, 12'000, 78));
  EXPECT_NEAR(second["eta_seconds"].get<double>(), 6, 1e-6);
  EXPECT_EQ(second["workers"], 3);
  EXPECT_GT(second["share"], first["share"]);
  wire::JobStatus back = meshing(0.1);
  back.set_stage("decompose");
  const json third = json::parse(lines.due(back, 3, 13'000, 79));
  EXPECT_EQ(third["share"], second["share"]) << "a leaf is cut once more";
}

TEST(ProgressLines, are_asked_for_in_either_way_of_giving_a_value) {
  const auto asks = [](std::vector<const char*> words) {
    return asks_for_json_progress(static_cast<int>(words.size()), words.data());
  };
  EXPECT_TRUE(asks({"tetfarm", "run", "--progress", "json", "wing.stl"}));
  EXPECT_TRUE(asks({"tetfarm", "run", "wing.stl", "--progress=json"}));
  EXPECT_FALSE(asks({"tetfarm", "run", "wing.stl", "--json", "--progress", "text"}));
  EXPECT_FALSE(asks({"tetfarm", "run", "json", "--progress"}));
}

TEST(ProgressLines, of_a_transfer_tell_its_bytes) {
  const Said said = said_by([] {
    TransferDisplay display(ProgressStyle::json);
    display.show("fetching wing.vtkhdf", 5, 10);
    std::this_thread::sleep_for(std::chrono::milliseconds(1'010));
    display.show("fetching wing.vtkhdf", 6, 10);
    return ExitCode::ok;
  });
  const json line = json::parse(said.err);
  EXPECT_EQ(line["what"], "fetching wing.vtkhdf");
  EXPECT_EQ(line["there_bytes"], 6);
}

/// The lines of standard error, each of which has to be an object with type, version and time.
std::vector<json> objects_of(const Ended& ended) {
  std::vector<json> objects;
  std::istringstream lines(ended.err);
  for (std::string line; std::getline(lines, line);) {
    const json object = json::parse(line, nullptr, false);
    EXPECT_TRUE(object.is_object()) << line;
    if (!object.is_object()) continue;
    EXPECT_EQ(object["version"], 1) << line;
    EXPECT_TRUE(object["type"].is_string() && object["time_ms"].is_number()) << line;
    objects.push_back(object);
  }
  return objects;
}

/// Looks at a run that is to be told in lines of JSON.
class JsonProgress : public ::testing::Test {
 protected:
  std::vector<json> told_by(std::vector<std::string> words, int code) {
    words.insert(words.end(), {"--progress", "json"});
    ended_ = run_program(words, folder_.path());
    EXPECT_EQ(ended_.code, code) << ended_.err;
    std::vector<json> objects = objects_of(ended_);
    if (objects.empty()) objects.push_back(json{{"type", "nothing was said"}});
    EXPECT_EQ(objects.back()["type"], "end") << ended_.err;
    EXPECT_EQ(objects.back()["exit_code"], code);
    return objects;
  }

  TemporaryFolder folder_;
  Ended ended_;
};

TEST_F(JsonProgress, of_a_run_has_nothing_but_objects_shares_that_rise_and_the_end_with_files) {
  ASSERT_EQ(
      run_program({"shape", "duct", "-o", "duct.stl", "--spacing", "0.2"}, folder_.path()).code, 0);
  const std::vector<json> told = told_by({"run", "duct.stl", "-o", "out", "-j", "5000"}, 2);
  EXPECT_THAT(told.back()["message"].get<std::string>(), HasSubstr("4096"));
  const std::vector<json> objects =
      told_by({"run", "duct.stl", "-o", "out", "-j", "64", "--subdomains", "3", "--size", "0.05",
               "--json", "--format", "vtkhdf,su2"},
              0);
  double share = 0;
  int count = 0;
  for (const json& object : objects) {
    if (object["type"] != "progress") continue;
    ++count;
    EXPECT_GE(object["share"], share);
    share = object["share"];
    EXPECT_LE(object["tasks"]["done"], object["tasks"]["total"]);
    EXPECT_EQ(object["job"], objects.back()["job"]);
  }
  EXPECT_GE(count, 2) << ended_.err;
  EXPECT_GT(share, 0);
  EXPECT_EQ(objects.back()["state"], "done");
  const json files = objects.back()["files"];
  ASSERT_EQ(files.size(), 2U) << files;
  for (const json& file : files) {
    EXPECT_TRUE(std::filesystem::exists(file.get<std::string>())) << file;
  }
  EXPECT_EQ(json::parse(ended_.out)["files"], files) << "the result is told where it always is";
  EXPECT_THAT(ended_.err, HasSubstr("extra workers")) << "notes are messages";
}

TEST_F(JsonProgress, of_a_run_that_fails_ends_with_what_was_wrong) {
  write_contents(folder_.path() / "open.off",
                 "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n");
  const json end = told_by({"run", "open.off", "-o", "out", "-j", "1"}, 3).back();
  EXPECT_EQ(end["state"], "failed");
  EXPECT_THAT(end["message"].get<std::string>(), HasSubstr("open edge"));
  EXPECT_THAT(end["help"].get<std::string>(), HasSubstr("repair"));
  const json missing = told_by({"run", "nowhere.stl"}, 5).back();
  EXPECT_THAT(missing["message"].get<std::string>(), HasSubstr("nowhere.stl"));
  const json unknown = told_by({"run", "nowhere.stl", "--sise", "3"}, 2).back();
  EXPECT_THAT(unknown["message"].get<std::string>(), HasSubstr("unknown option `--sise`"));
}

TEST_F(JsonProgress, is_never_there_with_the_other_words) {
  write_contents(folder_.path() / "tet.off", sound_tet);
  for (const char* style : {"text", "auto", "plain", "none"}) {
    const Ended ended = run_program({"run", "tet.off", "-o", "out", "-j", "1", "--progress", style},
                                    folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.err, Not(HasSubstr("{"))) << style;
  }
}

}  // namespace
}  // namespace tetfarm
