#include "worker/file_receive.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {

FileReceive::FileReceive(std::filesystem::path growing, StoredArtifact file)
    : growing_(std::move(growing)), file_(std::move(file)) {
  go_on_from_what_is_there();
  window_.start_again(there_);
  finish_when_all_is_there();
}

/// Who was killed while writing may have left a piece of a chunk.
void FileReceive::go_on_from_what_is_there() {
  TF_CHECK(there_ == 0);
  std::uint64_t size = size_of_file(growing_).value_or(0);
  if (size > file_.size) size = 0;
  if (size < file_.size) size -= size % chunk_bytes;
  append_to_file(growing_, 0, "");
  std::error_code error;
  std::filesystem::resize_file(growing_, size, error);
  if (error) throw IoError("cannot truncate", growing_.string(), error.value());
  while (there_ < size) {
    const std::string bytes = read_part_of_file(growing_, there_, chunk_size(file_.size, there_));
    if (bytes.empty()) throw IoError("cannot read", growing_.string(), EIO);
    hasher_.add(bytes.data(), bytes.size());
    there_ += bytes.size();
  }
  found_ = there_;
}

void FileReceive::finish_when_all_is_there() {
  if (there_ < file_.size) return;
  TF_CHECK(there_ == file_.size);
  state_ = hasher_.finish().hex() == file_.hash ? State::whole : State::damaged;
}

std::optional<std::uint64_t> FileReceive::next(std::int64_t now_ms) {
  if (state_ != State::coming) return std::nullopt;
  return window_.next(file_.size, there_, now_ms);
}

bool FileReceive::take(const wire::FileChunk& chunk, std::int64_t now_ms) {
  if (state_ != State::coming || chunk.hash() != file_.hash) return false;
  if (chunk.missing()) {
    state_ = State::missing;
    return true;
  }
  const std::uint64_t wanted = chunk_size(file_.size, there_);
  if (chunk.offset() != there_ || chunk.bytes().size() != wanted || !is_intact(chunk)) return false;
  append_to_file(growing_, there_, chunk.bytes());
  hasher_.add(chunk.bytes().data(), chunk.bytes().size());
  there_ += wanted;
  window_.note(there_, now_ms);
  finish_when_all_is_there();
  return true;
}

}  // namespace tetfarm
