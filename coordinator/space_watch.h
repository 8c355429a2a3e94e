/// Is there room in the store for what runs and for what would be handed out next? Work whose
/// result cannot be stored is work lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "coordinator/decisions/job_state.h"
#include "store/disk_room.h"

namespace tetfarm {

class SpaceWatch {
 public:
  using RoomOf = std::function<DiskRoom(const std::filesystem::path&)>;
  SpaceWatch(std::filesystem::path store, std::filesystem::path database, RoomOf room = disk_room)
      : store_(std::move(store)), database_(std::move(database)), room_of_(std::move(room)) {}

  /// Learns from a done task how large results are; others tell nothing.
  void note(const TaskRow& task);

  /// Bytes that the running tasks, and the next ready one for each of so many workers, are expected
  /// to write: as much as the largest result of their kind in their job so far; where there is
  /// none, by the estimated elements, or twice what they read, and of `assemble` as much.
  /// Cost: O(running tasks, workers).
  std::uint64_t expected_bytes(const JobState& state, std::size_t workers) const;

  /// What is wrong, for people; "": there is room, or it was looked at a moment ago.
  /// @throws IoError.
  std::string trouble(const JobState& state, Moment now);

 private:
  std::filesystem::path store_;
  std::filesystem::path database_;
  RoomOf room_of_;
  std::map<std::pair<JobId, TaskKind>, std::uint64_t> largest_;  ///< result of a kind in a job
  std::int64_t next_look_ms_ = 0;
};

}  // namespace tetfarm
