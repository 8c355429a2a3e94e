#include "coordinator/decisions/cosmetic_graph.h"

#include <algorithm>
#include <sstream>

#include "base/check.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/cosmetic_contract.h"
#include "tasks/extract_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/mesh_contract.h"
#include "tasks/order_contract.h"

namespace tetfarm {
namespace {

/// "HEAP COLOUR NEIGHBOUR NEIGHBOUR …"; nothing when it is not like that.
std::optional<std::pair<std::uint64_t, Turn>> parse_line(const std::string& line) {
  std::istringstream words(line);
  std::uint64_t heap = 0;
  Turn turn;
  if (!(words >> heap >> turn.colour) || heap == 0 || turn.colour < 0) return std::nullopt;
  std::uint64_t neighbour = 0;
  while (words >> neighbour) turn.neighbours.push_back(neighbour);
  if (!words.eof()) return std::nullopt;
  const auto& list = turn.neighbours;
  const bool ascends =
      std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
  if (!ascends) return std::nullopt;
  return std::pair{heap, std::move(turn)};
}

bool fits(const TurnOrder& turns, std::uint64_t heap, const Turn& turn) {
  return std::all_of(turn.neighbours.begin(), turn.neighbours.end(), [&](std::uint64_t other) {
    const auto found = turns.find(other);
    if (found == turns.end() || found->second.colour == turn.colour) return false;
    const std::vector<std::uint64_t>& back = found->second.neighbours;
    return std::binary_search(back.begin(), back.end(), heap);
  });
}

std::string line_of(std::uint64_t heap, std::int32_t colour) {
  return std::to_string(heap) + ' ' + std::to_string(colour) + '\n';
}

/// The elements of a leaf before its turn. @pre they are there.
TaskFile extracted(const FindDone& find, std::uint64_t leaf) {
  const TaskRow* task = find(TaskKind::extract, leaf);
  TF_CHECK(task != nullptr);
  return made_by<ExtractMade>(*task).elements;
}

/// The elements of a leaf after its turn. @pre it had it.
TaskFile mended(const FindDone& find, std::uint64_t leaf) {
  const TaskRow* task = find(TaskKind::cosmetic, leaf);
  TF_CHECK(task != nullptr);
  return made_by<CosmeticMade>(*task).elements;
}

}  // namespace

std::optional<TurnOrder> turn_order_of(const std::string& text) {
  TurnOrder turns;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    auto parsed = parse_line(line);
    if (!parsed || !turns.insert(std::move(*parsed)).second) return std::nullopt;
  }
  for (const auto& [heap, turn] : turns) {
    if (!fits(turns, heap, turn)) return std::nullopt;
  }
  return turns;
}

bool has_seam_cosmetics(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  if (!made_by<InspectMade>(inspect).across_cuts) return false;
  return std::count_if(tree.begin(), tree.end(), [](const SubdomainRow& node) {
           return node.state == SubdomainState::leaf;
         }) > 1;
}

TaskRow order_task(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  OrderGiven given;
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    given.subdomains[node.path] = {node.hash, node.size};
  }
  return new_task(inspect.job, 0, given);
}

TaskRow extract_task(const TaskRow& order, const TaskRow& mesh) {
  ExtractGiven given;
  given.subdomain = given_to<MeshGiven>(mesh).subdomain;
  given.mesh = made_by<MeshMade>(mesh).mesh;
  given.shared = made_for_leaf(order, &OrderMade::shared, mesh.path);
  return new_task(mesh.job, mesh.path, given);
}

std::optional<TaskRow> cosmetic_task(const TaskRow& inspect, const TurnOrder& turns,
                                     std::uint64_t leaf, const FindDone& find) {
  const TaskRow* own = find(TaskKind::extract, leaf);
  if (own == nullptr) return std::nullopt;
  const Turn& turn = turns.at(leaf);
  CosmeticGiven given;
  given.own = made_by<ExtractMade>(*own).elements;
  given.colours = line_of(leaf, turn.colour);
  for (const std::uint64_t other : turn.neighbours) {
    const std::int32_t its_colour = turns.at(other).colour;
    const bool had_turn = its_colour < turn.colour;
    const TaskRow* made = find(had_turn ? TaskKind::cosmetic : TaskKind::extract, other);
    if (made == nullptr) return std::nullopt;
    if (had_turn) {
      given.had_turn[other] = made_by<CosmeticMade>(*made).elements;
    } else {
      given.waiting[other] = made_by<ExtractMade>(*made).elements;
    }
    given.colours += line_of(other, its_colour);
  }
  given.spacing = made_by<InspectMade>(inspect).spacing;
  return new_task(inspect.job, leaf, given);
}

void add_elements(const TaskRow& order, const TurnOrder& turns, const FindDone& find,
                  NumberGiven& number) {
  number.order = made_by<OrderMade>(order).order;
  for (const auto& [leaf, turn] : turns) {
    number.cores[leaf] = extracted(find, leaf);
    number.elements[leaf] = mended(find, leaf);
  }
}

void add_final_elements(std::uint64_t leaf, const TurnOrder& turns, const FindDone& find,
                        WriteGiven& write) {
  const Turn& turn = turns.at(leaf);
  write.cores[leaf] = extracted(find, leaf);
  write.elements[leaf] = mended(find, leaf);
  std::string colours = line_of(leaf, turn.colour);
  for (const std::uint64_t other : turn.neighbours) {
    write.elements[other] = mended(find, other);
    colours += line_of(other, turns.at(other).colour);
  }
  write.colours = colours;
}

}  // namespace tetfarm
