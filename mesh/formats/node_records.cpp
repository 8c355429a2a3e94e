#include "mesh/formats/node_records.h"

#include "base/check.h"

namespace tetfarm {

std::vector<std::vector<std::size_t>> faces_by_patch(const NumberedPart& part,
                                                     std::size_t patches) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  std::vector<std::vector<std::size_t>> faces(patches);
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    faces.at(static_cast<std::size_t>(part.patch_of_face[i])).push_back(i);
  }
  return faces;
}

}  // namespace tetfarm
