/// Files that are wrong in one number, each with all that is said of it.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "tests/mesh/formats/refusal_table.h"

namespace tetfarm {

template <class... Numbers>
std::string raw_bytes(Numbers... numbers) {
  std::string bytes;
  const auto add = [&bytes](const auto& number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  (add(numbers), ...);
  return bytes;
}

/// What stands at `place` instead, and the whole message then.
struct WrongBytes {
  std::size_t place;
  std::string bytes;
  std::string message;
};

template <class RefusalOf>
void expect_refusals_of_bytes(const std::string& name, const std::string& right,
                              const std::vector<WrongBytes>& table, const RefusalOf& refusal) {
  EXPECT_EQ(refusal(name, right), "") << "it is right without a change";
  for (const auto& [place, bytes, message] : table) {
    ASSERT_LE(place + bytes.size(), right.size());
    std::string wrong = right;
    wrong.replace(place, bytes.size(), bytes);
    EXPECT_EQ(refusal(name, wrong), message) << "at byte " << place;
  }
}

}  // namespace tetfarm
