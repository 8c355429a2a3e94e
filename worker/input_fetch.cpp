#include "worker/input_fetch.h"

#include <algorithm>

#include "base/check.h"
#include "base/file_system.h"

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
  if (!receive_) return;
  std::error_code ignored;
  std::filesystem::remove(receive_->path(), ignored);
}

void InputFetch::begin_next_file() {
  TF_CHECK(!receive_);
  while (!files_.empty() && damaged_.empty()) {
    receive_.emplace(cache_.store().scratch_path("fetch"), files_.back());
    if (receive_->state() == FileReceive::State::coming) return;
    finish_file();
  }
}

/// A file that is whole but wrong is damaged where it came from.
void InputFetch::finish_file() {
  TF_CHECK(receive_ && !files_.empty());
  if (receive_->state() == FileReceive::State::whole) {
    cache_.store().adopt_checked_file(receive_->path(), files_.back().hash);
  } else {
    remove_file(receive_->path());
    damaged_ = files_.back().hash;
  }
  receive_.reset();
  files_.pop_back();
}

std::vector<wire::Envelope> InputFetch::due(std::int64_t now_ms) {
  std::vector<wire::Envelope> messages;
  if (!receive_) return messages;
  while (const auto offset = receive_->next(now_ms)) {
    wire::FetchFile& fetch = *messages.emplace_back().mutable_fetch_file();
    fetch.set_task(task_);
    fetch.set_attempt(attempt_);
    fetch.set_hash(files_.back().hash);
    fetch.set_offset(*offset);
  }
  return messages;
}

void InputFetch::take(const wire::FileChunk& chunk, std::int64_t now_ms) {
  if (!receive_ || chunk.attempt() != attempt_) return;
  receive_->take(chunk, now_ms);
  if (receive_->state() == FileReceive::State::coming) return;
  finish_file();
  begin_next_file();
}

}  // namespace tetfarm
