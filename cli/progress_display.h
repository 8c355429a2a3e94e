/// How far a job is, for a person: a bar on a terminal, otherwise a line now and then. On standard
/// error.
#pragma once

#include <cstdint>
#include <string>

#include "cli/command_line.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// "mesh       41/63 sub-domains  212.4M tets  3.1M tets/s  eta 01:12"
std::string progress_text(const wire::JobStatus& status, double tets_per_second);

/// "12", "1.3k", "212.4M".
std::string short_count(double count);

/// "00:42", "1:02:03".
std::string clock_text(double seconds);

class ProgressDisplay {
 public:
  explicit ProgressDisplay(ProgressStyle style);
  void show(const wire::JobStatus& status);
  /// Clears the bar, so that other lines may follow.
  void end();

 private:
  void draw_bar(const wire::JobStatus& status, const std::string& text);

  ProgressStyle style_;
  bool is_bar_;
  bool bar_is_drawn_ = false;
  std::string last_stage_;
  std::int64_t last_line_ms_ = 0;
  std::int64_t first_ms_ = 0;
  std::uint64_t first_elements_ = 0;
};

}  // namespace tetfarm
