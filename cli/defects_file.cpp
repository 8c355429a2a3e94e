#include "cli/defects_file.h"

#include <filesystem>

#include "base/error.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/inspect/write_defects_vtp.h"

namespace tetfarm {
namespace {

std::string defects_file(const std::string& asked, const std::string& job) {
  const std::string name = job + ".defects.vtp";
  if (asked.empty()) return name;
  return std::filesystem::is_directory(asked) ? (std::filesystem::path(asked) / name).string()
                                              : asked;
}

}  // namespace

void require_no_defects(const SurfaceMesh& surface, const SurfaceReport& report,
                        const JobInput& input, const std::string& asked) {
  if (report.defects.empty()) return;
  const std::string file = defects_file(asked, input.job.name);
  write_defects_vtp(surface, report.defects, file);
  throw Error(ExitCode::bad_geometry,
              input.path + ": " + defects_text(report.defects) + "\n  see " + file);
}

}  // namespace tetfarm
