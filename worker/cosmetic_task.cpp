#include "worker/cosmetic_task.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/cosmetics/element_passing.h"
#include "mesh/cosmetics/seam_cosmetics.h"
#include "mesh/spacing/spacing_field.h"
#include "tasks/cosmetic_contract.h"
#include "worker/element_input.h"
#include "worker/spacing_input.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// The files that the turn builds upon, by leaf. That of the leaf itself is in `waiting`.
struct Surroundings {
  std::uint64_t self = 0;
  std::map<std::uint64_t, ElementInput> waiting;
  std::map<std::uint64_t, ElementInput> had_turn;
  Colours colours;
};

Surroundings open_inputs(const TaskIo& io, const CosmeticGiven& given) {
  Surroundings inputs;
  inputs.self = io.assign().path();
  inputs.colours = colours_of(given.colours);
  inputs.waiting.emplace(inputs.self, ElementInput(io, given.own));
  for (const auto& [heap, file] : given.waiting) {
    inputs.waiting.emplace(heap, ElementInput(io, file));
  }
  for (const auto& [heap, file] : given.had_turn) {
    inputs.had_turn.emplace(heap, ElementInput(io, file));
  }
  return inputs;
}

/// The sets of sharers with the leaf itself that have elements in one of the files.
std::set<Sharers> shared_sections(const Surroundings& inputs) {
  std::set<Sharers> all;
  for (const auto* files : {&inputs.waiting, &inputs.had_turn}) {
    for (const auto& [heap, file] : *files) {
      for (const ElementFileHead::Section& section : file.head().sections) {
        const Sharers& sharers = section.sharers;
        if (sharers.size() > 1 && std::binary_search(sharers.begin(), sharers.end(), inputs.self)) {
          all.insert(sharers);
        }
      }
    }
  }
  return all;
}

/// The section as the last turn before this one left it: from that turn's file, or from the pieces
/// that its sharers' meshes have.
ElementSection latest(const Sharers& sharers, Surroundings& inputs) {
  const std::uint64_t last = last_before(sharers, inputs.colours, inputs.colours.at(inputs.self));
  if (last != 0) {
    ElementInput& file = inputs.had_turn.at(last);
    const auto place = file.head().find(sharers);
    if (!place) throw Error(ExitCode::failed, "a turn left out a section that it shares");
    return file.read(*place);
  }
  std::vector<ElementSection> pieces;
  for (const std::uint64_t heap : sharers) {
    ElementInput& file = inputs.waiting.at(heap);
    if (const auto place = file.head().find(sharers)) pieces.push_back(file.read(*place));
  }
  return join_pieces(std::move(pieces));
}

void report(TaskIo& io, const SeamResult& result, const CosmeticGiven& given,
            const Surroundings& inputs) {
  io.number("tets", static_cast<double>(result.tets));
  io.number("swaps", static_cast<double>(result.report.swaps));
  io.number("moves", static_cast<double>(result.report.moves));
  io.number("collapses", static_cast<double>(result.report.collapses));
  io.number("splits", static_cast<double>(result.report.splits));
  io.number("min_dihedral_deg", result.report.min_dihedral_after_deg);
  std::uint64_t bytes = 0;
  for (const auto* files : {&inputs.waiting, &inputs.had_turn}) {
    for (const auto& [heap, file] : *files) bytes += file.bytes_read();
  }
  std::uint64_t whole = given.own.size;
  for (const auto* files : {&given.waiting, &given.had_turn}) {
    for (const auto& [heap, file] : *files) whole += file.size;
  }
  io.number("bytes_read", static_cast<double>(bytes));
  io.number("bytes_of_files", static_cast<double>(whole));
}

}  // namespace

void cosmetic_task(TaskIo& io) {
  const auto given = io.given<CosmeticGiven>();
  const SpacingField spacing = spacing_input(io, given.spacing);
  Surroundings inputs = open_inputs(io, given);
  io.progress().begin(WorkStage::read);
  std::vector<ElementSection> sections;
  for (const Sharers& sharers : shared_sections(inputs)) {
    sections.push_back(latest(sharers, inputs));
  }
  double tets = 0;
  for (const ElementSection& section : sections) tets += static_cast<double>(section.tets.size());
  report_cost(io, cosmetic_cost(tets, static_cast<double>(given.spacing.size)));
  SeamTurn turn{inputs.self, {}, inputs.waiting.at(inputs.self).head().next_node};
  for (const auto& [heap, file] : inputs.had_turn) turn.had_turn.push_back(heap);
  SeamOptions options;
  options.cosmetics.spacing = [&spacing](const Vec3& p) { return spacing.at(p); };
  options.cosmetics.smallest_spacing = spacing.smallest();
  options.cosmetics.progress = io.progress();
  const SeamResult result = improve_seams(std::move(sections), turn, options);
  report(io, result, given, inputs);
  io.made(CosmeticMade{io.publish(
      elements_to_bytes({{inputs.self}, result.next_node, result.gone, {}}, result.sections))});
}

}  // namespace tetfarm
