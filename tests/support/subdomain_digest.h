/// A sub-domain as part of a result's digest.
#pragma once

#include "mesh/core/subdomain.h"
#include "tests/support/result_digest.h"

namespace tetfarm::test {

inline void add_subdomain(ResultDigest& result, const Subdomain& subdomain) {
  result.add(subdomain.path.heap, subdomain.vertices, subdomain.triangles, subdomain.region,
             subdomain.sides);
  for (const auto* origins : {&subdomain.node_origin, &subdomain.triangle_origin}) {
    result.add(origins->size());
    for (const Origin& origin : *origins) result.add(origin.owner, origin.index);
  }
}

}  // namespace tetfarm::test
