/// A complex of tets as part of a result's digest.
#pragma once

#include "mesh/core/tet_complex.h"
#include "tests/support/result_digest.h"

namespace tetfarm::test {

/// With the numbers of its tets, free ones included: they tell the order in which it was made.
inline void add_complex(ResultDigest& result, const TetComplex& complex) {
  result.add(complex.points, complex.neighbours.size(), complex.node2tet, complex.free_tets);
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (complex.nodes[t][0] >= 0) result.add(complex.nodes[t], complex.neighbours[t]);
  }
}

}  // namespace tetfarm::test
