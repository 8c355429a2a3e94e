#include "mesh/decompose/planar_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/decompose/cut_check.h"
#include "mesh/decompose/edge_path_smoothing.h"
#include "mesh/decompose/intersection_repair.h"
#include "mesh/decompose/lift_heights.h"
#include "mesh/decompose/path_relaxation.h"
#include "mesh/decompose/planar_placement.h"
#include "mesh/decompose/split_subdomain.h"

namespace tetfarm {
namespace {

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

void refuse(Candidate& candidate, const std::string& problem) {
  PlaneCandidate place = candidate.place;
  candidate = Candidate{};
  candidate.place = place;
  candidate.stage = Stage::refused;
  candidate.problem = problem;
}

/// Colours, path and loops (thesis 4.3.1.5 to 4.3.1.8).
void find_loops(Candidate& candidate, const Parent& parent) {
  const auto& [subdomain, spacing, topology] = parent;
  candidate.colours = colour_by_centroid(topology, candidate.place.plane);
  relax_path(candidate.colours, subdomain, topology, candidate.place.plane);
  tidy_path(candidate.colours, topology, subdomain.triangles);
  const auto is_left = [](Side side) { return side == Side::left; };
  const bool has_left = std::any_of(candidate.colours.begin(), candidate.colours.end(), is_left);
  const bool has_right = !std::all_of(candidate.colours.begin(), candidate.colours.end(), is_left);
  if (!has_left || !has_right) return refuse(candidate, "no crossing");
  candidate.loops = find_edge_loops(candidate.colours, topology, subdomain.triangles);
  if (!candidate.loops.pinched_nodes.empty()) return refuse(candidate, "pinch");
  for (const auto& loop : candidate.loops.loops) {
    for (const RimEdge& edge : loop) {
      candidate.corners.push_back(rim_corner(subdomain, topology, edge));
      candidate.cosine = std::max(candidate.cosine, cosine_at_bisector(candidate.corners.back()));
    }
  }
  candidate.stage = Stage::has_loops;
}

/// The lift of a candidate, and what it has been asked for so far.
struct Lift {
  std::vector<double> bisector_weights;
  std::vector<std::optional<double>> pushed;
};

/// Solves, and solves again with more weight on rim edges where the angle is still small.
void lift(Candidate& candidate, const Parent& parent, Lift& state) {
  constexpr int most_rounds = 4;
  constexpr double more_weight = 5;
  const double good_enough = cosine_of_degrees(45);
  for (int round = 0; round < most_rounds; ++round) {
    lift_heights(candidate.mesh, candidate.corners, state.bisector_weights, state.pushed);
    const auto cosines = cosines_at_rim(candidate.mesh, parent.subdomain, candidate.corners);
    bool is_good = true;
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      if (cosines[i] <= good_enough) continue;
      state.bisector_weights[i] *= more_weight;
      is_good = false;
    }
    if (is_good) return;
  }
}

std::ptrdiff_t count_too_near(const std::vector<SurfaceContact>& contacts) {
  return std::count_if(contacts.begin(), contacts.end(), is_too_near);
}

/// Lifts the cut and pushes it off the surface until there is no contact, or pushing does not help.
std::vector<SurfaceContact> lift_and_push(Candidate& candidate, const Parent& parent) {
  constexpr int most_pushes = 6;
  constexpr int most_vain_pushes = 2;
  constexpr double margin = 2;  // in triangle sizes; nodes are pushed by less
  const double reach = PushOptions{}.too_near;
  const auto& [subdomain, spacing, topology] = parent;
  InterdomainMesh& mesh = candidate.mesh;
  Lift state{std::vector<double>(mesh.rim.size(), usual_bisector_weight), {}};
  lift(candidate, parent, state);
  const NearbySurface nearby = find_nearby_surface(mesh, subdomain, topology, margin);
  auto contacts = find_contacts(mesh, subdomain, topology, nearby, reach);
  auto fewest = count_too_near(contacts);
  int vain = 0;
  for (int i = 0; i < most_pushes && vain < most_vain_pushes; ++i) {
    if (push_nodes(mesh, subdomain, candidate.colours, contacts, state.pushed) == 0) break;
    lift(candidate, parent, state);
    contacts = find_contacts(mesh, subdomain, topology, nearby, reach);
    const auto now = count_too_near(contacts);
    vain = now < fewest ? 0 : vain + 1;
    fewest = std::min(fewest, now);
    if (now == 0) break;
  }
  return contacts;
}

/// Chords whose ends keep a cut triangle at a small angle to the surface, or too near to it.
std::vector<Chord> find_harmful_chords(const Candidate& candidate, const Parent& parent,
                                       const std::vector<SurfaceContact>& contacts,
                                       double cosine_limit) {
  const InterdomainMesh& mesh = candidate.mesh;
  std::vector<Chord> harmful;
  const auto add = [&](std::int32_t triangle) {
    const auto chords = chords_of_triangle(mesh, triangle);
    harmful.insert(harmful.end(), chords.begin(), chords.end());
  };
  for (const SurfaceContact& contact : contacts) {
    if (is_too_near(contact)) add(contact.cut_triangle);
  }
  const auto cosines = cosines_at_rim(mesh, parent.subdomain, candidate.corners);
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    if (cosines[i] > cosine_limit) add(mesh.rim2triangle[i]);
  }
  std::sort(harmful.begin(), harmful.end());
  harmful.erase(std::unique(harmful.begin(), harmful.end()), harmful.end());
  return harmful;
}

/// The inter-domain mesh, lifted and checked (thesis 4.3.1.9). Chords that do harm are split (fig.
/// 63).
void make_mesh(Candidate& candidate, const Parent& parent, double cosine_limit) {
  constexpr int most_rounds = 3;
  const double worst_triangle = cosine_of_degrees(8);
  std::vector<Chord> unwanted;
  std::vector<SurfaceContact> contacts;
  for (int round = 0; round < most_rounds; ++round) {
    InterdomainResult made = mesh_interdomain(parent.subdomain, parent.topology, candidate.loops,
                                              candidate.place.plane, parent.spacing, unwanted);
    if (!made.problem.empty()) return refuse(candidate, made.problem);
    candidate.mesh = std::move(made.mesh);
    contacts = lift_and_push(candidate, parent);
    const auto harmful = find_harmful_chords(candidate, parent, contacts, cosine_limit);
    if (harmful.empty()) break;
    unwanted.insert(unwanted.end(), harmful.begin(), harmful.end());
  }
  const std::string problem = judge_contacts(contacts);
  if (!problem.empty()) return refuse(candidate, problem);
  if (!shells_are_on_their_sides(candidate.mesh, parent.subdomain, candidate.colours,
                                 parent.topology.triangle2shell)) {
    return refuse(candidate, "shell on the wrong side");
  }
  if (cosine_of_smallest_triangle_angle(candidate.mesh, parent.subdomain) > worst_triangle) {
    return refuse(candidate, "thin triangle");
  }
  const auto cosines = cosines_at_rim(candidate.mesh, parent.subdomain, candidate.corners);
  candidate.cosine = cosines.empty() ? 0 : *std::max_element(cosines.begin(), cosines.end());
  candidate.stage = Stage::has_mesh;
}

/// Takes the candidate as far as this limit allows; whether it passes.
bool passes(Candidate& candidate, const Parent& parent, double cosine_limit) {
  if (candidate.stage == Stage::new_plane) find_loops(candidate, parent);
  if (candidate.stage == Stage::has_loops && candidate.cosine <= cosine_limit) {
    make_mesh(candidate, parent, cosine_limit);
  }
  return candidate.stage == Stage::has_mesh && candidate.cosine <= cosine_limit;
}

/// Why the candidates that were tried did not pass, with counts.
std::string refusals(const std::vector<Candidate>& candidates, const Candidate* accepted) {
  std::map<std::string, int> problem2count;
  for (const Candidate& c : candidates) {
    if (&c == accepted || c.stage == Stage::new_plane) continue;
    ++problem2count[c.stage == Stage::refused    ? c.problem
                    : c.stage == Stage::has_mesh ? "angle"
                                                 : "sharp corner"];
  }
  std::string text;
  for (const auto& [problem, count] : problem2count) {
    text += (text.empty() ? "" : ", ") + problem + " " + std::to_string(count);
  }
  return text;
}

Cut make_cut(const Candidate& candidate, const Parent& parent, double total_work) {
  Cut cut;
  cut.left = half_of(parent.subdomain, candidate.colours, candidate.mesh, Side::left);
  cut.right = half_of(parent.subdomain, candidate.colours, candidate.mesh, Side::right);
  cut.interdomain_triangles = static_cast<std::int32_t>(candidate.mesh.planar.triangles.size());
  cut.smallest_angle_deg =
      std::acos(std::clamp(candidate.cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
  cut.left_work = candidate.place.left_share * total_work;
  cut.right_work = total_work - cut.left_work;
  return cut;
}

/// One walk over the candidates: which of them, and how small an angle is good enough.
struct Pass {
  double cosine_limit = 0;
  bool is_balanced = false;
};

/// A slightly smaller angle is better than a badly balanced cut, which costs at every later level.
std::vector<Pass> passes_to_make(const std::vector<double>& smallest_angles_deg) {
  std::vector<Pass> passes;
  for (std::size_t i = 0; i < smallest_angles_deg.size(); ++i) {
    passes.push_back({cosine_of_degrees(smallest_angles_deg[i]), true});
    if (i > 0) passes.push_back({cosine_of_degrees(smallest_angles_deg[i - 1]), false});
  }
  if (!passes.empty()) passes.push_back({cosine_of_degrees(smallest_angles_deg.back()), false});
  return passes;
}

bool is_balanced(const Candidate& candidate, double wanted_share) {
  constexpr double most = 0.15;  // of the smaller side
  return std::fabs(candidate.place.left_share - wanted_share) <=
         most * std::min(wanted_share, 1 - wanted_share);
}

bool was_tried(const Candidate& candidate) { return candidate.stage != Stage::new_plane; }

}  // namespace

CutOutcome planar_cut(const Subdomain& subdomain, const SpacingField& spacing,
                      const CutOptions& options) {
  const Parent parent{subdomain, spacing, make_surface_topology(subdomain)};
  const WorkSamples work = sample_work(subdomain, spacing);
  std::vector<Candidate> candidates;
  for (const PlaneCandidate& place :
       place_planes(subdomain, parent.topology, work, options.left_share, options.candidates)) {
    candidates.emplace_back().place = place;
  }
  int accept_calls = 0;
  for (const Pass& pass : passes_to_make(options.smallest_angles_deg)) {
    for (Candidate& candidate : candidates) {
      if (is_balanced(candidate, options.left_share) != pass.is_balanced) continue;
      if (!passes(candidate, parent, pass.cosine_limit)) continue;
      Cut cut = make_cut(candidate, parent, work.total);
      if (options.accept) {
        if (++accept_calls > options.most_accept_calls) return {{}, "no candidate accepted"};
        if (!options.accept(cut.left, cut.right)) {
          refuse(candidate, "not accepted");
          continue;
        }
      }
      cut.candidates_tried =
          static_cast<int>(std::count_if(candidates.begin(), candidates.end(), was_tried));
      cut.refused = refusals(candidates, &candidate);
      return {std::move(cut), ""};
    }
  }
  if (accept_calls > 0) return {{}, "no candidate accepted"};
  return {
      {},
      std::to_string(candidates.size()) + " candidates refused: " + refusals(candidates, nullptr)};
}

}  // namespace tetfarm
