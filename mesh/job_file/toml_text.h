/// Values as TOML has them, for canonical job files.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// A basic string in quotes.
std::string quoted_toml(std::string_view text);

/// As few digits as give the same double again.
std::string toml_number(double value);

}  // namespace tetfarm
