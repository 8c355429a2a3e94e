/// What a run that was told to stop keeps, and what is lost: tasks that were under way start again
/// from their beginning.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

struct LostTask {
  std::uint64_t task = 0;
  std::string kind;
  std::uint64_t path = 0;  ///< of its sub-domain in the tree; 0: it has none
  double seconds = 0;      ///< that it had run
};

struct StoppedRun {
  std::string job;  ///< "": it had not been submitted yet
  std::uint64_t tasks_done = 0;
  std::vector<LostTask> lost;
};

/// The tasks that the workers of a farm run.
std::vector<std::uint64_t> tasks_under_way(const wire::StatusReply& farm);

/// Of the tasks that were under way when the run was told to stop, those that are not done, from
/// the rows of the store. @pre the farm has ended. @throws Error, IoError.
StoppedRun stopped_run(const std::filesystem::path& store, const std::filesystem::path& database,
                       const std::string& job, const std::vector<std::uint64_t>& under_way);

/// For people, with line ends.
std::string stopped_text(const StoppedRun& stopped);
/// One object, one line, no end.
std::string stopped_json(const StoppedRun& stopped);

}  // namespace tetfarm
