#include "worker/shared_mesh_file.h"

#include "base/hash.h"

namespace tetfarm {

SharedFile shared_mesh_file(const TaskIo& io) {
  const std::string what =
      io.assign().job() + '\n' + io.input_hash("surface") + '\n' + io.input_hash("numbering");
  return {io.store().scratch_folder() / ("mesh." + hash128(what).hex() + ".vtkhdf"),
          io.store().scratch_path("frame.vtkhdf")};
}

}  // namespace tetfarm
