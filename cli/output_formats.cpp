#include "cli/output_formats.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "base/error_with_help.h"
#include "mesh/formats/export_mesh.h"
#include "mesh/io/edit_distance.h"
#include "mesh/io/job_formats.h"

namespace tetfarm {
namespace {

std::string formats_of_run() {
  std::string list;
  for (const std::string_view format : job_output_formats()) {
    list += (list.empty() ? "" : " and ") + std::string(format);
  }
  return list;
}

const MeshFormat* find_export_format(std::string_view name) {
  for (const MeshFormat& format : mesh_formats()) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

/// The command that writes the format: "tetfarm export out -o mesh.su2".
std::string export_command_for(const MeshFormat& format, const std::string& folder) {
  std::string command = "tetfarm export " + folder;
  if (format.ending.empty()) command += " --format " + std::string(format.name);
  return command + " -o mesh" + std::string(format.ending);
}

[[noreturn]] void refuse(const std::string& name, const std::string& folder) {
  const MeshFormat* other = find_export_format(name);
  const std::string writes = "; run writes " + formats_of_run();
  if (other == nullptr) {
    const std::string_view nearest = nearest_word(name, job_output_formats());
    throw UsageError("unknown format" + writes +
                         (nearest.empty() ? "; docs/file_formats.md lists those of `tetfarm export`"
                                          : "; did you mean " + std::string(nearest) + "?"),
                     "--format " + name);
  }
  throw ErrorWithHelp(ExitCode::usage,
                      "--format " + name + ": is written only by export" + writes + "; for " +
                          std::string(other->what) + ": `" + export_command_for(*other, folder) +
                          "`",
                      "");
}

}  // namespace

void require_formats_of_run(const std::vector<std::string>& formats, const std::string& folder) {
  const auto known = job_output_formats();
  std::set<std::string> seen;
  for (const std::string& name : formats) {
    if (std::find(known.begin(), known.end(), name) == known.end()) refuse(name, folder);
    if (!seen.insert(name).second) throw UsageError("is given twice", "--format " + name);
  }
}

}  // namespace tetfarm
