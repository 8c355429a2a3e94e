#include "worker/decompose_task.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/io/artifact_file.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {
namespace {

/// A half that is to be cut again need not recover: its own halves will be tried.
CutOutcome find_cut(TaskIo& io, const Subdomain& subdomain, const SpacingField& spacing,
                    std::int64_t left_parts, std::int64_t right_parts) {
  CutOptions options;
  options.left_share =
      static_cast<double>(left_parts) / static_cast<double>(left_parts + right_parts);
  options.accept = [&](const Subdomain& left, const Subdomain& right) {
    io.progress("trial of a cut", 0);
    return (left_parts > 1 || boundary_recovers(left, spacing)) &&
           (right_parts > 1 || boundary_recovers(right, spacing));
  };
  return planar_cut(subdomain, spacing, options);
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

bool boundary_recovers(const Subdomain& part, const SpacingField& spacing) {
  try {
    mesh_volume(part, spacing, {.fill = false, .cosmetics = false, .progress = {}});
    return true;
  } catch (const RecoveryFailure&) {
    return false;
  } catch (const InvalidInput&) {
    return false;
  }
}

void decompose_task(TaskIo& io) {
  const Subdomain subdomain = subdomain_from_bytes(io.read("subdomain"), "subdomain");
  const SpacingField spacing = SpacingField::from_bytes(io.read("spacing"), "spacing");
  const std::int64_t parts = io.whole_parameter("parts");
  const std::int64_t left_parts = parts / 2;
  io.progress("cut", 0);
  const CutOutcome outcome = find_cut(io, subdomain, spacing, left_parts, parts - left_parts);
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
