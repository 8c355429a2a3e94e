/// The wanted spacing before it is put on an octree: the minimum of background, surface, sources
/// and triangles, and bounds of it in a cell.
///
/// Every demand grows by no more than `growth` per unit length (a source whose parameters vary: its
/// floor), so its value at a cell's centre bounds it in the cell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/spacing/demand_tree.h"
#include "mesh/spacing/sources.h"
#include "mesh/spacing/triangle_demands.h"

namespace tetfarm {

struct SpacingDemand {
  DemandTree points;
  std::vector<SourceDemand> sources;
  /// 0: none.
  double background = 0;
  double growth = 0.3;
  /// The spacing where nobody asks for anything: the background, or the largest side of the domain.
  double ceiling = std::numeric_limits<double>::infinity();
  /// None grows faster than `growth`.
  TriangleDemandTree triangles = {};

  /// Whether the minimum of the demands may grow faster than `growth`.
  bool grows_too_fast() const;
};

/// The demand inside the cells of an octree walk. What matters in a cell lies on stacks above that
/// of its parent, so that the walk allocates nothing.
class CellDemand {
 public:
  explicit CellDemand(const SpacingDemand& demand);

  struct Cell {
    Vec3 centre;
    double half_diagonal = 0;
  };
  /// Enters a cell inside the one entered last.
  void enter(const Cell& cell);
  void leave();

  /// What is known of the spacing in a cell.
  struct Bounds {
    double at_centre = 0;
    /// No spacing in the cell is smaller.
    double lowest = 0;
    /// The spacing is the ceiling everywhere in the cell.
    bool is_ceiling = false;
  };
  /// Of the cell last entered. A `lowest` of `enough` and more may be smaller than need be.
  Bounds bounds(double enough) const;
  /// The spacing at a point of the cell last entered.
  double at(const Vec3& point) const;

  /// How many demands have been looked at, those of sources by what they cost: what the walk has
  /// taken so far, in units of some nanoseconds.
  std::uint64_t looked_at() const { return looked_at_ + demand_.triangles.looked_at(); }

 private:
  std::span<const std::uint32_t> sources_here() const;
  void note_look() const;

  const SpacingDemand& demand_;
  DemandsInCell points_;
  std::vector<std::uint32_t> sources_;
  std::vector<std::size_t> starts_;
  std::vector<Cell> cells_;
  bool grows_too_fast_;
  mutable std::uint64_t looked_at_ = 0;
};

}  // namespace tetfarm
