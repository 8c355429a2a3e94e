/// Texts for manual pages, in the macros man(7).
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// The same text, read as it is: nothing in it is a request, an escape or a dash that may become
/// another sign.
std::string roff_text(std::string_view plain);

/// In bold, to be typed as it is, and in italics, for which something is to be put.
std::string roff_bold(std::string_view plain);
std::string roff_italic(std::string_view plain);

/// An entry of a list: its head is roff already, what it says is not. A sentence that does not end
/// gets its full stop.
std::string roff_entry(const std::string& head, std::string_view what);

/// Lines as they are, without filling.
std::string roff_lines(std::string_view plain);

}  // namespace tetfarm
