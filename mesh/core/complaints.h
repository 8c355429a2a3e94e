/// The lines that a validate function returns: the first twenty, so that a mesh broken everywhere
/// does not fill the memory with text.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/core/vec3.h"

namespace tetfarm {

class Complaints {
 public:
  static constexpr std::size_t limit = 20;

  bool full() const { return lines_.size() >= limit; }
  bool empty() const { return lines_.empty(); }
  void add(std::string line) {
    if (!full()) lines_.push_back(std::move(line));
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

/// Nine digits: enough to find the place, whatever the unit.
std::string text_of(double number);
/// "(x, y, z)".
std::string text_of(const Vec3& p);

}  // namespace tetfarm
