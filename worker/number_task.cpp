#include "worker/number_task.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/numbering_file.h"
#include "tasks/number_contract.h"
#include "worker/element_input.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// The lines of the table that are not of leaves.
std::string cuts_of(const std::string& table) {
  std::istringstream lines(table);
  std::string line;
  std::string cuts;
  while (std::getline(lines, line)) {
    if (!line.starts_with("leaf ")) cuts += line + '\n';
  }
  return cuts;
}

/// A line for each run of nodes that are gone. @pre they ascend.
std::string dropped_lines(const std::vector<Origin>& gone) {
  std::string lines;
  for (std::size_t first = 0; first < gone.size();) {
    std::size_t next = first + 1;
    while (next < gone.size() && gone[next].owner == gone[first].owner &&
           gone[next].index == gone[next - 1].index + 1) {
      ++next;
    }
    lines += "dropped " + std::to_string(gone[first].owner) + ' ' +
             std::to_string(gone[first].index) + ' ' + std::to_string(next - first) + '\n';
    first = next;
  }
  return lines;
}

struct LeafCounts {
  std::uint64_t nodes = 0;
  std::uint64_t tets = 0;
  std::uint64_t triangles = 0;
};

/// Nodes of cuts that are on no boundary any more, as sub-domains on both sides were joined.
std::vector<Origin> dropped_by_assimilation(const TaskIo& io, const TaskFile& file) {
  std::vector<Origin> dropped;
  std::istringstream lines(io.read(file));
  std::string word;
  Origin first;
  std::uint32_t count = 0;
  while (lines >> word >> first.owner >> first.index >> count) {
    for (std::uint32_t i = 0; i < count; ++i) dropped.push_back({first.owner, first.index + i});
  }
  if (!lines.eof()) throw CorruptFile("has an invalid line", io.name_of(file));
  return dropped;
}

/// A line for each leaf, from the heads of all files. What cosmetics removed is added to `gone`.
std::string leaves_after_cosmetics(const TaskIo& io, const NumberGiven& given,
                                   const std::string& order, std::vector<Origin>& gone) {
  const Colours colours = colours_of(order);
  std::map<std::uint64_t, LeafCounts> counts;
  for (const auto& [heap, colour] : colours) {
    const ElementInput core(io, file_of_leaf(given.cores, heap));
    const ElementInput turn(io, file_of_leaf(given.elements, heap));
    counts[heap].nodes = turn.head().next_node;
    counts[heap].tets += core.head().sections.at(0).tets.at(0);
    counts[heap].triangles += core.head().sections.at(0).triangles.at(0);
    for (const ElementFileHead::Section& section : turn.head().sections) {
      if (last_turn(section.sharers, colours) != heap) continue;
      for (std::size_t i = 0; i < section.sharers.size(); ++i) {
        counts[section.sharers[i]].tets += section.tets[i];
        counts[section.sharers[i]].triangles += section.triangles[i];
      }
    }
    gone.insert(gone.end(), turn.head().gone.begin(), turn.head().gone.end());
  }
  std::string table;
  for (const auto& [heap, leaf] : counts) {
    table += "leaf " + std::to_string(heap) + ' ' + std::to_string(leaf.nodes) + ' ' +
             std::to_string(leaf.tets) + ' ' + std::to_string(leaf.triangles) + '\n';
  }
  return table;
}

}  // namespace

void number_task(TaskIo& io) {
  const auto given = io.given<NumberGiven>();
  const SurfaceMesh surface = io.read(given.surface, surface_from_bytes);
  io.progress().begin(WorkStage::number);
  report_cost(io, number_cost(static_cast<double>(surface.triangles.size())));
  std::string table = given.table;
  std::vector<Origin> gone;
  if (given.dropped) gone = dropped_by_assimilation(io, *given.dropped);
  if (given.order) {
    table = cuts_of(table) + leaves_after_cosmetics(io, given, *given.order, gone);
  }
  if (given.layer_table) table += io.read(*given.layer_table);
  std::sort(gone.begin(), gone.end());
  table += dropped_lines(gone);
  io.made(NumberMade{io.publish(numbering_to_bytes(number_globally(surface, table)))});
}

}  // namespace tetfarm
