/// The sections that a leaf of a bar has: what the tests of extraction and passing look at.
#pragma once

#include <vector>

#include "mesh/cosmetics/element_extraction.h"
#include "mesh/cosmetics/subdomain_colouring.h"
#include "tests/mesh/cosmetics/cut_bar.h"

namespace tetfarm::trial {

inline std::uint64_t left_or_right(const Cell& cell) { return cell[0] < 8 ? 2 : 3; }

inline ExtractionOptions so_many_layers(int layers) {
  ExtractionOptions options;
  options.taken_layers = layers;
  return options;
}

/// The sections of a leaf of the bar, its core first.
inline std::vector<ElementSection> extracted(const CutBar& bar, std::uint64_t heap,
                                             const ExtractionOptions& options = {}) {
  std::vector<InterfaceNodes> leaves;
  for (const auto& [path, part] : bar.parts) leaves.push_back(interface_nodes(part.leaf));
  const CosmeticOrder order = colour_subdomains(leaves);
  const LeafMesh& part = bar.parts.at(heap);
  for (const SharedNodes& shared : order.shared) {
    if (shared.path.heap != heap) continue;
    ExtractedElements extracted = extract_elements(part.leaf, part.mesh, shared, options);
    extracted.sections.insert(extracted.sections.begin(),
                              core_section(part.leaf, part.mesh, extracted.core));
    return extracted.sections;
  }
  return {};
}

}  // namespace tetfarm::trial
