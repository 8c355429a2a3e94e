#include "worker/decompose_task.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/decompose/region_split.h"
#include "mesh/io/artifact_file.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {
namespace {

/// A half that is to be cut again need not recover: its own halves will be tried.
CutOutcome find_cut(TaskIo& io, const JobFile& job, const Subdomain& subdomain,
                    const SpacingField& spacing, std::int64_t left_parts,
                    std::int64_t right_parts) {
  CutOptions options;
  options.planes = cut_planes_of(job);
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

/// Publishes the two halves, which are checked first.
void publish_halves(TaskIo& io, const Subdomain& left, std::int64_t left_parts,
                    const Subdomain& right, std::int64_t right_parts) {
  require_sound(left);
  require_sound(right);
  io.number("left_parts", static_cast<double>(left_parts));
  io.number("right_parts", static_cast<double>(right_parts));
  io.publish("left", subdomain_to_bytes(left));
  io.publish("right", subdomain_to_bytes(right));
}

}  // namespace

CutPlanes cut_planes_of(const JobFile& job) {
  if (job.plane == "lattice") return CutPlanes::lattice;
  if (job.plane == "axis") return CutPlanes::axis;
  return job.plane == "inertia" ? CutPlanes::inertia : CutPlanes::automatic;
}

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
  const JobFile job = parse_job_file(io.read("job"), "job.toml");
  const Subdomain subdomain = subdomain_from_bytes(io.read("subdomain"), "subdomain");
  const SpacingField spacing = SpacingField::from_bytes(io.read("spacing"), "spacing");
  const std::int64_t parts = io.whole_parameter("parts");
  io.progress("cut", 0);
  if (subdomain.region == 0) {
    const RegionSplit split = split_regions(subdomain, spacing, parts);
    io.number("interdomain_nodes", 0);
    publish_halves(io, split.left, split.left_parts, split.right, split.right_parts);
    return;
  }
  const std::int64_t left_parts = parts / 2;
  const CutOutcome outcome = find_cut(io, job, subdomain, spacing, left_parts, parts - left_parts);
  if (!outcome.cut) {
    io.text("reason", outcome.reason);
    return;
  }
  const Cut& cut = *outcome.cut;
  io.number("interdomain_nodes", static_cast<double>(nodes_of_cut(cut.left, subdomain.path)));
  io.number("candidates_tried", cut.candidates_tried);
  publish_halves(io, cut.left, left_parts, cut.right, parts - left_parts);
}

}  // namespace tetfarm
