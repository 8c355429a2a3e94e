#include "worker/element_input.h"

#include <limits>
#include <sstream>
#include <utility>

namespace tetfarm {

ElementInput::ElementInput(const TaskIo& io, TaskFile input)
    : io_(io), input_(std::move(input)), file_(io.look_into(input_, [this](const auto& path) {
        return ElementFile(path, io_.name_of(input_));
      })) {}

ElementSection ElementInput::read(std::size_t section) {
  return io_.look_into(input_, [&](const auto&) { return file_.read(section); });
}

CoreElements ElementInput::read_core() {
  return io_.look_into(input_, [&](const auto&) { return file_.read_core(); });
}

Colours colours_of(const std::string& order) {
  Colours colours;
  std::istringstream lines(order);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::uint64_t heap = 0;
    std::int32_t colour = 0;
    if (!(words >> heap >> colour)) {
      throw Error(ExitCode::failed, "the order of the turns has the line \"" + line + "\"");
    }
    colours[heap] = colour;
  }
  return colours;
}

std::uint64_t last_before(const Sharers& sharers, const Colours& colours, std::int32_t below) {
  std::uint64_t last = 0;
  std::int32_t its_colour = -1;
  for (const std::uint64_t heap : sharers) {
    const auto found = colours.find(heap);
    if (found == colours.end()) {
      throw Error(ExitCode::failed, "sub-domain " + std::to_string(heap) + " has no turn");
    }
    if (found->second >= below || found->second <= its_colour) continue;
    last = heap;
    its_colour = found->second;
  }
  return last;
}

std::uint64_t last_turn(const Sharers& sharers, const Colours& colours) {
  return last_before(sharers, colours, std::numeric_limits<std::int32_t>::max());
}

}  // namespace tetfarm
