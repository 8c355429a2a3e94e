#include "mesh/formats/surfaces/surface_type.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/error_with_help.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 12> endings = {".stl",   ".obj",   ".off",   ".msh",
                                                      ".ply",   ".ugrid", ".su2",   ".mesh",
                                                      ".meshb", ".poly",  ".smesh", ".fro"};

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
  std::string known = "Tetfarm reads";
  for (const std::string_view read : endings) known += " " + std::string(read);
  return known + ", also as .gz";
}

}  // namespace

std::string_view surface_ending_of(const std::string& name) {
  std::string lower = in_lower_case(name);
  if (lower.ends_with(".gz")) lower.resize(lower.size() - 3);
  for (const std::string_view ending : endings) {
    if (lower.ends_with(ending)) return ending;
  }
  const std::string ending = std::filesystem::path(lower).extension().string();
  const std::string what = ending.empty() ? "unknown file type, as the name has no extension"
                                          : "unsupported file type `" + ending + "`";
  throw ErrorWithHelp(ExitCode::usage, name + ": " + what + "; " + what_to_do(name, ending), "");
}

}  // namespace tetfarm
