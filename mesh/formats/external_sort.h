/// Sorts more records than memory should hold: runs of them are sorted in memory and laid down in a
/// file without a name, then merged.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <queue>
#include <type_traits>
#include <vector>

#include "base/check.h"
#include "mesh/formats/scratch_file.h"

namespace tetfarm {

/// `Record` is compared by < and copied as bytes. First every `push`, then every `next`.
/// Cost: O(n log n); memory of `records_in_memory`, and of 4096 for each run.
template <class Record>
class ExternalSort {
 public:
  /// The file lies in `folder`, and is made when it is needed. @throws IoError, also later.
  explicit ExternalSort(const std::filesystem::path& folder,
                        std::size_t records_in_memory = std::size_t{1} << 20)
      : folder_(folder), limit_(records_in_memory) {
    static_assert(std::is_trivially_copyable_v<Record>);
    TF_CHECK(limit_ > 0);
  }

  void push(const Record& record) {
    TF_CHECK(!is_sorted_);
    if (records_.size() == limit_) lay_down();
    records_.push_back(record);
  }

  /// The next record in order; false after the last.
  bool next(Record& record) {
    if (!is_sorted_) begin_merge();
    if (front_.empty()) return false;
    const std::size_t run = front_.top().run;
    record = front_.top().record;
    front_.pop();
    advance(run);
    return true;
  }

  /// The next records up to the first that does not belong to them.
  template <class Belongs>
  std::vector<Record> take_while(const Belongs& belongs) {
    if (!is_sorted_) begin_merge();
    std::vector<Record> taken;
    while (!front_.empty() && belongs(front_.top().record)) next(taken.emplace_back());
    return taken;
  }

 private:
  static constexpr std::size_t records_of_piece = 4096;

  /// Sorted records: those in memory, then those from `place` on in the file.
  struct Run {
    std::vector<Record> piece;
    std::size_t next = 0;
    std::int64_t place = 0;
    std::size_t left_in_file = 0;
  };
  struct Front {
    Record record;
    std::size_t run = 0;
    /// The smallest is on top; equal ones in the order of their runs.
    bool operator<(const Front& other) const {
      if (other.record < record) return true;
      return !(record < other.record) && other.run < run;
    }
  };

  void lay_down() {
    std::stable_sort(records_.begin(), records_.end());
    if (!file_.is_open()) file_ = ScratchFile(folder_);
    Run run;
    run.place = file_.size();
    run.left_in_file = records_.size();
    file_.append(records_.data(), records_.size() * sizeof(Record));
    runs_.push_back(std::move(run));
    records_.clear();
  }

  void begin_merge() {
    is_sorted_ = true;
    std::stable_sort(records_.begin(), records_.end());
    Run last;
    last.piece = std::move(records_);
    runs_.push_back(std::move(last));
    for (std::size_t run = 0; run < runs_.size(); ++run) advance(run);
  }

  void advance(std::size_t index) {
    Run& run = runs_[index];
    if (run.next == run.piece.size()) {
      const std::size_t count = std::min(run.left_in_file, records_of_piece);
      run.piece.resize(count);
      run.next = 0;
      if (count == 0) return;
      file_.read(run.place, run.piece.data(), count * sizeof(Record));
      run.place += static_cast<std::int64_t>(count * sizeof(Record));
      run.left_in_file -= count;
    }
    front_.push({run.piece[run.next++], index});
  }

  std::filesystem::path folder_;
  std::size_t limit_;
  bool is_sorted_ = false;
  std::vector<Record> records_;
  std::vector<Run> runs_;
  std::priority_queue<Front> front_;
  ScratchFile file_;
};

}  // namespace tetfarm
