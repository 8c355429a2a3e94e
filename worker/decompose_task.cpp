#include "worker/decompose_task.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/io/artifact_file.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {
namespace {

bool recovers(const Subdomain& half, const SpacingField& spacing, bool may_add_points) {
  try {
    VolumeMeshReport report;
    mesh_volume(half, spacing, {.fill = false, .cosmetics = false, .progress = {}}, &report);
    return may_add_points || report.interior_steiner_points == 0;
  } catch (const RecoveryFailure&) {
    return false;
  } catch (const InvalidInput&) {
    return false;
  }
}

/// A cut whose halves recover cleanly; failing that, one whose halves recover at all.
CutOutcome find_cut(TaskIo& io, const Subdomain& subdomain, const SpacingField& spacing,
                    double left_share) {
  CutOptions options;
  options.left_share = left_share;
  CutOutcome outcome;
  for (const bool may_add_points : {false, true}) {
    bool was_asked = false;
    options.accept = [&](const Subdomain& left, const Subdomain& right) {
      was_asked = true;
      io.progress("trial of a cut", 0);
      return halves_recover(left, right, spacing, may_add_points);
    };
    outcome = planar_cut(subdomain, spacing, options);
    if (outcome.cut || !was_asked) break;
  }
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

bool halves_recover(const Subdomain& left, const Subdomain& right, const SpacingField& spacing,
                    bool may_add_points) {
  return recovers(left, spacing, may_add_points) && recovers(right, spacing, may_add_points);
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
  io.number("interdomain_triangles", static_cast<double>(cut.interdomain_triangles));
  io.number("candidates_tried", cut.candidates_tried);
  io.number("left_work", cut.left_work);
  io.number("right_work", cut.right_work);
  io.publish("left", subdomain_to_bytes(cut.left));
  io.publish("right", subdomain_to_bytes(cut.right));
}

}  // namespace tetfarm
