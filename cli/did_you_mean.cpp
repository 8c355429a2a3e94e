#include "cli/did_you_mean.h"

#include "base/edit_distance.h"

namespace tetfarm {

std::string in_ticks(std::string_view word) { return "`" + std::string(word) + "`"; }

std::string did_you_mean(const std::string& word, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearest_word(word, known);
  return nearest.empty() ? "" : "; did you mean " + in_ticks(nearest) + "?";
}

}  // namespace tetfarm
