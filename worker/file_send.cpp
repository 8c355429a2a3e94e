#include "worker/file_send.h"

#include <algorithm>

namespace tetfarm {

/// Who hears nothing for a while offers the file again: the answer says where to go on.
FileSend::Due FileSend::due(std::int64_t now_ms) {
  Due due;
  if (is_whole_) return due;
  if (std::max(offered_ms_, heard_ms_) + chunk_again_ms < now_ms || offered_ms_ == never) {
    offered_ms_ = now_ms;
    is_open_ = false;
    due.offer = true;
  }
  if (!is_open_) return due;
  while (const auto offset = window_.next(file_.size, there_, now_ms)) {
    due.chunks.push_back(*offset);
    sent_ = *offset + chunk_size(file_.size, *offset);
  }
  return due;
}

bool FileSend::take(const wire::FileStored& stored, std::int64_t now_ms) {
  if (is_whole_ || stored.hash() != file_.hash) return false;
  heard_ms_ = now_ms;
  if (stored.whole()) {
    is_whole_ = true;
    there_ = file_.size;
  } else if (stored.resend()) {
    // Each chunk behind a lost one says so; the first is enough.
    if (is_open_ && now_ms - resent_ms_ < resend_pause_ms) return true;
    resent_ms_ = now_ms;
    if (stored.bytes() < sent_) ++setbacks_;
    sent_ = stored.bytes();
    is_open_ = true;
    there_ = stored.bytes();
    window_.start_again(there_);
  } else if (stored.bytes() > there_) {
    there_ = stored.bytes();
    window_.note(there_, now_ms);
  }
  return true;
}

}  // namespace tetfarm
