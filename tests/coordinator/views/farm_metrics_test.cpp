#include "coordinator/views/farm_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "tests/coordinator/views/farm_in_rows.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// What promtool would complain about: lines that are no samples, samples without HELP and TYPE
/// before them, families in pieces, counters without _total, buckets that fall, a missing +Inf.
class Exposition {
 public:
  explicit Exposition(const std::string& text) {
    if (text.empty() || text.back() != '\n') wrong_.emplace_back("no line end at the end");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("#")) {
        take_comment(line);
      } else {
        take_sample(line);
      }
    }
  }
  const std::vector<std::string>& wrong() const { return wrong_; }
  double value(const std::string& sample) const {
    const auto found = samples_.find(sample);
    return found == samples_.end() ? -1 : found->second;
  }

 private:
  void take_comment(const std::string& line) {
    static const std::regex type("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) (counter|gauge|histogram)");
    static const std::regex help("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) .+");
    std::smatch parts;
    if (std::regex_match(line, parts, help)) {
      helped_.insert(parts[1]);
      return;
    }
    if (!std::regex_match(line, parts, type)) return complain(line);
    family_ = parts[1];
    kind_ = parts[2];
    if (!helped_.contains(family_) || !families_.insert(family_).second) complain(line);
    if ((kind_ == "counter") != family_.ends_with("_total")) complain(line);
  }
  void take_sample(const std::string& line) {
    static const std::regex sample(
        R"re(([a-zA-Z_:][a-zA-Z0-9_:]*)(\{([a-zA-Z_][a-zA-Z0-9_]*="([^"\\\n]|\\.)*",?)*\})? (\S+))re");
    std::smatch parts;
    if (!std::regex_match(line, parts, sample)) return complain(line);
    const std::string name = parts[1];
    const bool belongs =
        kind_ == "histogram"
            ? name == family_ + "_bucket" || name == family_ + "_sum" || name == family_ + "_count"
            : name == family_;
    const double value = std::stod(parts[5]);
    const std::string key = name + parts[2].str();
    if (!belongs || !samples_.emplace(key, value).second) complain(line);
    if (!name.ends_with("_bucket")) {
      if (name.ends_with("_count") && kind_ == "histogram") {
        if (!had_infinity_ || bucket_ != value) complain(line);
        bucket_ = 0;
        had_infinity_ = false;
      }
      return;
    }
    if (value < bucket_) complain(line);
    bucket_ = value;
    had_infinity_ = key.find("le=\"+Inf\"") != std::string::npos;
  }
  void complain(const std::string& line) { wrong_.push_back(line); }

  std::vector<std::string> wrong_;
  std::set<std::string> helped_;
  std::set<std::string> families_;
  std::map<std::string, double> samples_;
  std::string family_;
  std::string kind_;
  double bucket_ = 0;
  bool had_infinity_ = false;
};

class FarmMetricsTest : public testing::Test {
 protected:
  FarmMetricsTest()
      : state_(
            {}, {}, [](const ArtifactRef&) { return true; }, now_) {}

  void work() {
    Submission submission;
    submission.name = "a \"name\"\nof two lines";
    submission.given.job = {std::string(32, 'a'), 1};
    state_.submit(submission, now_);
    WorkerInfo info;
    info.nonce = "n";
    const WorkerId worker = state_.add_worker(info, {}, {}, now_);
    state_.worker_is_ready(worker, now_);
    state_.tick(now_);
    metrics_.note(state_.take_changes(), 0.002);
    TaskResult result;
    result.outputs = {{"surface", std::string(32, 'a'), 1},
                      {"spacing", std::string(32, 'b'), 1},
                      {"root", std::string(32, 'c'), 1},
                      {"settings", std::string(32, 'd'), 1}};
    result.numbers = {{"parts", 1},   {"total_work", 0}, {"groups", 0},
                      {"needles", 0}, {"most_bytes", 0}, {"across_cuts", 0}};
    result.seconds = 2;
    state_.done(worker, TaskId{1}, AttemptId{1}, result, now_);
    metrics_.note(state_.take_changes(), 0.2);
  }
  std::string text() const { return metrics_.text(state_, refusals_, {3, 1000, 2000}); }

  Moment now_{5000, 5000};
  JobState state_;
  Refusals refusals_;
  FarmMetrics metrics_{5000};
};

TEST_F(FarmMetricsTest, are_well_formed_before_and_after_work) {
  EXPECT_THAT(Exposition(text()).wrong(), IsEmpty());
  work();
  EXPECT_THAT(Exposition(text()).wrong(), IsEmpty()) << text();
}

TEST_F(FarmMetricsTest, count_tasks_attempts_workers_and_times) {
  work();
  refusals_.count(Refusal::garbage, "x", 0);
  const Exposition figures(text());
  EXPECT_EQ(figures.value("tetfarm_tasks{kind=\"inspect\",state=\"done\"}"), 1) << text();
  EXPECT_EQ(figures.value("tetfarm_tasks{kind=\"mesh\",state=\"ready\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_queue_tasks"), 1);
  EXPECT_EQ(figures.value("tetfarm_attempts_total{result=\"done\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_workers{state=\"idle\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_task_seconds_bucket{kind=\"inspect\",le=\"1\"}"), 0);
  EXPECT_EQ(figures.value("tetfarm_task_seconds_bucket{kind=\"inspect\",le=\"5\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_task_seconds_sum{kind=\"inspect\"}"), 2);
  EXPECT_EQ(figures.value("tetfarm_commit_seconds_count"), 2);
  EXPECT_EQ(figures.value("tetfarm_commit_seconds_bucket{le=\"0.0025\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_refusals_total{reason=\"garbage\"}"), 1);
  EXPECT_EQ(figures.value("tetfarm_store_free_bytes"), 1000);
  EXPECT_EQ(figures.value("tetfarm_stuck"), 0);
}

TEST_F(FarmMetricsTest, count_no_task_of_a_job_that_is_over_as_waiting) {
  work();
  state_.cancel(JobId{1}, now_);
  const Exposition figures(text());
  EXPECT_EQ(figures.value("tetfarm_queue_tasks"), 0) << text();
  EXPECT_EQ(figures.value("tetfarm_jobs{state=\"cancelled\"}"), 1);
}

TEST(DurationHistogram, counts_what_took_at_most_so_long) {
  DurationHistogram histogram;
  for (const double seconds : {0.0, 0.001, 0.0011, 1.0, 4.0, 14400.0, 14401.0}) {
    histogram.add(seconds);
  }
  std::string expected;
  const std::vector<std::pair<const char*, int>> buckets = {
      {"0.001", 2}, {"0.0025", 3}, {"0.005", 3}, {"0.01", 3},  {"0.025", 3}, {"0.05", 3},
      {"0.1", 3},   {"0.25", 3},   {"1", 4},     {"5", 5},     {"15", 5},    {"60", 5},
      {"300", 5},   {"900", 5},    {"3600", 5},  {"14400", 6}, {"+Inf", 7}};
  for (const auto& [bound, count] : buckets) {
    expected += "x_bucket{le=\"" + std::string(bound) + "\"} " + std::to_string(count) + "\n";
  }
  EXPECT_EQ(histogram.text("x", ""), expected + "x_sum 28806.0021\nx_count 7\n");
  EXPECT_THAT(histogram.text("x", "kind=\"mesh\""),
              testing::StartsWith("x_bucket{kind=\"mesh\",le=\"0.001\"} 2\n"));
  EXPECT_THAT(histogram.text("x", "kind=\"mesh\""),
              testing::EndsWith("x_sum{kind=\"mesh\"} 28806.0021\nx_count{kind=\"mesh\"} 7\n"));
}

/// The sample lines, without heads and histograms.
std::string samples_of(const std::string& text) {
  std::string samples;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#") && line.find("_seconds") == line.npos) samples += line + "\n";
  }
  return samples;
}

class MeasuredFarm : public FarmInRows {};

TEST_F(MeasuredFarm, is_told_sample_by_sample) {
  FarmMetrics metrics(1500);
  ChangeSet changes;
  for (const AttemptState state :
       {AttemptState::running, AttemptState::done, AttemptState::failed, AttemptState::failed,
        AttemptState::crashed, AttemptState::killed, AttemptState::lost, AttemptState::returned,
        AttemptState::revoked, AttemptState::starved}) {
    AttemptRow attempt;
    attempt.state = state;
    changes.attempts.push_back(attempt);
  }
  changes.events.resize(3);
  metrics.note(changes, 0.5);
  metrics.note(ChangeSet{}, 0.5);
  metrics.note_failed_commit();
  metrics.note_failed_commit();
  Refusals refusals;
  for (int i = 0; i < 3; ++i) refusals.count(Refusal::no_result, "x", 0);
  refusals.count(Refusal::unknown_key, "x", 0);
  const std::string text = metrics.text(*state_, refusals, {3, 1000, 2000});
  EXPECT_EQ(samples_of(text), R"(tetfarm_tasks{kind="decompose",state="done"} 2
tetfarm_tasks{kind="inspect",state="done"} 1
tetfarm_tasks{kind="inspect",state="failed"} 1
tetfarm_tasks{kind="mesh",state="done"} 1
tetfarm_tasks{kind="mesh",state="leased"} 1
tetfarm_tasks{kind="mesh",state="ready"} 1
tetfarm_queue_tasks 1
tetfarm_task_peak_rss_bytes 9000
tetfarm_jobs{state="cancelled"} 0
tetfarm_jobs{state="done"} 0
tetfarm_jobs{state="failed"} 1
tetfarm_jobs{state="running"} 1
tetfarm_jobs{state="waiting"} 0
tetfarm_hosts_in_quarantine 1
tetfarm_workers{state="busy"} 1
tetfarm_workers{state="drains"} 1
tetfarm_workers{state="idle"} 2
tetfarm_attempts_total{result="done"} 1
tetfarm_attempts_total{result="failed"} 2
tetfarm_attempts_total{result="crashed"} 1
tetfarm_attempts_total{result="killed"} 1
tetfarm_attempts_total{result="lost"} 1
tetfarm_attempts_total{result="returned"} 1
tetfarm_attempts_total{result="revoked"} 1
tetfarm_attempts_total{result="starved"} 1
tetfarm_commits_failed_total 2
tetfarm_events_total 3
tetfarm_refusals_total{reason="unknown_key"} 1
tetfarm_refusals_total{reason="revoked_key"} 0
tetfarm_refusals_total{reason="wrong_role"} 0
tetfarm_refusals_total{reason="broken_handshake"} 0
tetfarm_refusals_total{reason="too_many_connections"} 0
tetfarm_refusals_total{reason="too_many_workers"} 0
tetfarm_refusals_total{reason="foreign_connection"} 0
tetfarm_refusals_total{reason="garbage"} 0
tetfarm_refusals_total{reason="too_large"} 0
tetfarm_refusals_total{reason="wrong_version"} 0
tetfarm_refusals_total{reason="senseless"} 0
tetfarm_refusals_total{reason="stale"} 0
tetfarm_refusals_total{reason="outside_roots"} 0
tetfarm_refusals_total{reason="no_result"} 3
tetfarm_connections 3
tetfarm_store_free_bytes 1000
tetfarm_store_size_bytes 2000
tetfarm_stuck 0
)");
  EXPECT_THAT(text, HasSubstr("\ntetfarm_commit_seconds_count 1\n")) << "nothing was committed";
  EXPECT_THAT(text, testing::EndsWith("\ntetfarm_start_time_seconds 1.5\n"));
  state_->out_of_resources("full", now_);
  EXPECT_THAT(metrics.text(*state_, refusals, {}), HasSubstr("\ntetfarm_stuck 1\n"));
}

TEST(ExpositionCheck, finds_what_is_wrong) {
  for (const char* text :
       {"x 1\n", "# HELP x y\n# TYPE x gauge\nx 1", "# TYPE x gauge\nx 1\n",
        "# HELP x y\n# TYPE x counter\nx 1\n", "# HELP x y\n# TYPE x gauge\nx{a=1} 1\n",
        "# HELP x y\n# TYPE x histogram\nx_bucket{le=\"1\"} 2\nx_bucket{le=\"+Inf\"} 1\nx_sum 1\n"
        "x_count 1\n"}) {
    EXPECT_FALSE(Exposition(text).wrong().empty()) << text;
  }
}

}  // namespace
}  // namespace tetfarm
