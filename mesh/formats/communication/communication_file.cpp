#include <optional>

#include "base/check.h"
#include "mesh/artifacts/byte_stream.h"
#include "mesh/formats/communication/communication_table.h"

namespace tetfarm {
namespace {

// "TFCOMM1" and a zero; of meshes of tets alone.
constexpr std::uint64_t magic_of_tets = 0x314d4d4f434654;
// "TFCOMM2" and a zero.
constexpr std::uint64_t magic_of_all = 0x324d4d4f434654;

/// VTK's, which says how many nodes follow too.
std::int32_t code(ElementType type) { return code_of(ElementCodes::vtk, type); }

void write_ghost(const GhostCell& ghost, bool has_type, ByteWriter& writer) {
  writer.number(ghost.part);
  writer.number(ghost.cell);
  if (has_type) writer.number(code(ghost.type));
  for (const std::int64_t node : ghost.all_nodes()) writer.number(node);
}

GhostCell read_ghost(ByteReader& reader, bool has_type) {
  GhostCell ghost;
  ghost.part = reader.number<std::int32_t>();
  ghost.cell = reader.number<std::int32_t>();
  if (has_type) {
    const std::optional<ElementType> type =
        type_of(ElementCodes::vtk, reader.number<std::int32_t>());
    if (!type || !is_cell(*type)) reader.fail("has a ghost of an unknown type");
    ghost.type = *type;
  }
  for (std::size_t k = 0; k < nodes_of(ghost.type); ++k) {
    ghost.nodes[k] = reader.number<std::int64_t>();
  }
  return ghost;
}

/// The types whose cells are counted, in their order.
std::vector<ElementType> counted_types(bool is_of_tets_alone) {
  std::vector<ElementType> types = {ElementType::tet};
  if (is_of_tets_alone) return types;
  types.insert(types.end(), cell_block_types.begin(), cell_block_types.end());
  return types;
}

}  // namespace

std::string communication_to_bytes(const CommunicationTable& table) {
  TF_CHECK(table.owner.size() == table.local2global.size());
  ByteWriter writer;
  writer.number(table.is_of_tets_alone ? magic_of_tets : magic_of_all);
  for (const std::int64_t number :
       {std::int64_t{table.part}, std::int64_t{table.parts}, table.nodes_of_mesh}) {
    writer.number(number);
  }
  for (const ElementType type : counted_types(table.is_of_tets_alone)) {
    writer.number(table.cells[type]);
  }
  for (const std::size_t count :
       {table.local2global.size(), table.neighbours.size(), table.ghosts.size()}) {
    writer.number(static_cast<std::int64_t>(count));
  }
  writer.array(table.local2global);
  writer.array(table.owner);
  for (const NeighbourNodes& neighbour : table.neighbours) {
    TF_CHECK(neighbour.local.size() == neighbour.remote.size());
    writer.number(std::int64_t{neighbour.neighbour});
    writer.number(static_cast<std::int64_t>(neighbour.local.size()));
    writer.array(neighbour.local);
    writer.array(neighbour.remote);
  }
  for (const GhostCell& ghost : table.ghosts) {
    TF_CHECK(!table.is_of_tets_alone || ghost.type == ElementType::tet);
    write_ghost(ghost, !table.is_of_tets_alone, writer);
  }
  return writer.take();
}

CommunicationTable communication_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  const auto magic = reader.number<std::uint64_t>();
  if (magic != magic_of_tets && magic != magic_of_all) reader.fail("is not a communication table");
  CommunicationTable table;
  table.is_of_tets_alone = magic == magic_of_tets;
  table.part = static_cast<std::int32_t>(reader.count());
  table.parts = static_cast<std::int32_t>(reader.count());
  table.nodes_of_mesh = reader.number<std::int64_t>();
  for (const ElementType type : counted_types(table.is_of_tets_alone)) {
    table.cells[type] = static_cast<std::int64_t>(reader.count());
  }
  const std::size_t nodes = reader.count();
  const std::size_t neighbours = reader.count();
  const std::size_t ghosts = reader.count();
  table.local2global = reader.array<std::int64_t>(nodes);
  table.owner = reader.array<std::int32_t>(nodes);
  for (std::size_t i = 0; i < neighbours; ++i) {
    NeighbourNodes neighbour;
    neighbour.neighbour = static_cast<std::int32_t>(reader.count());
    const std::size_t count = reader.count();
    neighbour.local = reader.array<std::int32_t>(count);
    neighbour.remote = reader.array<std::int32_t>(count);
    for (const std::int32_t v : neighbour.local) {
      if (v < 0 || static_cast<std::size_t>(v) >= nodes) reader.fail("has a node out of range");
    }
    table.neighbours.push_back(std::move(neighbour));
  }
  for (std::size_t i = 0; i < ghosts; ++i) {
    table.ghosts.push_back(read_ghost(reader, !table.is_of_tets_alone));
  }
  reader.expect_end();
  return table;
}

std::string communication_to_text(const CommunicationTable& table) {
  const auto number = [](std::int64_t value) { return std::to_string(value); };
  std::string text = "part " + number(table.part) + " of " + number(table.parts) + " nodes " +
                     number(std::ssize(table.local2global)) + " of " + number(table.nodes_of_mesh);
  for (const ElementType type : counted_types(table.is_of_tets_alone)) {
    text += " " + std::string(element(type).plural) + " " + number(table.cells[type]);
  }
  text += "\n";
  for (std::size_t v = 0; v < table.local2global.size(); ++v) {
    text += "node " + number(static_cast<std::int64_t>(v)) + " " + number(table.local2global[v]) +
            " " + number(table.owner[v]) + "\n";
  }
  for (const NeighbourNodes& neighbour : table.neighbours) {
    text += "neighbour " + number(neighbour.neighbour) + " " + number(std::ssize(neighbour.local)) +
            "\n";
    for (std::size_t i = 0; i < neighbour.local.size(); ++i) {
      text += number(neighbour.local[i]) + " " + number(neighbour.remote[i]) + "\n";
    }
  }
  text += "ghosts " + number(std::ssize(table.ghosts)) + "\n";
  for (const GhostCell& ghost : table.ghosts) {
    text += number(ghost.part) + " " + number(ghost.cell);
    if (!table.is_of_tets_alone) text += " " + std::string(element(ghost.type).name);
    for (const std::int64_t node : ghost.all_nodes()) text += " " + number(node);
    text += "\n";
  }
  return text;
}

}  // namespace tetfarm
