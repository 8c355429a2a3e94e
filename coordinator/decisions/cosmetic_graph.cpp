#include "coordinator/decisions/cosmetic_graph.h"

#include <algorithm>
#include <sstream>

#include "base/check.h"
#include "coordinator/decisions/task_graph.h"

namespace tetfarm {
namespace {

ArtifactRef file_of(std::span<const ArtifactRef> files, const std::string& name) {
  const std::optional<ArtifactRef> file = find_file(files, name);
  TF_CHECK(file.has_value());
  return *file;
}

ArtifactRef renamed(ArtifactRef file, std::string name) {
  file.name = std::move(name);
  return file;
}

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
  const auto across = inspect.numbers.find("across_cuts");
  if (across == inspect.numbers.end() || across->second != 1) return false;
  return std::count_if(tree.begin(), tree.end(), [](const SubdomainRow& node) {
           return node.state == SubdomainState::leaf;
         }) > 1;
}

TaskRow order_task(const TaskRow& inspect, std::span<const SubdomainRow> tree) {
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::order;
  for (const SubdomainRow& node : tree) {
    if (node.state != SubdomainState::leaf) continue;
    task.inputs.push_back({"subdomain:" + std::to_string(node.path), node.hash, node.size});
  }
  return task;
}

TaskRow extract_task(const TaskRow& order, const TaskRow& mesh) {
  TaskRow task;
  task.job = mesh.job;
  task.kind = TaskKind::extract;
  task.path = mesh.path;
  const std::string shared = "shared:" + std::to_string(mesh.path);
  task.inputs = {file_of(mesh.inputs, "subdomain"), file_of(mesh.outputs, "mesh"),
                 renamed(file_of(order.outputs, shared), "shared")};
  return task;
}

std::optional<TaskRow> cosmetic_task(const TaskRow& inspect, const TurnOrder& turns,
                                     std::uint64_t leaf, const FindDone& find) {
  const TaskRow* own = find(TaskKind::extract, leaf);
  if (own == nullptr) return std::nullopt;
  const Turn& turn = turns.at(leaf);
  TaskRow task;
  task.job = inspect.job;
  task.kind = TaskKind::cosmetic;
  task.path = leaf;
  task.inputs = {file_of(inspect.outputs, "spacing"),
                 renamed(file_of(own->outputs, "elements"), "own")};
  std::string colours = line_of(leaf, turn.colour);
  for (const std::uint64_t other : turn.neighbours) {
    const std::int32_t its_colour = turns.at(other).colour;
    const bool had_turn = its_colour < turn.colour;
    const TaskRow* made = find(had_turn ? TaskKind::cosmetic : TaskKind::extract, other);
    if (made == nullptr) return std::nullopt;
    task.inputs.push_back(renamed(file_of(made->outputs, "elements"),
                                  (had_turn ? "had_turn:" : "waits:") + std::to_string(other)));
    colours += line_of(other, its_colour);
  }
  task.parameters["colours"] = colours;
  return task;
}

void add_elements(TaskRow& number, const TaskRow& order, const TurnOrder& turns,
                  const FindDone& find) {
  number.parameters["order"] = order.texts.at("order");
  for (const auto& [leaf, turn] : turns) {
    const std::string heap = std::to_string(leaf);
    const TaskRow* extracted = find(TaskKind::extract, leaf);
    const TaskRow* mended = find(TaskKind::cosmetic, leaf);
    TF_CHECK(extracted != nullptr && mended != nullptr);
    number.inputs.push_back(renamed(file_of(extracted->outputs, "elements"), "core:" + heap));
    number.inputs.push_back(renamed(file_of(mended->outputs, "elements"), "elements:" + heap));
  }
}

void add_final_elements(TaskRow& write, const TurnOrder& turns, const FindDone& find) {
  const Turn& turn = turns.at(write.path);
  const auto add = [&](TaskKind maker, std::uint64_t leaf, const std::string& name) {
    const TaskRow* made = find(maker, leaf);
    TF_CHECK(made != nullptr);
    write.inputs.push_back(
        renamed(file_of(made->outputs, "elements"), name + std::to_string(leaf)));
  };
  const TaskRow* mesh = find(TaskKind::mesh, write.path);
  TF_CHECK(mesh != nullptr);
  add_mesh(*mesh, write);
  add(TaskKind::extract, write.path, "core:");
  add(TaskKind::cosmetic, write.path, "elements:");
  std::string colours = line_of(write.path, turn.colour);
  for (const std::uint64_t other : turn.neighbours) {
    add(TaskKind::cosmetic, other, "elements:");
    colours += line_of(other, turns.at(other).colour);
  }
  write.parameters["colours"] = colours;
}

}  // namespace tetfarm
