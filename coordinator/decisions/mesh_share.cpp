#include "coordinator/decisions/mesh_share.h"

#include <algorithm>
#include <array>

#include "store/task_time.h"

namespace tetfarm {
namespace {

/// A stage, what it takes of the seconds of the elements, and what of those of the needles.
struct Weight {
  WorkStage stage;
  double of_elements;
  double of_needles;
};

constexpr std::array<Weight, 8> weights = {{
    {WorkStage::boundary, 0.1, 0},
    {WorkStage::edges, 0.02, 0.3},
    {WorkStage::faces, 0.02, 0.05},
    {WorkStage::splits, 0, 0.1},
    {WorkStage::added_points, 0, 0.05},
    {WorkStage::points, 0.36, 0},
    {WorkStage::cosmetics, 0.4, 0.5},
    {WorkStage::validate, 0.1, 0},
}};

/// Passes of a stage whose total is not known; most meshes have some less.
constexpr double usual_passes = 9;

double seconds_of(double elements, double needles) {
  return usual_seconds(TaskKind::mesh, {elements, 0, needles}).expected;
}

double share_of_stage(const WorkCount& count) {
  if (count.total > 0) {
    return static_cast<double>(std::min(count.done, count.total)) /
           static_cast<double>(count.total);
  }
  if (count.pass == 0) return 0;
  return std::min(static_cast<double>(count.pass - 1) / usual_passes, 1.0);
}

}  // namespace

double mesh_share(const WorkCount& count, double elements, double needles) {
  const double fixed = seconds_of(0, 0);
  const double element_seconds = std::max(seconds_of(std::max(elements, 0.0), 0), fixed);
  const double needle_seconds = std::max(seconds_of(0, std::max(needles, 0.0)) - fixed, 0.0);
  double before = 0;
  double here = 0;
  double all = 0;
  for (const Weight& weight : weights) {
    const double seconds =
        weight.of_elements * element_seconds + weight.of_needles * needle_seconds;
    if (weight.stage < count.stage) before += seconds;
    if (weight.stage == count.stage) here = seconds;
    all += seconds;
  }
  if (count.stage > weights.back().stage || count.stage < weights.front().stage) return 0;
  return (before + here * share_of_stage(count)) / all;
}

}  // namespace tetfarm
