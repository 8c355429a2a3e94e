/// Undoes what was begun when its scope is left before it was done, by an exception or by a return:
/// a temporary file is removed, a transaction rolled back.
///
///     UndoUnlessDone growing([&] { ::unlink(temp.c_str()); });
///     write(temp);
///     growing.done();
#pragma once

#include <utility>

namespace tetfarm {

/// @pre `Undo` does not throw.
template <class Undo>
class [[nodiscard]] UndoUnlessDone {
 public:
  explicit UndoUnlessDone(Undo undo) : undo_(std::move(undo)) {}
  ~UndoUnlessDone() {
    if (!is_done_) undo_();
  }
  UndoUnlessDone(const UndoUnlessDone&) = delete;
  UndoUnlessDone& operator=(const UndoUnlessDone&) = delete;

  void done() noexcept { is_done_ = true; }

 private:
  Undo undo_;
  bool is_done_ = false;
};

}  // namespace tetfarm
