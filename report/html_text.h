/// Text and bytes as they may stand in a page of HTML.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// For text and for values in quotes: what would be markup is not, bytes that are no characters are
/// left out. What comes in as UTF-8 stays.
std::string escaped(std::string_view text);

/// Base64 of RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// "data:image/png;base64,…".
std::string png_address(std::string_view png);

}  // namespace tetfarm
