/// Which files are surfaces, by their ending, and what to say of those that are not.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// ".stl", ".obj"…: the ending of a name of a file that read_surface() reads, in lower case and
/// without a .gz behind it. @throws ErrorWithHelp (usage) for any other, with what to do about
/// files of CAD.
std::string_view surface_ending_of(const std::string& name);

}  // namespace tetfarm
