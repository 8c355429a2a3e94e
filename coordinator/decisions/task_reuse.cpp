#include "coordinator/decisions/task_reuse.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "base/hash.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/decompose_contract.h"

namespace tetfarm {
namespace {

/// Leaves of the parts of the two sides how they are shared. Where a limit of memory decides they
/// count for themselves, and stay.
void keep_share_alone(const TaskRow& task, std::map<std::string, std::string>& parameters) {
  const auto given = given_to<DecomposeGiven>(task);
  if (given.most_bytes) return;
  const std::uint64_t divisor =
      std::max<std::uint64_t>(1, std::gcd(given.left_parts, given.right_parts));
  parameters[field_name(&DecomposeGiven::left_parts)] = std::to_string(given.left_parts / divisor);
  parameters[field_name(&DecomposeGiven::right_parts)] =
      std::to_string(given.right_parts / divisor);
}

}  // namespace

std::string work_name(const TaskRow& task) {
  std::string text = std::string(name_of(task.kind)) + " " + std::to_string(task.path);
  for (const ArtifactRef& input : task.inputs) text += "\n" + input.name + " " + input.hash;
  std::map<std::string, std::string> parameters = task.parameters;
  if (task.kind == TaskKind::decompose) keep_share_alone(task, parameters);
  for (const auto& [name, value] : parameters) text += "\n" + name + "=" + value;
  return hash128(text).hex();
}

std::string program_of(const TaskRow& done) {
  const auto program = done.texts.find("program");
  return program == done.texts.end() ? "" : program->second;
}

Hash128 work_key(const TaskRow& task, const std::string& program) {
  return hash128(work_name(task) + program);
}

bool serves(const TaskRow& done, const TaskRow& wanted) {
  // What divided by regions chose the parts from the number that was wanted.
  if (done.kind != TaskKind::decompose) return true;
  const auto made = made_by<DecomposeMade>(done);
  const bool chose_parts = made.halves && made.halves->left.parts;
  return !chose_parts || done.parameters == wanted.parameters;
}

void take_result(const TaskRow& done, TaskRow& wanted) {
  wanted.state = TaskState::done;
  wanted.attempt = done.attempt;
  wanted.seconds = done.seconds;
  wanted.peak_rss_bytes = done.peak_rss_bytes;
  wanted.outputs = done.outputs;
  wanted.numbers = done.numbers;
  wanted.texts = done.texts;
}

}  // namespace tetfarm
