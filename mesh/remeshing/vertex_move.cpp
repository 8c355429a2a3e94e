#include "mesh/remeshing/vertex_move.h"

#include <utility>

#include "base/check.h"

namespace tetfarm {

VertexPlace try_vertex(RemeshingWork& work, std::int32_t v, const VertexPlace& to) {
  ChangingSurface& surface = work.surface;
  SurfaceVertex& vertex = surface.vertex(v);
  TF_CHECK(vertex.kind != VertexKind::corner);
  const VertexPlace before{surface.at(v), std::exchange(vertex.foot, to.foot)};
  surface.try_at(v, to.at);
  work.replacement.clear();
  work.replacement.removed.assign(surface.ring(v).begin(), surface.ring(v).end());
  work.replacement.fills_hole = vertex.kind == VertexKind::smooth;
  for (const std::int32_t t : surface.ring(v)) {
    work.replacement.made.push_back(surface.triangle(t));
  }
  return before;
}

bool keep_or_put_back(RemeshingWork& work, std::int32_t v, const VertexPlace& before,
                      bool is_wanted) {
  SurfaceVertex& vertex = work.surface.vertex(v);
  if (is_wanted && lies_on_input(work, v) && meets_nothing(work)) {
    vertex.has_moved = true;
    work.surface.settle(v);
    return true;
  }
  work.surface.try_at(v, before.at);
  vertex.foot = before.foot;
  return false;
}

}  // namespace tetfarm
