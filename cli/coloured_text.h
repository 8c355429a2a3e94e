/// Colour on a terminal, and none anywhere else.
#pragma once

#include <string>

namespace tetfarm {

/// Whether standard error is a terminal that wants colours: not when NO_COLOR is set and not empty
/// (https://no-color.org) or TERM is "dumb".
bool standard_error_has_colours();

/// The text in red, or as it is.
std::string red(const std::string& text, bool is_coloured);

}  // namespace tetfarm
