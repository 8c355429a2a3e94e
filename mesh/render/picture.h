/// A picture of coloured pixels, and its bytes as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetfarm {

/// Red, green, blue, each from 0 to 1.
struct Colour {
  float red = 0;
  float green = 0;
  float blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// a where share is 0, b where it is 1.
inline Colour mixed(const Colour& a, const Colour& b, float share) {
  return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
          a.blue + (b.blue - a.blue) * share};
}

/// Rows from the top, pixels from the left, three bytes each.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Source: "Portable Network Graphics (PNG) Specification", W3C 2003: 8-bit truecolour, each row
/// filtered by difference to the one above, one zlib stream. @pre width and height are positive.
std::string png_of(const Picture& picture);

}  // namespace tetfarm
