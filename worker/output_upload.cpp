#include "worker/output_upload.h"

#include <algorithm>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/file_chunks.h"

namespace tetfarm {

OutputUpload::OutputUpload(const TaskCache& cache, const wire::Envelope& outcome)
    : cache_(cache),
      task_(outcome.has_done() ? outcome.done().task() : outcome.failed().task()),
      attempt_(outcome.has_done() ? outcome.done().attempt() : outcome.failed().attempt()) {
  const auto& files = outcome.has_done() ? outcome.done().outputs() : outcome.failed().evidence();
  for (const wire::Artifact& file : files) {
    const StoredArtifact stored{file.hash(), file.size()};
    if (std::find(files_.begin(), files_.end(), stored) == files_.end()) files_.push_back(stored);
  }
}

wire::Envelope OutputUpload::offer() const {
  wire::Envelope envelope;
  wire::OfferFile& message = *envelope.mutable_offer_file();
  message.set_task(task_);
  message.set_attempt(attempt_);
  message.set_hash(files_.back().hash);
  message.set_size(files_.back().size);
  return envelope;
}

wire::Envelope OutputUpload::chunk_at(std::uint64_t offset) const {
  const StoredArtifact& file = files_.back();
  wire::Envelope envelope;
  wire::FileChunk& chunk = *envelope.mutable_file_chunk();
  chunk.set_task(task_);
  chunk.set_attempt(attempt_);
  chunk.set_hash(file.hash);
  chunk.set_offset(offset);
  fill_chunk(chunk, read_part_of_file(cache_.store().path_of(file.hash), offset,
                                      chunk_size(file.size, offset)));
  return envelope;
}

/// Who hears nothing for a while offers the file again: the answer says where to go on.
std::vector<wire::Envelope> OutputUpload::due(std::int64_t now_ms) {
  std::vector<wire::Envelope> messages;
  if (is_complete()) return messages;
  if (std::max(offered_ms_, heard_ms_) + chunk_again_ms < now_ms || offered_ms_ == never) {
    offered_ms_ = now_ms;
    is_open_ = false;
    messages.push_back(offer());
  }
  if (!is_open_) return messages;
  while (const auto offset = window_.next(files_.back().size, there_, now_ms)) {
    messages.push_back(chunk_at(*offset));
  }
  return messages;
}

void OutputUpload::take(const wire::FileStored& stored, std::int64_t now_ms) {
  if (is_complete() || stored.attempt() != attempt_ || stored.hash() != files_.back().hash) return;
  heard_ms_ = now_ms;
  if (stored.whole()) {
    files_.pop_back();
    is_open_ = false;
    offered_ms_ = never;
    there_ = 0;
    return;
  }
  if (stored.resend()) {
    // Each chunk behind a lost one says so; the first is enough.
    if (is_open_ && now_ms - resent_ms_ < resend_pause_ms) return;
    resent_ms_ = now_ms;
    is_open_ = true;
    there_ = stored.bytes();
    window_.start_again(there_);
  } else if (stored.bytes() > there_) {
    there_ = stored.bytes();
    window_.note(there_, now_ms);
  }
}

}  // namespace tetfarm
