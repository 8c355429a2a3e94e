#include "mesh/decompose/planar_cut.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/check.h"
#include "mesh/decompose/cut_candidate.h"
#include "mesh/decompose/planar_placement.h"
#include "mesh/decompose/split_subdomain.h"

namespace tetfarm {
namespace {

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
  TF_CHECK(candidate.stage == Stage::has_mesh);
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
  TF_CHECK(options.left_share > 0 && options.left_share < 1);
  const Parent parent{subdomain, spacing, make_surface_topology(subdomain)};
  const WorkSamples work = sample_work(subdomain, spacing);
  std::vector<Candidate> candidates;
  for (const PlaneCandidate& place :
       place_planes(subdomain, parent.topology, work, spacing,
                    {options.planes, options.left_share, options.candidates})) {
    candidates.emplace_back().place = place;
  }
  options.progress.begin(WorkStage::cut, candidates.size());
  int accept_calls = 0;
  for (const Pass& pass : passes_to_make(options.smallest_angles_deg)) {
    for (Candidate& candidate : candidates) {
      if (is_balanced(candidate, options.left_share) != pass.is_balanced) continue;
      options.progress.add(was_tried(candidate) ? 0 : 1);
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
