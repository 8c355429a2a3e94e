#include "mesh/formats/surfaces/surface_formats.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/error_with_help.h"
#include "mesh/formats/list/all_formats.h"
#include "mesh/formats/list/format_by_ending.h"

namespace tetfarm {
namespace {

constexpr bool is_of_surfaces(const Format& format) {
  return format.read_surface != nullptr || format.write_surface != nullptr;
}

/// Worked out by the compiler: nothing that only meshes need has to be linked.
constexpr auto formats = [] {
  std::array<Format, std::ranges::count_if(all_formats, is_of_surfaces)> found;
  std::size_t next = 0;
  for (const Format& format : all_formats) {
    if (!is_of_surfaces(format)) continue;
    found[next++] = {format,
                     {.read_surface = format.read_surface, .write_surface = format.write_surface}};
  }
  return found;
}();

/// What a surface mesher has to triangulate first.
constexpr std::array<std::string_view, 6> cad_endings = {".stp",  ".step", ".igs",
                                                         ".iges", ".brep", ".geo"};

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

std::string what_to_do(const std::string& name, const std::string& ending) {
  if (std::find(cad_endings.begin(), cad_endings.end(), ending) != cad_endings.end()) {
    const std::string mesh = std::filesystem::path(name).replace_extension(".msh").string();
    return "mesh a CAD file first: `gmsh -2 " + name + " -o " + mesh + "`";
  }
  return "Tetfarm reads " + readable_surfaces() + ", also as .gz";
}

std::vector<std::string_view> read_endings() {
  std::vector<std::string_view> all;
  for (const Format& format : formats) {
    for (const std::string_view ending : format.endings) {
      if (!ending.empty() && format.read_surface != nullptr) all.push_back(ending);
    }
  }
  return all;
}

}  // namespace

std::span<const Format> surface_formats() { return formats; }

std::string readable_surfaces() {
  const std::vector<std::string_view> all = read_endings();
  std::string list;
  for (const std::string_view ending : all) {
    const bool is_in_another = std::ranges::any_of(
        all, [&](std::string_view other) { return other != ending && ending.ends_with(other); });
    if (!is_in_another) list += (list.empty() ? "" : " ") + std::string(ending);
  }
  return list;
}

std::string writable_surfaces() {
  std::string list;
  for (const Format& format : formats) {
    if (format.write_surface == nullptr) continue;
    list += (list.empty() ? "" : " or ") + std::string(format.endings[0]) +
            (format.has_patch_names ? " (with patches)" : " (without)");
  }
  return list;
}

const Format& surface_format_of(const std::string& name) {
  std::string lower = in_lower_case(name);
  if (lower.ends_with(".gz")) lower.resize(lower.size() - 3);
  const Format* format = format_by_ending(
      formats, lower, [](const Format& known) { return known.read_surface != nullptr; });
  if (format != nullptr) return *format;
  const std::string ending = std::filesystem::path(lower).extension().string();
  const std::string what = ending.empty() ? "unknown file type, as the name has no extension"
                                          : "unsupported file type `" + ending + "`";
  throw ErrorWithHelp(ExitCode::usage, name + ": " + what + "; " + what_to_do(name, ending), "");
}

}  // namespace tetfarm
