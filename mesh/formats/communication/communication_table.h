/// Which nodes the sub-domains have in common, for solvers that run on the sub-domains as they were
/// meshed: of each part its neighbours, and the nodes that both have, in the same order on both
/// sides.
///
/// Source: thesis 4.3.4.2.1, fig. 88. That nodes have owners and that ghost elements are told is
/// not the thesis's. Grammar of the files: docs/file_formats.md.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Nodes that a part and a neighbour have, by their numbers in the whole mesh, ascending.
struct NeighbourNodes {
  std::int32_t neighbour = 0;
  std::vector<std::int32_t> local;   ///< numbers in the part
  std::vector<std::int32_t> remote;  ///< of the same nodes in the neighbour
  friend bool operator==(const NeighbourNodes&, const NeighbourNodes&) = default;
};

/// A cell of another part that has a node of this one.
struct GhostCell {
  std::int32_t part = 0;  ///< whose it is
  std::int32_t cell = 0;  ///< there, counted as in part_cells.h
  ElementType type = ElementType::tet;
  std::array<std::int64_t, most_element_nodes> nodes{};  ///< in the whole mesh, in our order

  std::span<const std::int64_t> all_nodes() const { return {nodes.data(), nodes_of(type)}; }
  friend bool operator==(const GhostCell&, const GhostCell&) = default;
};

struct CommunicationTable {
  std::int32_t part = 0;
  std::int32_t parts = 0;
  std::int64_t nodes_of_mesh = 0;
  bool is_of_tets_alone = true;  ///< the whole mesh
  ElementCounts cells;           ///< of the part, by type; no faces
  std::vector<std::int64_t> local2global;
  std::vector<std::int32_t> owner;         ///< of each node: the lowest part that has it
  std::vector<NeighbourNodes> neighbours;  ///< ascending
  std::vector<GhostCell> ghosts;           ///< by part and number
  friend bool operator==(const CommunicationTable&, const CommunicationTable&) = default;
};

/// Visits the table of each part, in order. `folder` is for files that are gone afterwards.
/// @throws InvalidInput, IoError. Reads each part three times; memory of one part and its ghosts.
void for_each_communication_table(const MeshSource& source, const MeshOutline& outline,
                                  const std::filesystem::path& folder,
                                  const std::function<void(const CommunicationTable&)>& visit);

/// Where the nodes of each ghost are.
using GhostCorners = std::vector<std::array<Vec3, most_element_nodes>>;

/// The same, for who writes ghosts as elements.
void for_each_part_with_ghosts(
    const MeshSource& source, const MeshOutline& outline, const std::filesystem::path& folder,
    const std::function<void(const CommunicationTable&, const GhostCorners&)>& visit);

/// In the first version of the layout if the mesh has tets alone, else in the second.
std::string communication_to_bytes(const CommunicationTable& table);
/// @throws CorruptFile naming `name`.
CommunicationTable communication_from_bytes(std::string_view bytes, const std::string& name);
/// The same as text: a line for each node and ghost.
std::string communication_to_text(const CommunicationTable& table);

/// What is wrong with the tables of all parts together, a line each, at most twenty: lists that
/// differ between two neighbours, nodes whose owners differ or are not the lowest part, shared
/// nodes that no list has, owned nodes that are not those of the mesh. Empty when they are right.
/// `read` gives the table of any part at any time. Memory: two tables, a number for each node.
std::vector<std::string> communication_complaints(
    std::int32_t parts, const std::function<CommunicationTable(std::int32_t)>& read);

/// FOLDER/part-0.comm, … for export. @throws as above.
void write_communication(const MeshSource& source, const MeshOutline& outline,
                         const std::filesystem::path& folder);
/// The same as text: FOLDER/part-0.comm.txt, … @throws as above.
void write_communication_text(const MeshSource& source, const MeshOutline& outline,
                              const std::filesystem::path& folder);

}  // namespace tetfarm
