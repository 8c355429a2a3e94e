/// Cuts a surface into leaves as the decompose tasks do, with figures of the cuts: for trials. One
/// step more than the tasks: halves that will be leaves are recovered before their cut is taken.
#pragma once

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "mesh/core/subdomain_regions.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/decompose/region_split.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm::trial {

/// Of this process only, so that a busy machine does not count.
inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct CutLeaves {
  std::vector<Subdomain> leaves;
  int uncut = 0;  ///< sub-domains that were to be cut and could not
  int cuts = 0;
  int planes_tried = 0;
  double smallest_angle_deg = 90;  ///< of a cut with the surface
  double seconds = 0;
};

inline bool recovers(const Subdomain& part, const SpacingField& spacing) {
  return mesh_volume(part, spacing, {.fill = false, .cosmetics = false}).mesh.has_value();
}

inline void cut_into(const Subdomain& subdomain, const SpacingField& spacing, std::int64_t parts,
                     CutLeaves& made) {
  if (subdomain.region == 0) {
    const RegionSplit split = split_regions(subdomain, spacing, parts);
    cut_into(split.left, spacing, split.left_parts, made);
    cut_into(split.right, spacing, split.right_parts, made);
    return;
  }
  if (parts > 1) {
    const std::int64_t left = parts / 2;
    const std::int64_t right = parts - left;
    CutOptions options;
    options.left_share = static_cast<double>(left) / static_cast<double>(parts);
    options.accept = [&](const Subdomain& a, const Subdomain& b) {
      return (left > 1 || recovers(a, spacing)) && (right > 1 || recovers(b, spacing));
    };
    const CutOutcome outcome = planar_cut(subdomain, spacing, options);
    if (outcome.cut) {
      ++made.cuts;
      made.planes_tried += outcome.cut->candidates_tried;
      made.smallest_angle_deg = std::min(made.smallest_angle_deg, outcome.cut->smallest_angle_deg);
      cut_into(outcome.cut->left, spacing, left, made);
      cut_into(outcome.cut->right, spacing, right, made);
      return;
    }
    ++made.uncut;
    std::printf("  %s of %zu triangles not cut: %s\n", subdomain.path.text().c_str(),
                subdomain.triangles.size(), outcome.reason.c_str());
  }
  made.leaves.push_back(subdomain);
}

/// At least as many parts as there are regions. Cost: that of the decompose tasks.
inline CutLeaves cut_as_tasks(const Subdomain& root, const SpacingField& spacing,
                              std::int64_t parts) {
  CutLeaves made;
  made.seconds = -cpu_seconds();
  const auto regions = static_cast<std::int64_t>(regions_of(root).size());
  cut_into(root, spacing, std::max(parts, regions), made);
  made.seconds += cpu_seconds();
  return made;
}

}  // namespace tetfarm::trial
