#include "worker/decompose_task.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/decompose/region_split.h"
#include "tasks/decompose_contract.h"
#include "worker/spacing_input.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// Lattice nodes looked at for each half: its work sizes tasks, where a figure that is shown has
/// more.
constexpr std::size_t samples_of_half = 16000;

/// Estimated elements of the halves. Counting takes time: once for each cut.
struct Works {
  double left = 0;
  double right = 0;
};

Works works_of(const Subdomain& left, const Subdomain& right, const SpacingField& spacing) {
  return {estimated_elements(left, spacing, samples_of_half),
          estimated_elements(right, spacing, samples_of_half)};
}

/// Of a half that is cut further what placing the cut found is enough: within some percent.
Works works_of(const Cut& cut, bool left_is_counted, bool right_is_counted,
               const SpacingField& spacing) {
  const auto counted = [&spacing](const Subdomain& half) {
    return estimated_elements(half, spacing, samples_of_half);
  };
  return {left_is_counted ? counted(cut.left) : cut.left_work,
          right_is_counted ? counted(cut.right) : cut.right_work};
}

/// How many leaves the halves are to become: as was told, or as many as the memory asks for.
class Wanted {
 public:
  explicit Wanted(const DecomposeGiven& given)
      : spacing_(given.spacing),
        left_(static_cast<std::int64_t>(given.left_parts)),
        right_(static_cast<std::int64_t>(given.right_parts)),
        most_bytes_(static_cast<double>(given.most_bytes.value_or(0))) {}

  double left_share() const {
    return static_cast<double>(left_) / static_cast<double>(left_ + right_);
  }
  std::int64_t parts() const { return left_ + right_; }
  bool depends_on_memory() const { return most_bytes_ > 0; }
  /// Whether the number of the half's elements decides, or is that of a leaf.
  bool left_counts() const { return depends_on_memory() || left_ == 1; }
  bool right_counts() const { return depends_on_memory() || right_ == 1; }
  std::int64_t left_parts(const Subdomain& left, const Works& works) const {
    return parts(left, works.left, left_);
  }
  std::int64_t right_parts(const Subdomain& right, const Works& works) const {
    return parts(right, works.right, right_);
  }

 private:
  std::int64_t parts(const Subdomain& half, double work, std::int64_t told) const {
    if (!depends_on_memory()) return told;
    const SubdomainSize size = size_of(half, work, spacing_);
    return std::max<std::int64_t>(std::ssize(regions_of(half)),
                                  parts_for_memory(size, most_bytes_));
  }

  TaskFile spacing_;
  std::int64_t left_;
  std::int64_t right_;
  double most_bytes_;
};

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

DecomposeMade::Half published_half(TaskIo& io, const Subdomain& half, double work) {
  return {.file = io.publish(subdomain_to_bytes(half)),
          .work = work,
          .parts = std::nullopt,
          .needles = static_cast<std::uint64_t>(needle_count(half.vertices, half.triangles))};
}

/// Publishes the two halves, which are checked first.
DecomposeMade::Halves published_halves(TaskIo& io, const Works& works, const Subdomain& left,
                                       const Subdomain& right) {
  require_sound(left);
  require_sound(right);
  return {.left = published_half(io, left, works.left),
          .right = published_half(io, right, works.right),
          .interdomain_nodes = 0};
}

/// Where the coordinator cannot know them: by memory, or by regions.
void tell_parts(DecomposeMade::Halves& halves, std::int64_t left_parts, std::int64_t right_parts) {
  TF_CHECK(left_parts > 0 && right_parts > 0);
  halves.left.parts = static_cast<std::uint64_t>(left_parts);
  halves.right.parts = static_cast<std::uint64_t>(right_parts);
}

/// Several regions: by them, not by a plane.
DecomposeMade::Halves divided_regions(TaskIo& io, const Subdomain& subdomain,
                                      const SpacingField& spacing, const Wanted& wanted) {
  const RegionSplit split = split_regions(subdomain, spacing, wanted.parts());
  const Works works = works_of(split.left, split.right, spacing);
  DecomposeMade::Halves halves = published_halves(io, works, split.left, split.right);
  if (wanted.depends_on_memory()) {
    tell_parts(halves, wanted.left_parts(split.left, works),
               wanted.right_parts(split.right, works));
  } else {
    tell_parts(halves, split.left_parts, split.right_parts);
  }
  return halves;
}

}  // namespace

CutPlanes cut_planes_of(const JobFile& job) {
  if (job.plane == "lattice") return CutPlanes::lattice;
  if (job.plane == "axis") return CutPlanes::axis;
  return job.plane == "inertia" ? CutPlanes::inertia : CutPlanes::automatic;
}

void decompose_task(TaskIo& io) {
  const auto given = io.given<DecomposeGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  const Subdomain subdomain = io.read(given.subdomain, subdomain_from_bytes);
  const SpacingField spacing = spacing_input(io, given.spacing);
  report_cost(io,
              decompose_cost(size_of(subdomain, static_cast<double>(given.work), given.spacing)));
  const Wanted wanted(given);
  io.progress().begin(WorkStage::cut);
  if (subdomain.region == 0) {
    io.made(DecomposeMade{divided_regions(io, subdomain, spacing, wanted), std::nullopt});
    return;
  }
  CutOptions options;
  options.planes = cut_planes_of(job);
  options.left_share = wanted.left_share();
  options.progress = io.progress();
  const CutOutcome outcome = planar_cut(subdomain, spacing, options);
  if (!outcome.cut) {
    io.made(DecomposeMade{std::nullopt, outcome.reason});
    return;
  }
  const Cut& cut = *outcome.cut;
  const Works works = works_of(cut, wanted.left_counts(), wanted.right_counts(), spacing);
  DecomposeMade::Halves halves = published_halves(io, works, cut.left, cut.right);
  if (wanted.depends_on_memory()) {
    tell_parts(halves, wanted.left_parts(cut.left, works), wanted.right_parts(cut.right, works));
  }
  halves.interdomain_nodes = static_cast<std::uint64_t>(nodes_of_cut(cut.left, subdomain.path));
  io.number("candidates_tried", cut.candidates_tried);
  io.made(DecomposeMade{std::move(halves), std::nullopt});
}

}  // namespace tetfarm
