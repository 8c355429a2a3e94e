#include "worker/extract_task.h"

#include "base/check.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/cosmetics/element_extraction.h"
#include "worker/task_cost.h"

namespace tetfarm {

void extract_task(TaskIo& io) {
  const Subdomain leaf = subdomain_from_bytes(io.read("subdomain"), "subdomain");
  const TetMesh mesh = tet_mesh_from_bytes(io.read("mesh"), leaf, "mesh");
  TF_CHECK(mesh.nodes.size() >= leaf.vertices.size());
  const SharedNodes shared = shared_nodes_from_bytes(io.read("shared"), "shared");
  report_cost(io, extract_cost(static_cast<double>(mesh.tets.size()),
                               static_cast<double>(leaf.triangles.size())));
  io.progress().begin(WorkStage::extract);
  const ExtractedElements extracted = extract_elements(leaf, mesh, shared);
  ElementFileHead head;
  head.path = leaf.path;
  head.next_node = static_cast<std::uint32_t>(mesh.nodes.size() - leaf.vertices.size());
  io.number("tets", static_cast<double>(mesh.tets.size()));
  io.number("core_tets", static_cast<double>(extracted.core.tets));
  io.publish("elements", elements_to_bytes(head, extracted.sections, extracted.core));
}

}  // namespace tetfarm
