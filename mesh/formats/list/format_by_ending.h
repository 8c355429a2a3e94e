/// Which format a name tells.
#pragma once

#include <span>
#include <string_view>

#include "mesh/formats/list/format.h"

namespace tetfarm {

/// Of those that are wanted the one with the longest ending that `name` ends with, in upper or
/// lower case; null without any. @pre `is_wanted` is not null. Cost: O(formats).
const Format* format_by_ending(std::span<const Format> formats, std::string_view name,
                               bool (*is_wanted)(const Format& format));

}  // namespace tetfarm
