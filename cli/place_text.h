/// A place in space, as the program prints it.
#pragma once

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// "(1, 2.5, -3)", with 6 digits.
inline std::string place_text(const Vec3& p) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return text.data();
}

inline nlohmann::ordered_json place_json(const Vec3& p) {
  return nlohmann::ordered_json::array({p.x, p.y, p.z});
}

}  // namespace tetfarm
