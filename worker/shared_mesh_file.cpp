#include "worker/shared_mesh_file.h"

#include "base/hash.h"

namespace tetfarm {

SharedFile shared_mesh_file(const TaskIo& io) {
  const std::string what =
      io.assign().job() + '\n' + io.input_hash("surface") + '\n' + io.input_hash("numbering");
  const std::string name = "mesh." + hash128(what).hex() + ".vtkhdf";
  return {io.is_apart() ? io.scratch_path(name) : io.store().scratch_folder() / name,
          io.scratch_path("frame.vtkhdf")};
}

}  // namespace tetfarm
