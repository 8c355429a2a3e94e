/// UTF-8 that may not be UTF-8: names, messages and paths come from file systems and from
/// strangers.
#pragma once

#include <cstddef>
#include <string_view>

namespace tetfarm {

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 0;  ///< 0: no UTF-8 is there
};

/// The character that begins at `at`; overlong forms and surrogates are none. @pre at < size.
CodePoint code_point_at(std::string_view text, std::size_t at);

bool is_utf8(std::string_view text);

/// Whether it steers what shows it instead of being shown: a control character, or one that ends
/// lines or turns the direction of what follows.
bool is_control(char32_t value);

/// The beginning of the text, at most so many bytes, without half a character at its end.
std::string_view cut_utf8(std::string_view text, std::size_t most_bytes);

}  // namespace tetfarm
