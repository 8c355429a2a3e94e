/// Reads FLITE's mesh control files (.bac, .ba3): a background spacing, and sources.
///
/// Source: FLITE (Swansea); thesis 3.2 for what sources mean. Text: a title line; the numbers of
/// background nodes, background tets, point, line and triangle sources; of each node a line with
/// its number and place and three with a direction and a spacing each; of each tet a line; then
/// three times a title line and the sources: a line with a name, and a line
/// "x y z spacing inner outer" for each of the 1, 2 or 3 corners. What follows in a line is passed
/// over, and exponents may be Fortran's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/job_file/job_file.h"

namespace tetfarm {

struct FliteSources {
  double background = 0;  ///< 0: the file has no background nodes
  std::vector<JobSource> sources;
};

/// @throws InvalidInput with the line, also when the background is not one spacing everywhere and
/// in all directions, or a source has a spacing or radius that is not positive or an outer radius
/// below the inner.
FliteSources read_flite_sources(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
