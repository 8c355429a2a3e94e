#include "mesh/formats/communication/communication_table.h"

#include <algorithm>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/cell_faces.h"
#include "mesh/formats/external_sort.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// A node that another part may have too.
struct NodeMention {
  std::int64_t node = 0;
  std::int32_t part = 0;
  std::int32_t local = 0;
  bool operator<(const NodeMention& other) const {
    return node != other.node ? node < other.node : part < other.part;
  }
};

/// A node that `part` and `neighbour` have.
struct SharedNode {
  std::int32_t part = 0;
  std::int32_t neighbour = 0;
  std::int64_t node = 0;
  std::int32_t local = 0;
  std::int32_t remote = 0;
  std::int32_t owner = 0;
  bool operator<(const SharedNode& other) const {
    if (part != other.part) return part < other.part;
    return neighbour != other.neighbour ? neighbour < other.neighbour : node < other.node;
  }
};

/// A ghost of `of`.
struct GhostMention {
  std::int32_t of = 0;
  GhostCell ghost;
  std::array<Vec3, most_element_nodes> corners{};
  bool operator<(const GhostMention& other) const {
    if (of != other.of) return of < other.of;
    return ghost.part != other.ghost.part ? ghost.part < other.ghost.part
                                          : ghost.cell < other.ghost.cell;
  }
};

/// The nodes of outer faces: no other can be in two parts.
std::vector<std::int32_t> outer_nodes(const NumberedPart& part) {
  std::vector<bool> is_outer(part.nodes.size(), false);
  for (const OuterFace& face : cell_faces(part).outer) {
    for (const std::int32_t v : face.nodes) is_outer[static_cast<std::size_t>(v)] = true;
  }
  std::vector<std::int32_t> nodes;
  for (std::size_t v = 0; v < is_outer.size(); ++v) {
    if (is_outer[v]) nodes.push_back(static_cast<std::int32_t>(v));
  }
  return nodes;
}

/// Every part with every other one of those that have the node.
void share(const std::vector<NodeMention>& mentions, ExternalSort<SharedNode>& shared) {
  for (const NodeMention& here : mentions) {
    for (const NodeMention& there : mentions) {
      if (here.part == there.part) continue;
      shared.push(
          {here.part, there.part, here.node, here.local, there.local, mentions.front().part});
    }
  }
}

void find_shared_nodes(const MeshSource& source, const std::filesystem::path& folder,
                       ExternalSort<SharedNode>& shared) {
  ExternalSort<NodeMention> mentions(folder);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (const std::int32_t v : outer_nodes(part)) {
      mentions.push({global_node(part, v), static_cast<std::int32_t>(i), v});
    }
  }
  std::vector<NodeMention> same;
  for (NodeMention next; mentions.next(next);) {
    if (!same.empty() && same.front().node != next.node) {
      share(same, shared);
      same.clear();
    }
    same.push_back(next);
  }
  share(same, shared);
}

/// The part's cells that have a node of a neighbour, for each neighbour.
void mention_ghosts(const NumberedPart& part, const std::vector<SharedNode>& shared,
                    ExternalSort<GhostMention>& ghosts) {
  std::vector<std::pair<std::int32_t, std::int32_t>> neighbour_of_node;
  for (const SharedNode& node : shared) neighbour_of_node.emplace_back(node.local, node.neighbour);
  std::sort(neighbour_of_node.begin(), neighbour_of_node.end());
  std::vector<std::int32_t> neighbours;
  for_each_cell(
      part, [&](std::int32_t cell, ElementType type, std::span<const std::int32_t> nodes) {
        neighbours.clear();
        for (const std::int32_t v : nodes) {
          auto it = std::lower_bound(neighbour_of_node.begin(), neighbour_of_node.end(),
                                     std::pair(v, std::int32_t{0}));
          for (; it != neighbour_of_node.end() && it->first == v; ++it) {
            neighbours.push_back(it->second);
          }
        }
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
        for (const std::int32_t neighbour : neighbours) {
          GhostMention mention{neighbour, {part.number, cell, type, {}}, {}};
          for (std::size_t k = 0; k < nodes.size(); ++k) {
            mention.ghost.nodes[k] = global_node(part, nodes[k]);
            mention.corners[k] = part.nodes[static_cast<std::size_t>(nodes[k])];
          }
          ghosts.push(mention);
        }
      });
}

void add_shared(const std::vector<SharedNode>& shared, CommunicationTable& table) {
  for (const SharedNode& node : shared) {
    TF_CHECK(node.part == table.part && node.neighbour != table.part);
    table.owner[static_cast<std::size_t>(node.local)] = node.owner;
    if (table.neighbours.empty() || table.neighbours.back().neighbour != node.neighbour) {
      table.neighbours.push_back({node.neighbour, {}, {}});
    }
    table.neighbours.back().local.push_back(node.local);
    table.neighbours.back().remote.push_back(node.remote);
  }
}

std::string file_of_part(std::int32_t part) { return "part-" + std::to_string(part) + ".comm"; }

}  // namespace

void for_each_communication_table(const MeshSource& source, const MeshOutline& outline,
                                  const std::filesystem::path& folder,
                                  const std::function<void(const CommunicationTable&)>& visit) {
  for_each_part_with_ghosts(
      source, outline, folder,
      [&](const CommunicationTable& table, const GhostCorners&) { visit(table); });
}

void for_each_part_with_ghosts(
    const MeshSource& source, const MeshOutline& outline, const std::filesystem::path& folder,
    const std::function<void(const CommunicationTable&, const GhostCorners&)>& visit) {
  TF_CHECK(outline.parts.size() == source.size());
  ExternalSort<SharedNode> shared(folder);
  find_shared_nodes(source, folder, shared);
  // The list is gone through twice: for the ghosts of others, then for the tables.
  ExternalSort<SharedNode> shared_again(folder);
  // A record is some 300 bytes.
  constexpr std::size_t ghosts_in_memory = std::size_t{1} << 19;
  ExternalSort<GhostMention> ghosts(folder, ghosts_in_memory);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::vector<SharedNode> here = shared.take_while(
        [i](const SharedNode& node) { return node.part == static_cast<std::int32_t>(i); });
    for (const SharedNode& node : here) shared_again.push(node);
    mention_ghosts(source.part(i), here, ghosts);
  }
  for (std::size_t i = 0; i < source.size(); ++i) {
    const auto number = static_cast<std::int32_t>(i);
    CommunicationTable table;
    table.part = number;
    table.parts = static_cast<std::int32_t>(source.size());
    table.nodes_of_mesh = outline.nodes;
    table.is_of_tets_alone = outline.has_tets_alone();
    const ElementCounts elements = outline.parts[i].elements();
    for (const ElementType type : all_element_types) {
      if (is_cell(type)) table.cells[type] = elements[type];
    }
    table.local2global = source.part(i).local2global;
    table.owner.assign(table.local2global.size(), number);
    add_shared(
        shared_again.take_while([number](const SharedNode& node) { return node.part == number; }),
        table);
    const auto is_of_part = [number](const GhostMention& ghost) { return ghost.of == number; };
    GhostCorners corners;
    for (const GhostMention& mention : ghosts.take_while(is_of_part)) {
      table.ghosts.push_back(mention.ghost);
      corners.push_back(mention.corners);
    }
    visit(table, corners);
  }
}

void write_communication(const MeshSource& source, const MeshOutline& outline,
                         const std::filesystem::path& folder) {
  make_folders(folder);
  for_each_communication_table(source, outline, folder, [&](const CommunicationTable& table) {
    write_file_atomically(folder / file_of_part(table.part), communication_to_bytes(table));
  });
}

void write_communication_text(const MeshSource& source, const MeshOutline& outline,
                              const std::filesystem::path& folder) {
  make_folders(folder);
  for_each_communication_table(source, outline, folder, [&](const CommunicationTable& table) {
    write_file_atomically(folder / (file_of_part(table.part) + ".txt"),
                          communication_to_text(table));
  });
}

}  // namespace tetfarm
