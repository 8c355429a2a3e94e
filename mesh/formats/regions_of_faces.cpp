#include "mesh/formats/regions_of_faces.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// The smallest number first, turning the same way round.
Triangle smallest_first(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

}  // namespace

void set_regions_of_faces(NumberedPart& part) {
  TF_CHECK(part.region_of_tet.size() == part.tets.size());
  std::vector<std::pair<Triangle, std::size_t>> wanted;
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    wanted.emplace_back(smallest_first(part.faces[i]), i);
  }
  std::sort(wanted.begin(), wanted.end());
  part.region_of_face.assign(part.faces.size(), part.region);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    const Tet& tet = part.tets[t];
    for (const auto& [i, j, k] : tet_face_nodes) {
      const Triangle face = smallest_first({tet[at(i)], tet[at(j)], tet[at(k)]});
      auto found = std::lower_bound(wanted.begin(), wanted.end(), std::pair(face, std::size_t{0}));
      for (; found != wanted.end() && found->first == face; ++found) {
        part.region_of_face[found->second] = part.region_of_tet[t];
      }
    }
  }
}

}  // namespace tetfarm
