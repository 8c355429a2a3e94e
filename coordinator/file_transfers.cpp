#include "coordinator/file_transfers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "proto/file_chunks.h"

namespace tetfarm {
namespace {

/// Far more files than any task makes.
constexpr std::size_t most_offered = 10'000;

struct About {
  TaskId task;
  AttemptId attempt;
  std::string hash;
};

std::optional<About> about(const wire::Envelope& message) {
  const auto of = [](const auto& body) {
    return About{TaskId{body.task()}, AttemptId{body.attempt()}, body.hash()};
  };
  if (message.has_fetch_file()) return of(message.fetch_file());
  if (message.has_offer_file()) return of(message.offer_file());
  if (message.has_file_chunk()) return of(message.file_chunk());
  return std::nullopt;
}

}  // namespace

bool FileTransfers::take(const std::string& connection, WorkerId worker,
                         const wire::Envelope& message, const JobState& state, Moment now) {
  const std::optional<About> subject = about(message);
  if (!subject || !ArtifactStore::is_hash(subject->hash)) return false;
  if (!state.holds(worker, subject->task, subject->attempt)) return false;
  FileOrder order;
  order.connection = connection;
  order.task = subject->task;
  order.attempt = subject->attempt;
  order.file.hash = subject->hash;
  if (message.has_fetch_file()) {
    const std::vector<ArtifactRef>& inputs = state.durable().tasks.at(subject->task).inputs;
    const auto input = std::find_if(inputs.begin(), inputs.end(), [&](const ArtifactRef& file) {
      return file.hash == subject->hash;
    });
    if (input == inputs.end() || message.fetch_file().offset() % chunk_bytes != 0) return false;
    order.kind = FileOrder::Kind::read;
    order.file.size = input->size;
    order.offset = message.fetch_file().offset();
  } else if (message.has_offer_file()) {
    std::map<std::string, std::uint64_t>& offered = uploads_[subject->attempt];
    if (offered.size() >= most_offered && !offered.contains(subject->hash)) return false;
    order.kind = FileOrder::Kind::open;
    order.file.size = message.offer_file().size();
    offered[subject->hash] = order.file.size;
  } else {
    const auto files = uploads_.find(subject->attempt);
    if (files == uploads_.end() || !files->second.contains(subject->hash)) return false;
    order.kind = FileOrder::Kind::append;
    order.file.size = files->second.at(subject->hash);
    order.offset = message.file_chunk().offset();
    order.chunk = message.file_chunk();
  }
  TF_CHECK(ArtifactStore::is_hash(order.file.hash));
  return lines_.add(std::move(order), {worker, subject->task, subject->attempt}, now);
}

void FileTransfers::drop_finished(const JobState& state, std::vector<FileOrder>& orders) {
  lines_.erase_if([&](const LineHolder& holder) {
    return !state.holds(holder.worker, holder.task, holder.attempt);
  });
  std::erase_if(uploads_, [&](const auto& entry) {
    const auto& [attempt, files] = entry;
    if (state.durable().running_attempts.contains(attempt)) return false;
    for (const auto& [hash, size] : files) {
      FileOrder drop;
      drop.kind = FileOrder::Kind::drop;
      drop.attempt = attempt;
      drop.file = {hash, size};
      orders.push_back(std::move(drop));
    }
    return true;
  });
}

std::vector<FileOrder> FileTransfers::take_orders(const JobState& state, Moment now) {
  std::vector<FileOrder> orders;
  if (lines_.empty() && uploads_.empty()) return orders;
  drop_finished(state, orders);
  for (FileOrder& order : lines_.take(now)) orders.push_back(std::move(order));
  return orders;
}

}  // namespace tetfarm
