/// A vertex put elsewhere on the input for the time being, and then left there or put back.
#pragma once

#include <cstdint>

#include "mesh/remeshing/surface_replacement.h"

namespace tetfarm {

/// Where a vertex lies, and what of the input is there.
struct VertexPlace {
  Vec3 at;
  std::int32_t foot = -1;
};

/// Puts it there; the work's replacement is that of its triangles by themselves as they are then.
/// Where it was. @pre it is no corner.
VertexPlace try_vertex(RemeshingWork& work, std::int32_t v, const VertexPlace& to);

/// Leaves it where it was put if that is wanted and may be, else puts it back. Whether it stays.
bool keep_or_put_back(RemeshingWork& work, std::int32_t v, const VertexPlace& before,
                      bool is_wanted);

}  // namespace tetfarm
