/// The wanted spacing before it is put on an octree: the minimum of background, surface and
/// sources, and bounds of it in a cell.
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

namespace tetfarm {

struct SpacingDemand {
  DemandTree points;
  std::vector<SourceDemand> sources;
  /// 0: none.
  double background = 0;
  double growth = 0.3;
  /// The spacing where nobody asks for anything: the background, or the largest side of the domain.
  double ceiling = std::numeric_limits<double>::infinity();
};

/// The demand inside the cells of an octree walk. The sources that matter in a cell lie on a stack
/// above those of its parent, so that the walk allocates nothing.
class CellDemand {
 public:
  explicit CellDemand(const SpacingDemand& demand);

  struct Cell {
    Vec3 centre;
    double half_diagonal = 0;
  };
  /// What is known of the spacing in a cell.
  struct Bounds {
    double at_centre = 0;
    /// No spacing in the cell is smaller.
    double lowest = 0;
    /// The spacing is the ceiling everywhere in the cell.
    bool is_ceiling = false;
  };
  /// Enters a cell inside the one entered last.
  Bounds enter(const Cell& cell);
  void leave();
  /// The spacing at a point of the cell last entered.
  double at(const Vec3& point) const;

 private:
  SourceValue source_at(std::uint32_t source, const Vec3& point) const;

  const SpacingDemand& demand_;
  std::vector<std::uint32_t> sources_;
  std::vector<std::size_t> starts_;
  std::vector<double> floors_;
};

}  // namespace tetfarm
