/// Bytes as hexadecimal digits: two small letters or digits a byte, the high half first.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

std::string hex_of_bytes(std::string_view bytes);

}  // namespace tetfarm
