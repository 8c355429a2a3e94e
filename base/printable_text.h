/// Text of others for logs and terminals, where a control character would forge a line or steer the
/// terminal.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// Whether ends of lines and tabs stay what they are.
enum class Lines { escaped, kept };

/// The same text in valid UTF-8 without control characters (is_control): they become "\n", "\t",
/// "\r" or "\u001b", bytes that are no UTF-8 "\xff". A text that needs none of this comes back as
/// it is, backslashes too; JSON text keeps its meaning. Cost: O(size).
std::string printable(std::string_view text, Lines lines = Lines::escaped);

}  // namespace tetfarm
