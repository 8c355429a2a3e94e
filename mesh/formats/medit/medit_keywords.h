/// What says in a binary Medit file (.meshb, the GMF of libMeshb) which list follows.
#pragma once

#include <cstdint>

namespace tetfarm::medit {

enum Keyword : std::int32_t {
  dimension = 3,
  vertices = 4,
  triangles = 6,
  quadrangles = 7,
  tetrahedra = 8,
  end = 54
};

}  // namespace tetfarm::medit
