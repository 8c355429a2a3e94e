#include "worker/order_task.h"

#include <algorithm>

#include "mesh/cosmetics/subdomain_colouring.h"
#include "mesh/io/artifact_file.h"
#include "mesh/io/element_file.h"

namespace tetfarm {

void order_task(TaskIo& io) {
  std::vector<InterfaceNodes> leaves;
  for (const wire::Artifact& input : io.assign().inputs()) {
    io.progress("order", std::ssize(leaves));
    leaves.push_back(interface_nodes(subdomain_from_bytes(io.read(input.name()), input.name())));
  }
  const CosmeticOrder order = colour_subdomains(std::move(leaves));
  std::string text;
  std::int32_t colours = 0;
  for (const ColouredLeaf& leaf : order.leaves) {
    text += std::to_string(leaf.path.heap) + ' ' + std::to_string(leaf.colour);
    for (const TreePath& other : leaf.neighbours) text += ' ' + std::to_string(other.heap);
    text += '\n';
    colours = std::max(colours, leaf.colour + 1);
  }
  for (const SharedNodes& shared : order.shared) {
    io.publish("shared:" + std::to_string(shared.path.heap), shared_nodes_to_bytes(shared));
  }
  io.text("order", text);
  io.number("colours", colours);
}

}  // namespace tetfarm
