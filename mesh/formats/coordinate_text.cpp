#include "mesh/formats/coordinate_text.h"

#include <array>
#include <charconv>

namespace tetfarm {
namespace {

void append(std::string& text, double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), end);
}

}  // namespace

void append_coordinates(std::string& text, const Vec3& p) {
  append(text, p.x);
  text += ' ';
  append(text, p.y);
  text += ' ';
  append(text, p.z);
  text += '\n';
}

}  // namespace tetfarm
