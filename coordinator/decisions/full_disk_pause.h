/// While the disk is full nothing is handed out: after a pause it is tried again, and each pause is
/// twice as long as the one before until something is done.
/// Units: times in milliseconds. Cost: O(1).
#pragma once

#include <cstdint>
#include <string>

namespace tetfarm {

class FullDiskPause {
 public:
  /// @param first_ms of the first pause; @param longest_ms of any.
  FullDiskPause(std::int64_t first_ms, std::int64_t longest_ms)
      : first_ms_(first_ms), longest_ms_(longest_ms) {}

  /// The disk was full. False when that is known and the pause is not over.
  bool begin(const std::string& message, std::int64_t now_ms);
  /// Something was done: there is room.
  void end();

  /// Whether there was no room when it was last tried.
  bool is_stuck() const { return pause_ms_ > 0; }
  const std::string& message() const { return message_; }
  /// Until the next try; 0 when it may be tried.
  std::int64_t wait_ms(std::int64_t now_ms) const;

 private:
  std::int64_t first_ms_;
  std::int64_t longest_ms_;
  std::int64_t until_ms_ = 0;
  std::int64_t pause_ms_ = 0;  ///< 0: not stuck
  std::string message_;
};

}  // namespace tetfarm
