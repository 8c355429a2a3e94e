/// What looking for the nodes of the lattice in a domain cost: counted work, for measurements and
/// tests. Thin domains fill little of their box; what is visited has to be in proportion to what is
/// kept all the same (bench/lattice_cost.py).
#pragma once

#include <cstdint>

#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct LatticeCost {
  LatticeVisits visits;
  std::int64_t listed = 0;  // nodes
  std::int64_t inside = 0;  // of these, nodes in the domain
};

}  // namespace tetfarm
