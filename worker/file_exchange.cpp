#include "worker/file_exchange.h"

#include <spdlog/spdlog.h>

#include <set>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "store/disk_room.h"

namespace tetfarm {

TaskCache& FileExchange::cache() {
  if (!cache_) cache_.emplace(folder_, max_bytes_);
  return *cache_;
}

bool FileExchange::has_room() {
  bool has_room = true;
  try {
    has_room = disk_room(folder_).has(0);
  } catch (const IoError& error) {
    spdlog::warn("{}", error.what());
  }
  if (std::exchange(had_room_, has_room) && !has_room) {
    spdlog::warn("{}: the disk is full; no tasks are taken until there is room", folder_.string());
  }
  return has_room;
}

void FileExchange::fetch_inputs(const wire::Assign& assign) {
  upload_.reset();
  fetch_.reset();
  fetch_.emplace(cache(), assign);
}

void FileExchange::send_outputs(const wire::Envelope& outcome) {
  for (const std::string& hash : outcome.failed().damaged_inputs()) cache().drop(hash);
  fetch_.reset();
  upload_.emplace(cache(), outcome);
}

std::vector<wire::Envelope> FileExchange::due(std::int64_t now_ms) {
  TF_CHECK(!fetch_ || !upload_);
  if (is_fetching()) return fetch_->due(now_ms);
  if (is_sending()) return upload_->due(now_ms);
  return {};
}

void FileExchange::take(const wire::Envelope& message, std::int64_t now_ms) {
  if (message.has_file_chunk() && fetch_) fetch_->take(message.file_chunk(), now_ms);
  if (message.has_file_stored() && upload_) upload_->take(message.file_stored(), now_ms);
}

void FileExchange::ask_again() {
  if (fetch_) fetch_->ask_again();
  if (upload_) upload_->ask_again();
}

void FileExchange::forget_task() {
  fetch_.reset();
  upload_.reset();
  if (cache_) cache_->make_room(0, {});
}

}  // namespace tetfarm
