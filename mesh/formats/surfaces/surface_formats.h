/// The formats of surfaces, from the list of all formats: which files are surfaces, by their
/// ending, and what to say of those that are not.
#pragma once

#include <span>
#include <string>

#include "mesh/formats/list/format.h"

namespace tetfarm {

/// Those that are read or written. The functions for meshes are left out, and with them what only
/// meshes need.
std::span<const Format> surface_formats();

/// What reads a file of that name: by its ending, in upper or lower case, with or without a .gz
/// behind it. @throws ErrorWithHelp (usage) for any other, with what to do about files of CAD.
const Format& surface_format_of(const std::string& name);

/// ".stl .obj …": the endings of surfaces that are read, for messages; .ugrid stands for .b8.ugrid
/// too.
std::string readable_surfaces();
/// ".stl (with patches) or .off (without)": of those that are written.
std::string writable_surfaces();

}  // namespace tetfarm
