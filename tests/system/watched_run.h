/// A run that is looked at while it works: what `status` and `explain` tell of its tasks.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "tests/system/farm_cases.h"

namespace tetfarm::test {

/// What was seen of tasks that run.
class WatchedTasks {
 public:
  /// Looks until the run has ended, or a task of that kind was seen in that stage.
  void watch(Program& run, const std::filesystem::path& folder, const std::string& output,
             const std::string& kind = "", const std::string& last_stage = "") {
    while (run.is_running() && !stages(kind).contains(last_stage)) {
      look(folder, output);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  /// Names of the stages of tasks of a kind.
  std::set<std::string> stages(const std::string& kind) const {
    const auto found = kind2stages_.find(kind);
    return found == kind2stages_.end() ? std::set<std::string>() : found->second;
  }
  /// How often counts of an attempt's stage were seen to have risen.
  int steps() const { return steps_; }
  double most_under_way() const { return most_under_way_; }
  const std::string& explained() const { return explained_; }
  const std::string& text() const { return text_; }

 private:
  struct Counts {
    std::uint64_t pass = 0;
    std::uint64_t done = 0;
    std::uint64_t total = 0;
  };

  void look(const std::filesystem::path& folder, const std::string& output) {
    const Ended status = run_program({"status", "--store", output, "--json"}, folder);
    std::istringstream lines(status.out);
    for (std::string line; std::getline(lines, line);) {
      const nlohmann::json job = nlohmann::json::parse(line, nullptr, false);
      if (!job.is_object() || job["type"] != "job") continue;
      most_under_way_ = std::max(most_under_way_, job["elements_under_way"].get<double>());
      for (const nlohmann::json& task : job["running"]) note(task, folder, output);
    }
  }

  void note(const nlohmann::json& task, const std::filesystem::path& folder,
            const std::string& output) {
    const std::string stage = task["doing_stage"];
    if (stage.empty()) return;
    EXPECT_NE(task["doing"], "");
    kind2stages_[task["kind"]].insert(stage);
    double& share = attempt2share_[task["attempt"]];
    EXPECT_GE(task["share"], share);
    share = task["share"];
    Counts& before = counts_[{task["attempt"], stage}];
    const Counts now{task["doing_pass"], task["doing_done"], task["doing_total"]};
    EXPECT_GE(now.pass, before.pass) << stage;
    EXPECT_GE(now.done, before.done) << stage;
    EXPECT_GE(now.total, before.total) << stage;
    EXPECT_TRUE(now.total == 0 || now.done <= now.total) << stage;
    if (now.done > before.done) ++steps_;
    before = now;
    if (explained_.empty() && task["kind"] == "mesh") {
      const std::string number = std::to_string(task["task"].get<std::uint64_t>());
      const Ended explained = run_program({"explain", number, "--store", output}, folder);
      if (explained.out.find("doing: ") != std::string::npos) explained_ = explained.out;
      text_ = run_program({"status", "--store", output}, folder).out;
    }
  }

  std::map<std::string, std::set<std::string>> kind2stages_;
  std::map<std::uint64_t, double> attempt2share_;
  std::map<std::pair<std::uint64_t, std::string>, Counts> counts_;
  int steps_ = 0;
  double most_under_way_ = 0;
  std::string explained_;
  std::string text_;
};

}  // namespace tetfarm::test
