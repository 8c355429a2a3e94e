/// A farm on one screen, as `tetfarm top` shows it: its jobs, its workers and what waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "json/meshing_rate.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct SeenFarm {
  wire::StatusReply status;  ///< with all jobs
  std::vector<wire::WorkerLine> workers;
};

/// What was seen of a farm so far, for what one look does not tell: rates, and shares that do not
/// fall.
class FarmScreen {
 public:
  /// A text with line ends: what waits, the jobs that run and then others, the newest first, and
  /// the workers, those that work first. @pre `now_ms` of a steady clock, not before that of the
  /// last call.
  std::string text(const SeenFarm& seen, std::int64_t now_ms);

 private:
  struct SeenJob {
    MeshingRate rate;
    double share = 0;
  };
  std::vector<std::string> row_of(const wire::JobStatus& job, std::int64_t now_ms);

  std::map<std::string, SeenJob> jobs_;
};

/// As much of a text as a screen of so many lines and columns (0: not known) has room for; where it
/// has not for all lines, the last one says how many are left out.
std::string cut_to_screen(const std::string& text, std::size_t lines, std::size_t columns);

}  // namespace tetfarm
