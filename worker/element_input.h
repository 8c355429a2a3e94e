/// Files of elements as the inputs of a task, and which of them has the last version of a section.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "mesh/artifacts/element_file.h"
#include "worker/task_io.h"

namespace tetfarm {

/// An ElementFile whose damage is that of the task's input.
class ElementInput {
 public:
  ElementInput(const TaskIo& io, TaskFile input);

  const ElementFileHead& head() const { return file_.head(); }
  ElementSection read(std::size_t section);
  CoreElements read_core();
  std::uint64_t bytes_read() const { return file_.bytes_read(); }

 private:
  const TaskIo& io_;
  TaskFile input_;
  ElementFile file_;
};

/// The colour of each leaf, by heap number.
using Colours = std::map<std::uint64_t, std::int32_t>;

/// From the lines "HEAP COLOUR …" of the order, what follows the colour left aside.
/// @throws Error when a line is not such a one.
Colours colours_of(const std::string& order);

/// Who of the sharers had the last turn of those with a colour below `below`; 0: nobody.
/// @pre every sharer has a colour, no two the same. @throws Error when one has none.
std::uint64_t last_before(const Sharers& sharers, const Colours& colours, std::int32_t below);

/// Who of the sharers has the last turn of all: its file has the final version of their section.
std::uint64_t last_turn(const Sharers& sharers, const Colours& colours);

}  // namespace tetfarm
