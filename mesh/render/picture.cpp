#include "mesh/render/picture.h"

#include <zlib.h>

#include <stdexcept>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr char filter_up = 2;

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string checked = type + data;
  const auto sum =
      ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + checked +
         big_endian(static_cast<std::uint32_t>(sum));
}

/// Each row as its differences to the row above, which is 0 for the first.
std::string filtered_rows(const Picture& picture) {
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  std::string rows;
  rows.reserve(picture.bytes.size() + static_cast<std::size_t>(picture.height));
  for (std::size_t i = 0; i < picture.bytes.size(); ++i) {
    if (i % row == 0) rows += filter_up;
    const int above = i < row ? 0 : picture.bytes[i - row];
    rows += static_cast<char>((picture.bytes[i] - above) & 0xFF);
  }
  return rows;
}

std::string deflated(const std::string& plain) {
  uLongf size = ::compressBound(static_cast<uLong>(plain.size()));
  std::string packed(size, '\0');
  const int result = ::compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<const Bytef*>(plain.data()),
                                 static_cast<uLong>(plain.size()), 9);
  if (result != Z_OK) throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_of(const Picture& picture) {
  constexpr char bits_per_channel = 8;
  constexpr char truecolour = 2;
  TF_CHECK(picture.width > 0 && picture.height > 0);
  std::string header = big_endian(static_cast<std::uint32_t>(picture.width)) +
                       big_endian(static_cast<std::uint32_t>(picture.height));
  header += {bits_per_channel, truecolour, 0, 0, 0};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) +
         chunk("IDAT", deflated(filtered_rows(picture))) + chunk("IEND", "");
}

}  // namespace tetfarm
