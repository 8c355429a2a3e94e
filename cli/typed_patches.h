/// A mesh whose patches are what the command line says, --patch-type of export.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

class TypedPatches final : public MeshSource {
 public:
  /// Patches that are not named have the type that the file has for them.
  /// @param typed each "PATCH,...=TYPE". @throws UsageError as patches_of_options and
  /// require_patch_types do, and when the file does not name its patches.
  TypedPatches(std::unique_ptr<MeshSource> source, const std::vector<std::string>& typed);

  std::size_t size() const override { return source_->size(); }
  NumberedPart part(std::size_t i) const override { return source_->part(i); }
  CountedPart counted_part(std::size_t i) const override { return source_->counted_part(i); }
  bool knows_subdomains() const override { return source_->knows_subdomains(); }
  bool takes_threads() const override { return source_->takes_threads(); }
  std::vector<CellMark> cell_marks() const override { return source_->cell_marks(); }
  bool has_feet() const override { return source_->has_feet(); }
  std::vector<std::string> complaints() const override { return source_->complaints(); }
  std::vector<std::string> patch_names() const override { return source_->patch_names(); }
  std::vector<std::string> region_names() const override { return source_->region_names(); }
  std::vector<PatchType> patch_types() const override { return types_; }

 private:
  std::unique_ptr<MeshSource> source_;
  std::vector<PatchType> types_;
};

}  // namespace tetfarm
