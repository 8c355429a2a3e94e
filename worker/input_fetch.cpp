#include "worker/input_fetch.h"

#include <algorithm>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/file_chunks.h"

namespace tetfarm {

InputFetch::InputFetch(const TaskCache& cache, const wire::Assign& assign)
    : cache_(cache), task_(assign.task()), attempt_(assign.attempt()) {
  std::set<std::string> needed;
  std::uint64_t coming_bytes = 0;
  for (const wire::Artifact& input : assign.inputs()) {
    if (!needed.insert(input.hash()).second) continue;
    if (cache_.store().has(input.hash(), input.size())) {
      cache_.touch(input.hash());
    } else {
      files_.push_back({input.hash(), input.size()});
      coming_bytes += input.size();
    }
  }
  cache_.make_room(coming_bytes, needed);
  begin_next_file();
}

InputFetch::~InputFetch() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void InputFetch::begin_next_file() {
  while (!files_.empty()) {
    path_ = cache_.store().scratch_path("fetch");
    hasher_ = Hasher();
    there_ = 0;
    window_.start_again(0);
    if (files_.back().size > 0) return;
    append_to_file(path_, 0, "");
    finish_file();
  }
}

/// A file that is whole but wrong is damaged where it came from.
void InputFetch::finish_file() {
  if (hasher_.finish().hex() != files_.back().hash) {
    remove_file(path_);
    damaged_ = files_.back().hash;
  } else {
    cache_.store().adopt_checked_file(path_, files_.back().hash);
  }
  files_.pop_back();
}

std::vector<wire::Envelope> InputFetch::due(std::int64_t now_ms) {
  std::vector<wire::Envelope> messages;
  if (is_complete() || !damaged_.empty()) return messages;
  while (const auto offset = window_.next(files_.back().size, there_, now_ms)) {
    wire::FetchFile& fetch = *messages.emplace_back().mutable_fetch_file();
    fetch.set_task(task_);
    fetch.set_attempt(attempt_);
    fetch.set_hash(files_.back().hash);
    fetch.set_offset(*offset);
  }
  return messages;
}

void InputFetch::take(const wire::FileChunk& chunk, std::int64_t now_ms) {
  if (is_complete() || !damaged_.empty() || chunk.attempt() != attempt_ ||
      chunk.hash() != files_.back().hash) {
    return;
  }
  if (chunk.missing()) {
    damaged_ = chunk.hash();
    return;
  }
  const std::uint64_t wanted = chunk_size(files_.back().size, there_);
  if (chunk.offset() != there_ || chunk.bytes().size() != wanted || !is_intact(chunk)) return;
  append_to_file(path_, there_, chunk.bytes());
  hasher_.add(chunk.bytes().data(), chunk.bytes().size());
  there_ += wanted;
  window_.note(there_, now_ms);
  if (there_ < files_.back().size) return;
  finish_file();
  begin_next_file();
}

}  // namespace tetfarm
