#include "mesh/formats/list/format_by_ending.h"

#include <algorithm>
#include <cstddef>

#include "base/check.h"

namespace tetfarm {
namespace {

bool ends_with(std::string_view name, std::string_view lower_case) {
  if (name.size() < lower_case.size()) return false;
  return std::ranges::equal(name.substr(name.size() - lower_case.size()), lower_case,
                            [](char given, char wanted) {
                              const bool is_upper = given >= 'A' && given <= 'Z';
                              return (is_upper ? given - 'A' + 'a' : given) == wanted;
                            });
}

}  // namespace

const Format* format_by_ending(std::span<const Format> formats, std::string_view name,
                               bool (*is_wanted)(const Format& format)) {
  TF_CHECK(is_wanted != nullptr);
  const Format* found = nullptr;
  std::size_t longest = 0;
  for (const Format& format : formats) {
    if (!is_wanted(format)) continue;
    for (const std::string_view ending : format.endings) {
      if (ending.size() <= longest || !ends_with(name, ending)) continue;
      longest = ending.size();
      found = &format;
    }
  }
  return found;
}

}  // namespace tetfarm
