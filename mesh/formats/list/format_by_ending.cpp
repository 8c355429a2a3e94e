#include "mesh/formats/list/format_by_ending.h"

#include <cstddef>

#include "base/check.h"

namespace tetfarm {

const Format* format_by_ending(std::span<const Format> formats, std::string_view name,
                               bool (*is_wanted)(const Format& format)) {
  TF_CHECK(is_wanted != nullptr);
  const Format* found = nullptr;
  std::size_t longest = 0;
  for (const Format& format : formats) {
    if (!is_wanted(format)) continue;
    for (const std::string_view ending : format.endings) {
      if (ending.size() <= longest || !name.ends_with(ending)) continue;
      longest = ending.size();
      found = &format;
    }
  }
  return found;
}

}  // namespace tetfarm
