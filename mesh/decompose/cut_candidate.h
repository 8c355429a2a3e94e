/// One candidate for a cut, from its plane to a checked inter-domain mesh (thesis 4.3.1.5
/// to 4.3.1.9).
///
/// Source: thesis fig. 48, the part between choosing a plane and accepting the cut. A candidate is
/// taken only as far as is needed to refuse it, and goes on from there when a lower angle is asked.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/edge_loops.h"
#include "mesh/decompose/face_colouring.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/planar_placement.h"
#include "mesh/decompose/rim_angles.h"
#include "mesh/decompose/surface_topology.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// What all candidates share.
struct Parent {
  const Subdomain& subdomain;
  const SpacingField& spacing;
  SurfaceTopology topology;
};

/// How far a candidate has come. Work on it goes on where a lower angle limit asks for it again.
enum class Stage { new_plane, has_loops, has_mesh, refused };

struct Candidate {
  PlaneCandidate place;
  Stage stage = Stage::new_plane;
  FaceColours colours;
  EdgeLoops loops;
  std::vector<RimCorner> corners;
  InterdomainMesh mesh;
  double cosine =
      -1;  // of the smallest angle that is possible (has_loops), that there is (has_mesh)
  std::string problem;
};

/// A candidate that is out of the question, for this reason.
void refuse(Candidate& candidate, const std::string& problem);

/// Takes the candidate as far as this limit allows; whether it passes: no angle at the rim has a
/// larger cosine. Cost: O(n log n).
bool passes(Candidate& candidate, const Parent& parent, double cosine_limit);

}  // namespace tetfarm
