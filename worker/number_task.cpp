#include "worker/number_task.h"

#include "mesh/assemble/global_numbering.h"
#include "mesh/io/artifact_file.h"

namespace tetfarm {

void number_task(TaskIo& io) {
  const SurfaceMesh surface = surface_from_bytes(io.read("surface"), "surface");
  io.publish("numbering", numbering_to_text(number_globally(surface, io.parameter("table"))));
}

}  // namespace tetfarm
