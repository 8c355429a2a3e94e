/// Brings the elements near cuts that neighbours have together, and gives them back.
///
/// Source: thesis 4.3.4.1.2 and figure 85: two layers of a neighbour that had no turn yet are
/// worked on, four of one that had. Here they are taken out once, before any turn
/// (element_extraction.h), and lie in sections by who shares the nearest cut
/// (mesh/core/element_section.h). Not the thesis's: an element stays with the sub-domain in whose
/// space it lies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/core/element_section.h"

namespace tetfarm {

/// Where an element of a joined mesh belongs.
struct ElementHome {
  std::uint32_t section = 0;
  std::uint8_t owner = 0;  ///< a place among the section's sharers

  friend bool operator==(const ElementHome&, const ElementHome&) = default;
};

/// Sections as one mesh. Nodes ascend by origin.
struct JoinedElements {
  std::vector<Vec3> nodes;
  std::vector<Origin> node_origin;
  std::vector<Tet> tets;
  std::vector<ElementHome> tet_home;
  std::vector<Triangle> triangles;  ///< of the input surface
  std::vector<std::uint32_t> triangle_index;
};

/// Tets and triangles in the order of the sections.
/// @pre a node of several sections has the same place in all. Cost: O(n log n).
JoinedElements join_elements(std::vector<ElementSection> sections);

/// The reverse: each tet to its home, each triangle to that of its tet; nodes that no tet has are
/// left out. @pre every triangle is a face of a tet. Cost: O(n log n).
std::vector<ElementSection> share_out_elements(const JoinedElements& joined,
                                               std::span<const Sharers> sharers);

/// For each triangle the tet that has it as a face; tets.size() where none has.
/// @pre nodes are below `nodes`. Cost: O(n log n).
std::vector<std::size_t> tets_of_triangles(std::size_t nodes, const std::vector<Tet>& tets,
                                           const std::vector<Triangle>& triangles);

/// The pieces that several leaves have of one section as the whole of it.
/// @pre all have the same sharers, and there is one at least.
ElementSection join_pieces(std::vector<ElementSection> pieces);

/// What one sharer owns of a section: its tets, their triangles and nodes.
ElementSection elements_of(const ElementSection& section, std::uint64_t owner);

/// For each tet of the joined mesh, how many layers it is away from the sub-domain `self`: 0 for
/// its own, 1 for those with a node of its own tets, and so on up to `most`; most + 1 beyond.
std::vector<int> layers_from(const JoinedElements& joined, std::span<const Sharers> sharers,
                             std::uint64_t self, int most);

}  // namespace tetfarm
