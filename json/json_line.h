/// JSON as the program prints it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tetfarm {

/// On one line; bytes that are no UTF-8, which JSON cannot have, become U+FFFD.
std::string json_line(const nlohmann::ordered_json& json);

}  // namespace tetfarm
