#include "cli/roff_text.h"

#include <algorithm>

namespace tetfarm {
namespace {

/// What man(7) wants for a letter that it would read otherwise or show as another sign.
std::string roff_letter(char c) {
  switch (c) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return std::string(1, c);
  }
}

}  // namespace

std::string roff_text(std::string_view plain) {
  std::string text;
  // At the beginning of a line it would be a request.
  if (plain.starts_with('.')) text = "\\&";
  for (const char c : plain) text += roff_letter(c);
  return text;
}

std::string roff_bold(std::string_view plain) { return "\\fB" + roff_text(plain) + "\\fR"; }

std::string roff_italic(std::string_view plain) { return "\\fI" + roff_text(plain) + "\\fR"; }

std::string roff_entry(const std::string& head, std::string_view what) {
  const bool is_ended = what.empty() || what.ends_with('.');
  return ".TP\n" + head + "\n" + roff_text(what) + (is_ended ? "" : ".") + "\n";
}

std::string roff_lines(std::string_view plain) {
  std::string text = ".nf\n";
  while (!plain.empty()) {
    const std::size_t end = std::min(plain.find('\n'), plain.size());
    text += (end == 0 ? ".sp" : roff_text(plain.substr(0, end))) + "\n";
    plain.remove_prefix(std::min(end + 1, plain.size()));
  }
  return text + ".fi\n";
}

}  // namespace tetfarm
