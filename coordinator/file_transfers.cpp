#include "coordinator/file_transfers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "proto/file_chunks.h"

namespace tetfarm {
namespace {

/// A line that is served and silent so long makes room: twice what a worker waits before it asks
/// again.
constexpr std::int64_t silence_ms = 2 * chunk_again_ms;

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

bool is_same(const FileOrder& a, const FileOrder& b) {
  return a.kind == b.kind && a.attempt == b.attempt && a.file.hash == b.file.hash &&
         a.offset == b.offset;
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
    order.kind = FileOrder::Kind::open;
    order.file.size = message.offer_file().size();
    uploads_[subject->attempt][subject->hash] = order.file.size;
  } else {
    const auto files = uploads_.find(subject->attempt);
    if (files == uploads_.end() || !files->second.contains(subject->hash)) return false;
    order.kind = FileOrder::Kind::append;
    order.file.size = files->second.at(subject->hash);
    order.offset = message.file_chunk().offset();
    order.chunk = message.file_chunk();
  }
  return add(connection, worker, std::move(order), now);
}

/// A repeated request that still waits is no second one; what is above the window is not heard.
bool FileTransfers::add(const std::string& connection, WorkerId worker, FileOrder order,
                        Moment now) {
  Line& line = lines_[connection];
  if (line.attempt != order.attempt) {
    line.waiting.clear();
    line.task = order.task;
    line.attempt = order.attempt;
    line.worker = worker;
  }
  if (line.turn == 0) line.turn = ++last_turn_;
  line.heard_ms = now.steady_ms;
  const bool is_known =
      std::any_of(line.waiting.begin(), line.waiting.end(),
                  [&](const FileOrder& waiting) { return is_same(waiting, order); });
  if (is_known) return true;
  if (line.waiting.size() + line.under_way >= 2 * chunks_at_once) return false;
  line.waiting.push_back(std::move(order));
  return true;
}

void FileTransfers::note_answer(const std::string& connection) {
  const auto line = lines_.find(connection);
  if (line != lines_.end() && line->second.under_way > 0) --line->second.under_way;
}

void FileTransfers::drop_finished(const JobState& state, std::vector<FileOrder>& orders) {
  std::erase_if(lines_, [&](const auto& entry) {
    return !state.holds(entry.second.worker, entry.second.task, entry.second.attempt);
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

void FileTransfers::let_next_in(Moment now) {
  std::vector<Line*> in_turn;
  std::size_t served = 0;
  for (auto& [connection, line] : lines_) {
    const bool is_over =
        line.waiting.empty() && line.under_way == 0 && line.heard_ms + silence_ms < now.steady_ms;
    if (is_over) {
      line.is_served = false;
      line.turn = 0;
    }
    if (line.is_served) ++served;
    if (!line.is_served && !line.waiting.empty()) in_turn.push_back(&line);
  }
  std::sort(in_turn.begin(), in_turn.end(),
            [](const Line* a, const Line* b) { return a->turn < b->turn; });
  for (Line* line : in_turn) {
    if (served++ >= most_transfers_) return;
    line->is_served = true;
  }
}

std::vector<FileOrder> FileTransfers::take_orders(const JobState& state, Moment now) {
  std::vector<FileOrder> orders;
  if (lines_.empty() && uploads_.empty()) return orders;
  drop_finished(state, orders);
  let_next_in(now);
  for (auto& [connection, line] : lines_) {
    while (line.is_served && !line.waiting.empty() && line.under_way < chunks_at_once) {
      orders.push_back(std::move(line.waiting.front()));
      line.waiting.pop_front();
      ++line.under_way;
    }
  }
  return orders;
}

}  // namespace tetfarm
