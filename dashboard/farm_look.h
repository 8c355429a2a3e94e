/// One look at a farm: what is asked of it each time, and the snapshot that this makes.
///
/// Cost for the coordinator: the farm, a line for each job and each worker that is here, the events
/// since the look before (at most two pages), and all that is known of the newest 16 jobs that run.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "dashboard/farm_snapshot.h"
#include "dashboard/farm_source.h"
#include "json/meshing_rate.h"

namespace tetfarm {

struct LookTime {
  std::int64_t steady_ms = 0;
  std::int64_t wall_ms = 0;
};

class FarmLook {
 public:
  /// @param before what the look before saw: its events are kept. @throws as FarmSource.
  FarmSnapshot look(FarmSource& source, const FarmSnapshot& before, const LookTime& now);

  /// JSON of one job: status_json, and progress_json's share, tasks and eta_seconds.
  std::string job_body(const wire::StatusReply& reply, const LookTime& now);

 private:
  std::size_t add_jobs(FarmSource& source, const LookTime& now, FarmSnapshot& snapshot);
  std::string running_line(FarmSource& source, const wire::JobStatus& line, const LookTime& now,
                           FarmSnapshot& snapshot);

  std::map<std::string, MeshingRate> rates_;  ///< of jobs that run
};

/// The snapshot after a look that nobody answered: what was seen before, and why there is no more.
FarmSnapshot snapshot_without_answer(const FarmSnapshot& before, const std::string& trouble);

/// How long to rest after a look that took so long: it is never more than a tenth of the time.
std::int64_t rest_after_look_ms(std::int64_t took_ms);

}  // namespace tetfarm
