/// Takes the elements that a turn may work on out of the mesh of a leaf: the layer at its cuts,
/// and what lies round bad elements near them.
///
/// Source: thesis 4.3.4.1.2 and figure 81: the extract slave marks nodes, takes all elements at
/// them, marks their nodes, and so on, four layers in all. Here the layers behind the first are
/// looked at only, and taken where an element is below the wanted quality: nine tenths of them are
/// as good as cosmetics would make them (docs/decisions/0011). The nodes of cuts may move
/// wherever the layer at them is at hand, on all sides, so that layer is always taken, but at nodes
/// among tets of the even lattice: those stay. A tet between two cuts goes to a set that holds all
/// sharers of its nodes, so that some turn has all tets of each of these at hand.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/element_section.h"

namespace tetfarm {

struct ExtractionOptions {
  /// Layers of elements on each side of a cut that are always taken.
  int taken_layers = 1;
  /// Layers in which bad elements are sought.
  int sought_layers = 4;
  /// Layers round a bad element that are taken with it, also behind those.
  int layers_round_bad = 2;
  /// Bad are elements with a smaller dihedral angle, or a smaller height, in longest edges.
  double wanted_dihedral_deg = 30;
  double height_in_edges = 0.3;
};

struct ExtractedElements {
  /// One for each set of sharers that has elements near its nodes, sharers ascending.
  std::vector<ElementSection> sections;
  CoreElements core;
};

/// An element belongs to the set of sharers at the nearest shared node, in layers. Where nodes of
/// several sets are equally near, it belongs to the smallest set that holds all of them; where
/// there is none, to the largest of them, then the first.
/// @pre `mesh` is of `leaf` and `shared` its shared nodes. Cost: O(n), and O(m log m)
/// for m that are near cuts.
ExtractedElements extract_elements(const Subdomain& leaf, const TetMesh& mesh,
                                   const SharedNodes& shared,
                                   const ExtractionOptions& options = {});

/// The core as a section, whose one sharer is the leaf.
/// @throws Error when it is not of this mesh. Cost: O(n).
ElementSection core_section(const Subdomain& leaf, TetMesh mesh, const CoreElements& core);

}  // namespace tetfarm
