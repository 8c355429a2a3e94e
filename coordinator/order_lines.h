/// Who is served by the thread of files, and with how much at once: a line of orders for each
/// connection.
///
/// Memory is bounded: a few connections are served at once, each with a few chunks under way; the
/// others wait in the order in which they asked. Whoever is served and silent for a while makes
/// room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "coordinator/decisions/job_state.h"
#include "coordinator/file_orders.h"
#include "proto/file_chunks.h"

namespace tetfarm {

struct LineLimits {
  std::size_t served = 32;  ///< connections at once
  std::size_t under_way = chunks_at_once;
};

/// For whom a line's orders are; a client holds nothing.
struct LineHolder {
  WorkerId worker;
  TaskId task;
  AttemptId attempt;
};

class OrderLines {
 public:
  explicit OrderLines(const LineLimits& limits) : limits_(limits) {}

  /// Orders for another attempt take the place of those that wait. A repeated order that still
  /// waits is no second one. False for what is above the window of a connection.
  bool add(FileOrder order, const LineHolder& holder, Moment now);

  /// What to do now.
  std::vector<FileOrder> take(Moment now);
  /// An order of that connection was carried out.
  void note_answer(const std::string& connection);

  void erase_if(const std::function<bool(const LineHolder&)>& is_over);
  void clear() { lines_.clear(); }
  bool empty() const { return lines_.empty(); }

 private:
  struct Line {
    LineHolder holder;
    std::deque<FileOrder> waiting;
    std::size_t under_way = 0;
    bool is_served = false;
    std::int64_t heard_ms = 0;
    std::uint64_t turn = 0;  ///< who asked first is served first
  };
  void let_next_in(Moment now);

  LineLimits limits_;
  std::uint64_t last_turn_ = 0;
  std::map<std::string, Line> lines_;  ///< by connection
};

}  // namespace tetfarm
