#include "worker/evidence.h"

#include <algorithm>
#include <cstdio>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/formats/off/write_off.h"

namespace tetfarm {
namespace {

constexpr std::size_t triangles_named = 5;

std::string coordinates(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return text;
}

SurfaceMesh surface_of(const Subdomain& subdomain) {
  SurfaceMesh surface;
  surface.vertices = subdomain.vertices;
  surface.triangles = subdomain.triangles;
  return surface;
}

std::string file_name_of(const Subdomain& subdomain, const std::string& ending) {
  return "subdomain_" + subdomain.path.text() + ending;
}

TaskRefusal::File marked_triangles(const TaskIo& io, const Subdomain& subdomain,
                                   const std::string& reason,
                                   const std::vector<std::int32_t>& triangles) {
  const std::vector<std::int64_t> numbers(triangles.begin(), triangles.end());
  return {file_name_of(subdomain, ".defects.vtp"),
          defects_as_vtp(io, surface_of(subdomain), {{"not recovered", reason, numbers}})};
}

}  // namespace

std::string defects_as_vtp(const TaskIo& io, const SurfaceMesh& surface,
                           const std::vector<SurfaceDefect>& defects) {
  const std::filesystem::path path = io.scratch_path("defects.vtp");
  write_defects_vtp(surface, defects, path.string());
  std::string bytes = read_file(path);
  remove_file(path);
  return bytes;
}

std::string describe_triangle(const Subdomain& subdomain, std::int32_t triangle) {
  const auto t = static_cast<std::size_t>(triangle);
  TF_CHECK(t < subdomain.triangles.size());
  const Origin origin = subdomain.triangle_origin[t];
  Vec3 sum;
  for (const std::int32_t v : subdomain.triangles[t]) {
    sum += subdomain.vertices[static_cast<std::size_t>(v)];
  }
  std::string whose = "the input";
  if (origin.owner == top_of_layers) whose = "the top of the layers";
  if (is_of_cut(origin)) whose = "the cut of sub-domain " + TreePath{origin.owner}.text();
  return "triangle " + std::to_string(origin.index) + " of " + whose + " at " +
         coordinates(sum / 3.0);
}

std::string subdomain_message(const Subdomain& subdomain, const std::string& reason,
                              const std::vector<std::int32_t>& triangles) {
  const std::string name = "sub-domain " + subdomain.path.text() + ": ";
  std::string message = reason.starts_with(name) ? reason : name + reason;
  const std::size_t named = std::min(triangles.size(), triangles_named);
  for (std::size_t i = 0; i < named; ++i) {
    message += "\n  " + describe_triangle(subdomain, triangles[i]);
  }
  if (triangles.size() > named) {
    message += "\n  and " + std::to_string(triangles.size() - named) + " more";
  }
  return message;
}

RefusedInput refused_subdomain(const TaskIo& io, const Subdomain& subdomain,
                               const std::string& reason,
                               const std::vector<std::int32_t>& triangles) {
  return {subdomain_message(subdomain, reason, triangles),
          {marked_triangles(io, subdomain, reason, triangles)}};
}

OwnDefect unrecovered_subdomain(const TaskIo& io, const Subdomain& subdomain,
                                const std::string& reason,
                                const std::vector<std::int32_t>& triangles) {
  const std::string surface = file_name_of(subdomain, ".off");
  const std::string message =
      subdomain_message(subdomain, reason, triangles) +
      "\nThis is a bug in Tetfarm: the surface is valid. Please send " + surface +
      " to the developers; it holds this sub-domain exactly and is enough to reproduce the "
      "failure. Another number of sub-domains may avoid it.";
  return {message,
          {marked_triangles(io, subdomain, reason, triangles),
           {surface, write_off(surface_of(subdomain))}}};
}

}  // namespace tetfarm
