/// Tables of files that are wrong, each with all that is said of it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mesh/formats/surfaces/read_surface.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {

/// The text with `what` replaced by `with`, and the whole message then.
struct WrongText {
  std::string what;
  std::string with;
  std::string message;
};

/// The message without the folder that the file was in.
inline std::string mesh_refusal_of(const std::string& name, const std::string& bytes) {
  const std::string message = refusal_of(name, bytes);
  const std::size_t place = message.find("/" + name);
  return place == message.npos ? message : message.substr(place + 1);
}

inline std::string surface_refusal_of(const std::string& name, const std::string& bytes) {
  try {
    read_surface_bytes(bytes, name);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

template <class RefusalOf>
void expect_refusals(const std::string& name, const std::string& text,
                     const std::vector<WrongText>& table, const RefusalOf& refusal) {
  EXPECT_EQ(refusal(name, text), "") << "it is right without a change";
  for (const auto& [what, with, message] : table) {
    ASSERT_NE(text.find(what), text.npos) << what;
    EXPECT_EQ(refusal(name, changed(text, what, with)), message) << what << " -> " << with;
  }
}

}  // namespace tetfarm
