/// What was probably meant by a word that nobody knows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tetfarm {

/// "`word`"
std::string in_ticks(std::string_view word);

/// "; did you mean `run`?", by the nearest of the known words; "" when none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string_view>& known);

}  // namespace tetfarm
