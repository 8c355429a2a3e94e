#include "worker/shared_mesh_file.h"

#include "base/hash.h"

namespace tetfarm {

SharedFile shared_mesh_file(const TaskIo& io, const TaskFile& surface, const TaskFile& numbering) {
  const std::string what = io.assign().job() + '\n' + surface.hash + '\n' + numbering.hash;
  const std::string name = "mesh." + hash128(what).hex() + ".vtkhdf";
  return {io.is_without_shared_store() ? io.scratch_path(name) : io.store().scratch_folder() / name,
          io.scratch_path("frame.vtkhdf")};
}

}  // namespace tetfarm
