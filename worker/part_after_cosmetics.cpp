#include "worker/part_after_cosmetics.h"

#include <utility>

#include "mesh/cosmetics/element_passing.h"

namespace tetfarm {
namespace {

/// The sections that the leaf shares, as the last turns left them, and its core.
std::vector<ElementSection> final_sections(const TaskIo& io, TreePath leaf,
                                           const Colours& colours) {
  const std::string heap = std::to_string(leaf.heap);
  ElementInput core(io, "core:" + heap);
  std::vector<ElementSection> sections = {core.read(0)};
  const ElementInput own(io, "elements:" + heap);
  std::map<std::uint64_t, std::vector<Sharers>> wanted;
  for (const ElementFileHead::Section& section : own.head().sections) {
    wanted[last_turn(section.sharers, colours)].push_back(section.sharers);
  }
  for (const auto& [last, list] : wanted) {
    ElementInput file(io, "elements:" + std::to_string(last));
    for (const Sharers& sharers : list) {
      const auto place = file.head().find(sharers);
      if (!place) throw Error(ExitCode::failed, "a turn left out a section that it shares");
      sections.push_back(elements_of(file.read(*place), leaf.heap));
    }
  }
  return sections;
}

}  // namespace

MeshPart part_after_cosmetics(const TaskIo& io, TreePath leaf, const Colours& colours) {
  JoinedElements joined = join_elements(final_sections(io, leaf, colours));
  MeshPart part;
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
