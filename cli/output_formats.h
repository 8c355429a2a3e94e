/// The formats that a run writes itself, and what to say to those that only `export` writes.
#pragma once

#include <string>
#include <vector>

namespace tetfarm {

/// `folder` is where the run puts its mesh, for the command that exports it. @throws UsageError
/// "--format su2: …; run writes vtkhdf and lb8.ugrid; for SU2: `tetfarm export out -o mesh.su2`".
void require_formats_of_run(const std::vector<std::string>& formats, const std::string& folder);

}  // namespace tetfarm
