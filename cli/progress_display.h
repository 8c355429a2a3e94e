/// How far a job is: for a person a bar on a terminal, otherwise a line now and then; for programs
/// lines of JSON. On standard error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/progress_lines.h"
#include "json/meshing_rate.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// "mesh       41/63 sub-domains  212.4M tets  3.1M tets/s  eta 01:12"; the rate may be left out.
std::string progress_text(const wire::JobStatus& status, double tets_per_second,
                          bool says_rate = true);

/// What the task that runs longest does, and how many others run: "recovery pass 3: 312 of 1,204
/// edges (+2 tasks)"; "" when nothing is known of any.
std::string running_text(const wire::JobStatus& status);

/// How far the bar is: nothing before the leaves are meshed, `rate`'s share meanwhile, then all.
double share_done(const wire::JobStatus& status, const MeshingRate& rate);

/// A bar with the first of the texts that has room on a line of so many columns (0: not known)
/// beside a bar of 4 at least; the last one is cut where none has.
std::string bar_line(double share, const std::vector<std::string>& texts, std::size_t columns);

/// What the job will come to, as worker/job_forecast.h words it; "" while that is not known.
std::string forecast_text(const wire::JobStatus& status);

/// "12", "1.3k", "212.4M".
std::string short_count(double count);

/// "00:42", "1:02:03".
std::string clock_text(double seconds);

class ProgressDisplay {
 public:
  explicit ProgressDisplay(ProgressStyle style);
  /// @param workers that are there
  void show(const wire::JobStatus& status, std::uint32_t workers);
  /// What the job comes to, once, as soon as it is known; also of a job that ended before anything
  /// was shown. For people only: progress for programs has it in every line.
  void show_forecast(const wire::JobStatus& status);
  /// Clears the bar, so that other lines may follow.
  void end();

 private:
  void draw_bar(const wire::JobStatus& status, const std::string& running);
  bool is_line_due(const wire::JobStatus& status, std::int64_t now_ms) const;

  ProgressStyle style_;
  bool is_bar_;
  bool bar_is_drawn_ = false;
  bool told_forecast_ = false;
  std::string last_stage_;
  wire::RunningTask last_running_;
  std::int64_t last_line_ms_ = 0;
  MeshingRate rate_;
  ProgressLines lines_;
};

}  // namespace tetfarm
