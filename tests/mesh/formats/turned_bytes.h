/// Numbers as bytes in either order, for the binary files that tests make.
#pragma once

#include <algorithm>
#include <string>

namespace tetfarm::texts {

template <class T>
void append_number(std::string& bytes, T value, bool is_turned) {
  std::string number(reinterpret_cast<const char*>(&value), sizeof value);
  if (is_turned) std::reverse(number.begin(), number.end());
  bytes += number;
}

}  // namespace tetfarm::texts
