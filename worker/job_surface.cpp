#include "worker/job_surface.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.h"
#include "mesh/formats/surfaces/read_surface.h"

namespace tetfarm {

SurfaceMesh read_surface_of_job(const JobFile& job, std::string_view bytes,
                                const std::string& name) {
  SurfaceMesh surface = read_surface_bytes(bytes, name);
  if (job.scale == 1) return surface;
  for (Vec3& vertex : surface.vertices) {
    vertex *= job.scale;
    if (std::isfinite(vertex.x + vertex.y + vertex.z)) continue;
    throw InvalidInput("the scale takes a coordinate out of range", name);
  }
  return surface;
}

std::string unit_behind(const JobFile& job) { return job.unit.empty() ? "" : " m"; }

std::string lengths_text(const JobFile& job) {
  if (!job.unit.empty()) return "m, of a surface in " + job.unit;
  if (job.scale == 1) return "";
  std::array<char, 40> factor{};
  std::snprintf(factor.data(), factor.size(), "%.6g", job.scale);
  return std::string(factor.data()) + " times those of the surface's file";
}

}  // namespace tetfarm
