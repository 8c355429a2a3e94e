#include <algorithm>

#include "mesh/formats/communication/communication_table.h"

#include "base/array_index.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_complaints = 20;

class Complaints {
 public:
  void add(const CommunicationTable& table, const std::string& what) {
    if (texts_.size() < most_complaints) {
      texts_.push_back("part " + std::to_string(table.part) + ": " + what);
    }
  }
  std::vector<std::string> take() { return std::move(texts_); }

 private:
  std::vector<std::string> texts_;
};

const NeighbourNodes* nodes_with(const CommunicationTable& table, std::int32_t neighbour) {
  const auto found =
      std::find_if(table.neighbours.begin(), table.neighbours.end(),
                   [&](const NeighbourNodes& nodes) { return nodes.neighbour == neighbour; });
  return found == table.neighbours.end() ? nullptr : &*found;
}

/// The two lists of a pair: the same nodes, turned round.
void check_pair(const CommunicationTable& here, const NeighbourNodes& list,
                const CommunicationTable& there, Complaints& complaints) {
  const std::string pair = "its list with part " + std::to_string(list.neighbour);
  const NeighbourNodes* back = nodes_with(there, here.part);
  if (back == nullptr || back->local != list.remote || back->remote != list.local) {
    complaints.add(here, pair + " differs from that of the other side");
    return;
  }
  for (std::size_t i = 0; i < list.local.size(); ++i) {
    const std::size_t mine = at(list.local[i]);
    const std::size_t theirs = at(list.remote[i]);
    if (here.local2global[mine] != there.local2global[theirs]) {
      complaints.add(here, pair + " has nodes that differ");
    }
    if (here.owner[mine] != there.owner[theirs]) {
      complaints.add(here, pair + " has a node with two owners");
    }
    if (i > 0 && here.local2global[at(list.local[i - 1])] >= here.local2global[mine]) {
      complaints.add(here, pair + " is not in the order of the whole mesh");
    }
  }
}

/// Owners are the lowest part among those that have the node.
void check_owners(const CommunicationTable& table, Complaints& complaints) {
  std::vector<std::int32_t> lowest(table.owner.size(), table.part);
  for (const NeighbourNodes& list : table.neighbours) {
    for (const std::int32_t v : list.local) {
      lowest[at(v)] = std::min(lowest[at(v)], list.neighbour);
    }
  }
  if (lowest != table.owner) complaints.add(table, "an owner is not the lowest part with the node");
}

}  // namespace

std::vector<std::string> communication_complaints(
    std::int32_t parts, const std::function<CommunicationTable(std::int32_t)>& read) {
  Complaints complaints;
  std::vector<std::int32_t> mentions;
  std::int64_t owned = 0;
  std::int64_t nodes_of_mesh = 0;
  for (std::int32_t i = 0; i < parts; ++i) {
    const CommunicationTable here = read(i);
    nodes_of_mesh = here.nodes_of_mesh;
    mentions.resize(at(nodes_of_mesh));
    check_owners(here, complaints);
    owned += std::count(here.owner.begin(), here.owner.end(), i);
    for (std::size_t v = 0; v < here.local2global.size(); ++v) {
      const std::int64_t node = here.local2global[v];
      if (node < 0 || node >= nodes_of_mesh) {
        complaints.add(here, "a node is out of range");
      } else {
        ++mentions[at(node)];
      }
    }
    for (const NeighbourNodes& list : here.neighbours) {
      if (list.neighbour < 0 || list.neighbour >= parts || list.neighbour == i) {
        complaints.add(here, "a neighbour does not exist");
      } else {
        check_pair(here, list, read(list.neighbour), complaints);
      }
    }
  }
  // Each node of n parts is in n - 1 lists of each of them.
  for (std::int32_t i = 0; i < parts; ++i) {
    const CommunicationTable here = read(i);
    std::vector<std::int32_t> lists(here.local2global.size(), 1);
    for (const NeighbourNodes& list : here.neighbours) {
      for (const std::int32_t v : list.local) ++lists[at(v)];
    }
    for (std::size_t v = 0; v < lists.size(); ++v) {
      const std::int64_t node = here.local2global[v];
      if (node >= 0 && node < nodes_of_mesh && lists[v] != mentions[at(node)]) {
        complaints.add(here, "node " + std::to_string(node) + " is shared, but not in all lists");
      }
    }
    if (i == 0 && owned != nodes_of_mesh) {
      complaints.add(here, "all parts own " + std::to_string(owned) + " nodes of " +
                               std::to_string(nodes_of_mesh));
    }
  }
  return complaints.take();
}

}  // namespace tetfarm
