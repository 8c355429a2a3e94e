#include "cli/coloured_text.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "cli/terminal.h"

namespace tetfarm {
namespace {

std::string_view from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool standard_error_has_colours() {
  return ::isatty(STDERR_FILENO) == 1 && from_environment("NO_COLOR").empty() &&
         from_environment("TERM") != "dumb";
}

std::string red(const std::string& text, bool is_coloured) {
  return is_coloured ? std::string(red_begins) + text + std::string(red_ends) : text;
}

}  // namespace tetfarm
