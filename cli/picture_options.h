/// What the command lines of pictures have in common.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace tetfarm {

/// Width and height of "1600x1000". @throws UsageError
std::pair<int, int> picture_size(std::string_view text);

/// Whether the name ends in `ending`, such as ".png", in small or capital letters.
bool has_ending(const std::string& file, std::string_view ending);

/// @throws ErrorWithHelp when the name does not end in .png.
void require_png(const std::string& output);

}  // namespace tetfarm
