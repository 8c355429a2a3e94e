#include "mesh/formats/node_records.h"

#include "base/check.h"

namespace tetfarm {

namespace {

std::vector<std::vector<std::size_t>> by_patch(const std::vector<std::int32_t>& patch_of_face,
                                               std::size_t patches) {
  std::vector<std::vector<std::size_t>> faces(patches);
  for (std::size_t i = 0; i < patch_of_face.size(); ++i) {
    faces.at(static_cast<std::size_t>(patch_of_face[i])).push_back(i);
  }
  return faces;
}

}  // namespace

std::vector<std::vector<std::size_t>> faces_by_patch(const NumberedPart& part,
                                                     std::size_t patches) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  return by_patch(part.patch_of_face, patches);
}

std::vector<std::vector<std::size_t>> faces_by_patch(const ElementBlock& block,
                                                     std::size_t patches) {
  return by_patch(block.patches, patches);
}

}  // namespace tetfarm
