/// A finished mesh with other numbers of its nodes and another order of its cells, for solvers.
///
/// Source: thesis 4.3.4.1.1: surface, then interfaces, then the inside, sub-domain by sub-domain,
/// so that pockets of the mesh have consecutive numbers. Within a sub-domain the thesis leaves the
/// order to the mesher; here it is along the Hilbert curve, or by reverse Cuthill-McKee.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/formats/mesh_source.h"
#include "mesh/partition/node_order.h"

namespace tetfarm {

enum class NodeNumbering {
  hilbert,  ///< nodes of the surface, of borders between parts, of the inside; each along the curve
  reverse_cuthill_mckee,  ///< part after part, all nodes that the part is the first to have
};

/// The parts of `source`, each with its nodes by rising new number, and its cells of each type
/// region by region by the lowest of their nodes, then the next. Marks go with their
/// cells, and feet with their nodes, by the new numbers.
class RenumberedMesh : public MeshSource {
 public:
  /// Reads each part three times. The same mesh gets the same numbers.
  /// @throws as outline_of, and so does `part` where a foot is no node. Cost: O(n log n). Memory:
  /// one part, two bits a node, 24 bytes a node that several parts have or that is a foot. `part`
  /// costs an ordering of the part each time.
  RenumberedMesh(std::unique_ptr<MeshSource> source, NodeNumbering numbering);

  std::size_t size() const override { return source_->size(); }
  NumberedPart part(std::size_t i) const override;
  /// What is counted of a part does not depend on how its nodes are numbered.
  CountedPart counted_part(std::size_t i) const override { return source_->counted_part(i); }
  bool takes_threads() const override { return source_->takes_threads(); }
  bool knows_subdomains() const override { return source_->knows_subdomains(); }
  std::vector<CellMark> cell_marks() const override { return source_->cell_marks(); }
  bool has_feet() const override { return source_->has_feet(); }
  std::vector<std::string> patch_names() const override { return source_->patch_names(); }
  std::vector<PatchType> patch_types() const override { return source_->patch_types(); }
  std::vector<std::string> region_names() const override { return source_->region_names(); }

 private:
  enum Kind : std::uint8_t { surface, border, inside };
  static constexpr std::size_t kinds = 3;

  /// A node of several parts, or one that other nodes have as their foot, whichever part they are
  /// of.
  struct SharedNode {
    std::int64_t old_number = 0;
    std::int64_t number = -1;
    std::uint32_t owner = 0;  ///< the first part that has it
    Kind kind = border;
  };
  /// The nodes of a part that it is the first to have, of each kind in the new order.
  using OwnNodes = std::array<std::vector<std::int32_t>, kinds>;

  void find_shared_nodes();
  void number_nodes();
  NodeFeet with_new_numbers(NodeFeet feet, std::size_t part) const;
  /// Its place in shared_; nothing when one part alone has it, and it is no foot.
  std::optional<std::size_t> shared(std::int64_t old_number) const;
  OwnNodes own_nodes(const NumberedPart& part, std::size_t index) const;
  std::vector<std::int32_t> order_of(const NumberedPart& part) const;

  std::unique_ptr<MeshSource> source_;
  NodeNumbering numbering_;
  std::vector<SharedNode> shared_;                      // by old number
  std::vector<std::array<std::int64_t, kinds>> first_;  // number of each part's first of a kind
};

/// Within the parts, by the numbers that nodes have there: differences of neighbours.
NumberSpans spans_of(const MeshSource& source);

}  // namespace tetfarm
