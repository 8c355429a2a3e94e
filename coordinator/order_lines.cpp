#include "coordinator/order_lines.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

/// A line that is served and silent so long makes room: twice what its other end waits before it
/// asks again.
constexpr std::int64_t silence_ms = 2 * chunk_again_ms;

bool is_same(const FileOrder& a, const FileOrder& b) {
  return a.kind == b.kind && a.attempt == b.attempt && a.file.hash == b.file.hash &&
         a.offset == b.offset;
}

}  // namespace

bool OrderLines::add(FileOrder order, const LineHolder& holder, Moment now) {
  const auto [entry, is_new] = lines_.try_emplace(order.connection);
  Line& line = entry->second;
  if (is_new) line.turn = ++last_turn_;
  if (line.holder.attempt != holder.attempt) line.waiting.clear();
  line.holder = holder;
  line.heard_ms = now.steady_ms;
  const bool is_known =
      std::any_of(line.waiting.begin(), line.waiting.end(),
                  [&](const FileOrder& waiting) { return is_same(waiting, order); });
  if (is_known) return true;
  if (line.waiting.size() + line.under_way >= 2 * chunks_at_once) return false;
  line.waiting.push_back(std::move(order));
  return true;
}

void OrderLines::note_answer(const std::string& connection) {
  const auto line = lines_.find(connection);
  if (line != lines_.end() && line->second.under_way > 0) --line->second.under_way;
}

void OrderLines::erase_if(const std::function<bool(const LineHolder&)>& is_over) {
  std::erase_if(lines_, [&](const auto& entry) { return is_over(entry.second.holder); });
}

void OrderLines::let_next_in(Moment now) {
  std::erase_if(lines_, [&](const auto& entry) {
    const Line& line = entry.second;
    return line.waiting.empty() && line.under_way == 0 &&
           line.heard_ms + silence_ms < now.steady_ms;
  });
  std::vector<Line*> in_turn;
  std::size_t served = 0;
  for (auto& [connection, line] : lines_) {
    if (line.is_served) ++served;
    if (!line.is_served && !line.waiting.empty()) in_turn.push_back(&line);
  }
  std::sort(in_turn.begin(), in_turn.end(),
            [](const Line* a, const Line* b) { return a->turn < b->turn; });
  for (Line* line : in_turn) {
    if (served++ >= limits_.served) return;
    line->is_served = true;
  }
}

std::vector<FileOrder> OrderLines::take(Moment now) {
  std::vector<FileOrder> orders;
  let_next_in(now);
  for (auto& [connection, line] : lines_) {
    while (line.is_served && !line.waiting.empty() && line.under_way < limits_.under_way) {
      orders.push_back(std::move(line.waiting.front()));
      line.waiting.pop_front();
      ++line.under_way;
      TF_CHECK(line.under_way <= limits_.under_way);
    }
  }
  return orders;
}

}  // namespace tetfarm
