#include "mesh/core/axis_plane.h"

#include "mesh/core/complaints.h"

namespace tetfarm {

std::string AxisPlane::text() const { return std::string(1, "xyz"[axis]) + "=" + text_of(height); }

}  // namespace tetfarm
