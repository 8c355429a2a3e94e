#include "mesh/render/picture.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace tetfarm {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Reads a PNG as the standard says: chunks with checksums, one zlib stream, rows filtered "up".
Picture decoded(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  Picture picture;
  std::string packed;
  std::vector<std::string> types;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::uint32_t length = number_at(png, at);
    const std::string checked = png.substr(at + 4, 4 + length);
    EXPECT_EQ(number_at(png, at + 8 + length),
              ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                      static_cast<uInt>(checked.size())));
    types.push_back(checked.substr(0, 4));
    if (types.back() == "IHDR") {
      picture.width = static_cast<int>(number_at(checked, 4));
      picture.height = static_cast<int>(number_at(checked, 8));
      EXPECT_EQ(checked.substr(12), std::string("\x08\x02\0\0\0", 5));
    }
    if (types.back() == "IDAT") packed += checked.substr(4);
    at += 12 + length;
  }
  EXPECT_EQ(types, (std::vector<std::string>{"IHDR", "IDAT", "IEND"}));
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  std::string rows((row + 1) * static_cast<std::size_t>(picture.height), '\0');
  uLongf size = rows.size();
  EXPECT_EQ(::uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  EXPECT_EQ(size, rows.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
    EXPECT_EQ(rows[y * (row + 1)], 2);
    for (std::size_t x = 0; x < row; ++x) {
      const int above = y == 0 ? 0 : picture.bytes[(y - 1) * row + x];
      const int here = static_cast<unsigned char>(rows[y * (row + 1) + 1 + x]);
      picture.bytes.push_back(static_cast<std::uint8_t>(above + here));
    }
  }
  return picture;
}

TEST(Png, gives_back_every_pixel) {
  Picture picture{37, 23, {}};
  for (int i = 0; i < 37 * 23 * 3; ++i)
    picture.bytes.push_back(static_cast<std::uint8_t>(i * i / 7));
  const Picture back = decoded(png_of(picture));
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 23);
  EXPECT_EQ(back.bytes, picture.bytes);
}

TEST(Png, of_one_pixel_is_one) {
  const Picture back = decoded(png_of({1, 1, {255, 0, 7}}));
  EXPECT_EQ(back.bytes, (std::vector<std::uint8_t>{255, 0, 7}));
}

}  // namespace
}  // namespace tetfarm
