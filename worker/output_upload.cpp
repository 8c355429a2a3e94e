#include "worker/output_upload.h"

#include <algorithm>
#include <utility>

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
    const bool is_known =
        std::any_of(files_.begin(), files_.end(),
                    [&stored](const FileSend& known) { return known.file() == stored; });
    if (!is_known) files_.emplace_back(stored);
  }
}

wire::Envelope OutputUpload::offer() const {
  wire::Envelope envelope;
  wire::OfferFile& message = *envelope.mutable_offer_file();
  message.set_task(task_);
  message.set_attempt(attempt_);
  message.set_hash(files_.back().file().hash);
  message.set_size(files_.back().file().size);
  return envelope;
}

wire::Envelope OutputUpload::chunk_at(std::uint64_t offset) const {
  const StoredArtifact& file = files_.back().file();
  wire::Envelope envelope;
  wire::FileChunk& chunk = *envelope.mutable_file_chunk();
  chunk.set_task(task_);
  chunk.set_attempt(attempt_);
  chunk.set_hash(file.hash);
  chunk.set_offset(offset);
  const std::uint64_t size = chunk_size(file.size, offset);
  std::string bytes = read_part_of_file(cache_.store().path_of(file.hash), offset, size);
  if (bytes.size() != size) check_file();
  fill_chunk(chunk, std::move(bytes));
  return envelope;
}

void OutputUpload::check_file() const {
  const StoredArtifact& file = files_.back().file();
  try {
    cache_.store().verify(file.hash, file.size);
  } catch (const CorruptFile&) {
    cache_.drop(file.hash);
    throw;
  }
}

std::vector<wire::Envelope> OutputUpload::due(std::int64_t now_ms) {
  std::vector<wire::Envelope> messages;
  if (is_complete()) return messages;
  const FileSend::Due due = files_.back().due(now_ms);
  if (due.offer) messages.push_back(offer());
  for (const std::uint64_t offset : due.chunks) messages.push_back(chunk_at(offset));
  return messages;
}

void OutputUpload::take(const wire::FileStored& stored, std::int64_t now_ms) {
  if (is_complete() || stored.attempt() != attempt_) return;
  const int setbacks = files_.back().setbacks();
  files_.back().take(stored, now_ms);
  if (files_.back().setbacks() > setbacks) check_file();
  if (files_.back().is_whole()) files_.pop_back();
}

void OutputUpload::ask_again() {
  if (!is_complete()) files_.back().ask_again();
}

}  // namespace tetfarm
