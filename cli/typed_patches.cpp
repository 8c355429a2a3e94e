#include "cli/typed_patches.h"

#include <utility>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "worker/job_patch_types.h"

namespace tetfarm {

TypedPatches::TypedPatches(std::unique_ptr<MeshSource> source,
                           const std::vector<std::string>& typed)
    : source_(std::move(source)) {
  JobFile job;
  job.patches = patches_of_options(typed);
  const std::vector<std::string> names = source_->patch_names();
  if (names.empty()) throw UsageError("the mesh has no names of patches", "--patch-type");
  require_patch_types(job, names);
  types_ = patch_types_of(job, names);
  const std::vector<PatchType> of_file = source_->patch_types();
  for (std::size_t i = 0; i < types_.size(); ++i) {
    if (types_[i] == PatchType::unspecified) types_[i] = type_of_patch(of_file, i);
  }
}

}  // namespace tetfarm
