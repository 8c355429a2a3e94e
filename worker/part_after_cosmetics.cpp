#include "worker/part_after_cosmetics.h"

#include <algorithm>
#include <map>
#include <utility>

#include "mesh/artifacts/artifact_file.h"
#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/element_passing.h"

namespace tetfarm {
namespace {

/// Adds the origins of the nodes of tets that are not the leaf's.
void add_nodes_of_others(const ElementSection& section, TreePath leaf, std::vector<Origin>& nodes) {
  std::vector<bool> is_of_others(section.nodes.size(), false);
  for (std::size_t t = 0; t < section.tets.size(); ++t) {
    if (section.sharers[section.tet_owner[t]] == leaf.heap) continue;
    for (const std::int32_t v : section.tets[t]) is_of_others[static_cast<std::size_t>(v)] = true;
  }
  for (std::size_t v = 0; v < is_of_others.size(); ++v) {
    if (is_of_others[v]) nodes.push_back(section.node_origin[v]);
  }
}

ElementSection core_as_meshed(const TaskIo& io, const WriteGiven& given, TreePath path) {
  const Subdomain leaf = io.read(given.subdomain, subdomain_from_bytes);
  TetMesh mesh = io.read(given.mesh, [&leaf](const std::string& bytes, const std::string& name) {
    return tet_mesh_from_bytes(bytes, leaf, name);
  });
  ElementInput extracted(io, file_of_leaf(given.cores, path.heap));
  return core_section(leaf, std::move(mesh), extracted.read_core());
}

/// The sections that the leaf shares, as the last turns left them, and its core; what is not its
/// own is left out, but for the origins of nodes there.
std::vector<ElementSection> final_sections(const TaskIo& io, const WriteGiven& given, TreePath leaf,
                                           const Colours& colours,
                                           std::vector<Origin>& nodes_of_others) {
  std::vector<ElementSection> sections = {core_as_meshed(io, given, leaf)};
  const ElementInput own(io, file_of_leaf(given.elements, leaf.heap));
  std::map<std::uint64_t, std::vector<Sharers>> wanted;
  for (const ElementFileHead::Section& section : own.head().sections) {
    wanted[last_turn(section.sharers, colours)].push_back(section.sharers);
  }
  for (const auto& [last, list] : wanted) {
    ElementInput file(io, file_of_leaf(given.elements, last));
    for (const Sharers& sharers : list) {
      const auto place = file.head().find(sharers);
      if (!place) throw Error(ExitCode::failed, "a turn left out a section that it shares");
      const ElementSection section = file.read(*place);
      add_nodes_of_others(section, leaf, nodes_of_others);
      sections.push_back(elements_of(section, leaf.heap));
    }
  }
  return sections;
}

}  // namespace

MeshPart part_after_cosmetics(const TaskIo& io, const WriteGiven& given, TreePath leaf,
                              const Colours& colours) {
  std::vector<Origin> nodes_of_others;
  JoinedElements joined = join_elements(final_sections(io, given, leaf, colours, nodes_of_others));
  MeshPart part;
  std::sort(nodes_of_others.begin(), nodes_of_others.end());
  // Both ascend.
  auto other = nodes_of_others.begin();
  for (const Origin& origin : joined.node_origin) {
    while (other != nodes_of_others.end() && *other < origin) ++other;
    part.is_on_cut.push_back(other != nodes_of_others.end() && *other == origin);
  }
  part.subdomain.path = leaf;
  part.subdomain.vertices = joined.nodes;
  part.subdomain.node_origin = std::move(joined.node_origin);
  part.subdomain.triangles = std::move(joined.triangles);
  for (const std::uint32_t index : joined.triangle_index) {
    part.subdomain.triangle_origin.push_back({0, index});
  }
  part.mesh.boundary_nodes = static_cast<std::int32_t>(joined.nodes.size());
  part.mesh.nodes = std::move(joined.nodes);
  part.mesh.tets = std::move(joined.tets);
  return part;
}

}  // namespace tetfarm
