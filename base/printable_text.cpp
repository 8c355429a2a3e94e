#include "base/printable_text.h"

#include <algorithm>

#include "base/check.h"
#include "base/utf8.h"

namespace tetfarm {
namespace {

constexpr std::string_view hex_digits = "0123456789abcdef";

std::string hex(std::size_t value, int digits) {
  TF_CHECK(digits > 0 && digits <= 16);
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    text += hex_digits[(value >> static_cast<unsigned>(shift)) & 0xFU];
  }
  return text;
}

std::string escape_of(char32_t value) {
  switch (value) {
    case U'\n':
      return "\\n";
    case U'\t':
      return "\\t";
    case U'\r':
      return "\\r";
    default:
      return "\\u" + hex(value, 4);
  }
}

bool is_plain(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

std::string printable(std::string_view text, Lines lines) {
  if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint found = code_point_at(text, at);
    const bool stays = lines == Lines::kept && (found.value == U'\n' || found.value == U'\t');
    if (found.bytes == 0) {
      shown += "\\x" + hex(static_cast<unsigned char>(text[at]), 2);
    } else if (is_control(found.value) && !stays) {
      shown += escape_of(found.value);
    } else {
      shown += text.substr(at, found.bytes);
    }
    at += std::max<std::size_t>(found.bytes, 1);
  }
  return shown;
}

}  // namespace tetfarm
