#include "coordinator/decisions/full_disk_pause.h"

#include <algorithm>

namespace tetfarm {

bool FullDiskPause::begin(const std::string& message, std::int64_t now_ms) {
  message_ = message;
  if (wait_ms(now_ms) > 0) return false;
  pause_ms_ = is_stuck() ? std::min(2 * pause_ms_, longest_ms_) : first_ms_;
  until_ms_ = now_ms + pause_ms_;
  return true;
}

void FullDiskPause::end() {
  pause_ms_ = 0;
  message_.clear();
}

std::int64_t FullDiskPause::wait_ms(std::int64_t now_ms) const {
  return is_stuck() ? std::max<std::int64_t>(until_ms_ - now_ms, 0) : 0;
}

}  // namespace tetfarm
