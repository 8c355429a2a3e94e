#include "base/check.h"
#include "mesh/artifacts/byte_stream.h"
#include "mesh/formats/communication/communication_table.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t magic = 0x314d4d4f434654;  // "TFCOMM1" and a zero

}  // namespace

std::string communication_to_bytes(const CommunicationTable& table) {
  TF_CHECK(table.owner.size() == table.local2global.size());
  ByteWriter writer;
  writer.number(magic);
  for (const std::int64_t number :
       {std::int64_t{table.part}, std::int64_t{table.parts}, table.nodes_of_mesh, table.tets,
        static_cast<std::int64_t>(table.local2global.size()),
        static_cast<std::int64_t>(table.neighbours.size()),
        static_cast<std::int64_t>(table.ghosts.size())}) {
    writer.number(number);
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
  for (const GhostTet& ghost : table.ghosts) {
    writer.number(ghost.part);
    writer.number(ghost.tet);
    for (const std::int64_t node : ghost.nodes) writer.number(node);
  }
  return writer.take();
}

CommunicationTable communication_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader reader(bytes, name);
  if (reader.number<std::uint64_t>() != magic) reader.fail("is not a communication table");
  CommunicationTable table;
  table.part = static_cast<std::int32_t>(reader.count());
  table.parts = static_cast<std::int32_t>(reader.count());
  table.nodes_of_mesh = reader.number<std::int64_t>();
  table.tets = static_cast<std::int64_t>(reader.count());
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
    GhostTet ghost;
    ghost.part = reader.number<std::int32_t>();
    ghost.tet = reader.number<std::int32_t>();
    for (std::int64_t& node : ghost.nodes) node = reader.number<std::int64_t>();
    table.ghosts.push_back(ghost);
  }
  reader.expect_end();
  return table;
}

std::string communication_to_text(const CommunicationTable& table) {
  const auto number = [](std::int64_t value) { return std::to_string(value); };
  std::string text = "part " + number(table.part) + " of " + number(table.parts) + " nodes " +
                     number(std::ssize(table.local2global)) + " of " + number(table.nodes_of_mesh) +
                     " tets " + number(table.tets) + "\n";
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
  for (const GhostTet& ghost : table.ghosts) {
    text += number(ghost.part) + " " + number(ghost.tet);
    for (const std::int64_t node : ghost.nodes) text += " " + number(node);
    text += "\n";
  }
  return text;
}

}  // namespace tetfarm
