#include "mesh/job_file/toml_text.h"

#include <array>
#include <charconv>

namespace tetfarm {

std::string quoted_toml(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c >= '\0' && (c < ' ' || c == '\x7f')) {
      constexpr std::string_view digits = "0123456789ABCDEF";
      const auto code = static_cast<unsigned char>(c);
      result += {'\\', 'u', '0', '0', digits[code / 16], digits[code % 16]};
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string toml_number(double value) {
  if (value == 0) return "0";  // "-0" would come back as the whole number 0
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace tetfarm
