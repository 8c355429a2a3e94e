#include "mesh/core/complaints.h"

#include <array>
#include <cstdio>

namespace tetfarm {

std::string text_of(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", number);
  return text.data();
}

std::string text_of(const Vec3& p) {
  return "(" + text_of(p.x) + ", " + text_of(p.y) + ", " + text_of(p.z) + ")";
}

}  // namespace tetfarm
