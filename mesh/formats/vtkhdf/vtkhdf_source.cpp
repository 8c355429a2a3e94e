#include "mesh/formats/vtkhdf/vtkhdf_source.h"

#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/vtkhdf/read_vtkhdf.h"

namespace tetfarm {
namespace {

class VtkhdfSource : public MeshSource {
 public:
  explicit VtkhdfSource(const std::filesystem::path& path) : parts_(path) {
    if (parts_.size() != 1 && !parts_.has_node_numbers()) {
      parts_.fail("has several partitions, but no GlobalNodeId to join them by");
    }
  }
  std::size_t size() const override { return parts_.size(); }
  NumberedPart part(std::size_t i) const override { return parts_.part(i); }
  CountedPart counted_part(std::size_t i) const override { return parts_.count(i); }
  bool takes_threads() const override { return hdf5_takes_threads(); }
  std::vector<CellMark> cell_marks() const override { return parts_.cell_marks(); }
  bool has_feet() const override { return parts_.has_feet(); }
  std::vector<std::string> patch_names() const override { return parts_.patch_names(); }
  std::vector<PatchType> patch_types() const override { return parts_.patch_types(); }
  std::vector<std::string> region_names() const override { return parts_.region_names(); }

 private:
  VtkhdfParts parts_;
};

}  // namespace

std::unique_ptr<MeshSource> open_vtkhdf(const std::filesystem::path& path,
                                        const std::filesystem::path&) {
  return std::make_unique<VtkhdfSource>(path);
}

}  // namespace tetfarm
