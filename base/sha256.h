/// SHA-256: a checksum that nobody can find another text for, nor the text from the checksum. For
/// what must not be known from what is kept of it; files are named by the faster Hasher.
///
/// Source: FIPS 180-4, sections 4.1.2, 5 and 6.2.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// 64 hexadecimal digits. Cost: one pass, a copy of the last block only.
std::string sha256_hex(std::string_view bytes);

}  // namespace tetfarm
