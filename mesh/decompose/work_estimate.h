/// How many elements a sub-domain will get, and where they lie: sample points of the inside, each
/// with its share of the work.
///
/// Source: thesis 4.3.1 and 4.3.2 balance by the number of boundary faces; a departure: the spacing
/// h is known, so the work is computed as the integral of elements_per_h3 / h^3 over the inside.
/// How: cells no larger than a few h; one ray along x through each row of cells tells which part of
/// each is inside. Rounding can only misjudge cells that the surface passes through.
#pragma once

#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

struct WorkSample {
  Vec3 at;
  double work = 0;     // elements
  double spacing = 0;  // length
  Vec3 cell;           // edge lengths of the cell that it stands for
};

struct WorkSamples {
  std::vector<WorkSample> samples;
  double total = 0;
};

/// At least some thousand samples in a compact sub-domain (the cells shrink for it), and never
/// cells larger than 3 h. @pre the surface is closed and oriented outward.
/// Cost: O((s + t) log s) for s samples, t triangles; s is about elements / 100 when large.
WorkSamples sample_work(const Subdomain& subdomain, const SpacingField& spacing);

}  // namespace tetfarm
