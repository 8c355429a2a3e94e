#include "worker/decompose_task.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "mesh/io/artifact_file.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {
namespace {

Recovery recovery_of(const Subdomain& half, const SpacingField& spacing) {
  try {
    VolumeMeshReport report;
    mesh_volume(half, spacing, {.fill = false, .cosmetics = false, .progress = {}}, &report);
    return report.interior_steiner_points == 0 ? Recovery::clean : Recovery::with_points;
  } catch (const RecoveryFailure&) {
    return Recovery::fails;
  } catch (const InvalidInput&) {
    return Recovery::fails;
  }
}

/// The first cut whose halves recover cleanly; failing that, the first whose halves recover at all.
CutOutcome find_cut(TaskIo& io, const Subdomain& subdomain, const SpacingField& spacing,
                    double left_share) {
  CutOptions options;
  options.left_share = left_share;
  std::optional<Cut> second_best;
  options.accept = [&](const Subdomain& left, const Subdomain& right) {
    io.progress("trial of a cut", 0);
    const Recovery recovery = recovery_of(left, right, spacing);
    if (recovery == Recovery::with_points && !second_best) {
      second_best.emplace();
      second_best->left = left;
      second_best->right = right;
    }
    return recovery == Recovery::clean;
  };
  CutOutcome outcome = planar_cut(subdomain, spacing, options);
  if (!outcome.cut) outcome.cut = std::move(second_best);
  return outcome;
}

std::int64_t nodes_of_cut(const Subdomain& half, TreePath cut) {
  return std::count_if(half.node_origin.begin(), half.node_origin.end(),
                       [cut](const Origin& origin) { return origin.owner == cut.heap; });
}

void require_sound(const Subdomain& half) {
  const std::vector<std::string> complaints = validate(half);
  if (complaints.empty()) return;
  throw Error(ExitCode::failed,
              "the cut made an invalid sub-domain " + half.path.text() + ": " + complaints.front());
}

}  // namespace

Recovery recovery_of(const Subdomain& left, const Subdomain& right, const SpacingField& spacing) {
  const Recovery of_left = recovery_of(left, spacing);
  if (of_left == Recovery::fails) return of_left;
  return std::max(of_left, recovery_of(right, spacing));
}

void decompose_task(TaskIo& io) {
  const Subdomain subdomain = subdomain_from_bytes(io.read("subdomain"), "subdomain");
  const SpacingField spacing = SpacingField::from_bytes(io.read("spacing"), "spacing");
  const std::int64_t parts = io.whole_parameter("parts");
  const std::int64_t left_parts = parts / 2;
  io.progress("cut", 0);
  const CutOutcome outcome = find_cut(io, subdomain, spacing,
                                      static_cast<double>(left_parts) / static_cast<double>(parts));
  if (!outcome.cut) {
    io.text("reason", outcome.reason);
    return;
  }
  const Cut& cut = *outcome.cut;
  require_sound(cut.left);
  require_sound(cut.right);
  io.number("left_parts", static_cast<double>(left_parts));
  io.number("right_parts", static_cast<double>(parts - left_parts));
  io.number("interdomain_nodes", static_cast<double>(nodes_of_cut(cut.left, subdomain.path)));
  io.number("candidates_tried", cut.candidates_tried);
  io.publish("left", subdomain_to_bytes(cut.left));
  io.publish("right", subdomain_to_bytes(cut.right));
}

}  // namespace tetfarm
