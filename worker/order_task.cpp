#include "worker/order_task.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/element_file.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "tasks/order_contract.h"
#include "worker/task_cost.h"

namespace tetfarm {

namespace {

/// Of each region by itself: the interfaces between regions are of the input and stay, so that
/// leaves of different regions have nothing to pass to each other, though cuts may meet there.
CosmeticOrder order_by_region(std::map<std::int32_t, std::vector<InterfaceNodes>>&& region2leaves) {
  CosmeticOrder all;
  for (auto& [region, leaves] : region2leaves) {
    CosmeticOrder order = colour_subdomains(std::move(leaves));
    std::move(order.leaves.begin(), order.leaves.end(), std::back_inserter(all.leaves));
    std::move(order.shared.begin(), order.shared.end(), std::back_inserter(all.shared));
  }
  const auto by_path = [](const auto& a, const auto& b) { return a.path < b.path; };
  std::sort(all.leaves.begin(), all.leaves.end(), by_path);
  std::sort(all.shared.begin(), all.shared.end(), by_path);
  return all;
}

}  // namespace

void order_task(TaskIo& io) {
  std::map<std::int32_t, std::vector<InterfaceNodes>> region2leaves;
  double triangles = 0;
  double largest_leaf = 0;
  const auto given = io.given<OrderGiven>();
  io.progress().begin(WorkStage::order, given.subdomains.size());
  for (const auto& [heap, file] : given.subdomains) {
    io.progress().add();
    const Subdomain leaf = io.read(file, subdomain_from_bytes);
    const auto of_leaf = static_cast<double>(leaf.triangles.size());
    triangles += of_leaf;
    largest_leaf = std::max(largest_leaf, of_leaf);
    region2leaves[leaf.region].push_back(interface_nodes(leaf));
  }
  report_cost(io, order_cost(triangles, largest_leaf));
  const CosmeticOrder order = order_by_region(std::move(region2leaves));
  OrderMade made;
  std::string& text = made.order;
  std::int32_t colours = 0;
  for (const ColouredLeaf& leaf : order.leaves) {
    text += std::to_string(leaf.path.heap) + ' ' + std::to_string(leaf.colour);
    for (const TreePath& other : leaf.neighbours) text += ' ' + std::to_string(other.heap);
    text += '\n';
    colours = std::max(colours, leaf.colour + 1);
  }
  for (const SharedNodes& shared : order.shared) {
    made.shared[shared.path.heap] = io.publish(shared_nodes_to_bytes(shared));
  }
  io.made(made);
  io.number("colours", colours);
}

}  // namespace tetfarm
