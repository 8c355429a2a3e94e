#include "mesh/inspect/defect_text.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/core/complaints.h"

namespace tetfarm {

std::string triangle_text(const SurfaceMesh& surface, std::int32_t triangle) {
  TF_CHECK(triangle >= 0 && static_cast<std::size_t>(triangle) < surface.triangles.size());
  std::string text = "triangle " + std::to_string(triangle);
  for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(triangle)]) {
    text += " " + text_of(surface.vertices[static_cast<std::size_t>(v)]);
  }
  return text;
}

std::string with_places(const std::string& what, const std::vector<std::string>& places,
                        std::size_t count) {
  TF_CHECK(places.size() <= count);
  std::string text = what;
  const std::size_t named = std::min(places.size(), places_named);
  for (std::size_t i = 0; i < named; ++i) text += (i == 0 ? ": " : "; ") + places[i];
  if (count > named) text += "; and " + std::to_string(count - named) + " more";
  return text;
}

SurfaceDefect defect_of_triangles(const SurfaceMesh& surface, const std::string& kind,
                                  const std::string& what,
                                  const std::vector<std::int32_t>& triangles) {
  TF_CHECK(std::is_sorted(triangles.begin(), triangles.end()));
  std::vector<std::string> places;
  for (std::size_t i = 0; i < std::min(triangles.size(), places_named); ++i) {
    places.push_back(triangle_text(surface, triangles[i]));
  }
  return {kind, with_places(what, places, triangles.size()), {triangles.begin(), triangles.end()}};
}

std::string defects_text(const std::vector<SurfaceDefect>& defects) {
  std::string message = "the surface cannot be meshed";
  for (const SurfaceDefect& defect : defects) {
    message += "\n  " + defect.kind + ": " + defect.message;
  }
  return message;
}

}  // namespace tetfarm
