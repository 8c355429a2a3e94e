#include "worker/extract_task.h"

#include "base/check.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/cosmetics/element_extraction.h"
#include "tasks/extract_contract.h"
#include "worker/task_cost.h"

namespace tetfarm {

void extract_task(TaskIo& io) {
  const auto given = io.given<ExtractGiven>();
  const Subdomain leaf = io.read(given.subdomain, subdomain_from_bytes);
  const TetMesh mesh =
      io.read(given.mesh, [&leaf](const std::string& bytes, const std::string& name) {
        return tet_mesh_from_bytes(bytes, leaf, name);
      });
  TF_CHECK(mesh.nodes.size() >= leaf.vertices.size());
  const SharedNodes shared = io.read(given.shared, shared_nodes_from_bytes);
  report_cost(io, extract_cost(static_cast<double>(mesh.tets.size()),
                               static_cast<double>(leaf.triangles.size())));
  io.progress().begin(WorkStage::extract);
  const ExtractedElements extracted = extract_elements(leaf, mesh, shared);
  ElementFileHead head;
  head.path = leaf.path;
  head.next_node = static_cast<std::uint32_t>(mesh.nodes.size() - leaf.vertices.size());
  io.number("tets", static_cast<double>(mesh.tets.size()));
  io.number("core_tets", static_cast<double>(extracted.core.tets));
  io.made(ExtractMade{io.publish(elements_to_bytes(head, extracted.sections, extracted.core))});
}

}  // namespace tetfarm
