/// Figures of the farm in the text format of Prometheus (version 0.0.4).
///
/// Counters and histograms count what was committed since the coordinator started; gauges are read
/// from the rows when they are asked for. Units: seconds and bytes. All names are listed in
/// docs/operations.md.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "coordinator/decisions/job_state.h"
#include "coordinator/views/refusals.h"

namespace tetfarm {

/// How many of what was seen took at most so long.
class DurationHistogram {
 public:
  static constexpr std::array<double, 16> bounds = {
      0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 1, 5, 15, 60, 300, 900, 3600, 14400};
  void add(double value);
  /// Lines of `name`, under `labels` ("kind=\"mesh\"", or "").
  std::string text(const std::string& name, const std::string& labels) const;

 private:
  std::array<std::uint64_t, bounds.size() + 1> counts_{};
  double sum_ = 0;
};

/// What neither rows nor counters know.
struct FarmSurroundings {
  std::uint64_t connections = 0;
  std::uint64_t store_free_bytes = 0;
  std::uint64_t store_size_bytes = 0;
};

class FarmMetrics {
 public:
  explicit FarmMetrics(std::int64_t started_wall_ms) : started_wall_ms_(started_wall_ms) {}

  /// What was committed, and how long that took.
  void note(const ChangeSet& changes, double commit_seconds);
  void note_failed_commit() { ++failed_commits_; }

  /// Cost: looks at every task of the jobs that are not finished.
  std::string text(const JobState& state, const Refusals& refusals,
                   const FarmSurroundings& surroundings) const;

 private:
  std::int64_t started_wall_ms_;
  std::map<std::string, std::uint64_t> attempts_;          ///< ended ones, by result
  std::map<std::string, DurationHistogram> task_seconds_;  ///< of accepted attempts, by kind
  DurationHistogram commit_seconds_;
  std::uint64_t failed_commits_ = 0;
  std::uint64_t events_ = 0;
};

}  // namespace tetfarm
