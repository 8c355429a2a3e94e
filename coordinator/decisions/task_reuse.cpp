#include "coordinator/decisions/task_reuse.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "base/hash.h"

namespace tetfarm {
namespace {

std::uint64_t parts_of(const TaskRow& task, const char* name) {
  const auto found = task.parameters.find(name);
  return found == task.parameters.end() ? 0 : std::stoull(found->second);
}

/// Of parts that count for themselves: where a limit of memory decides, they are exact.
bool is_cut_by_share(const TaskRow& task) {
  return task.kind == TaskKind::decompose && !task.parameters.contains("most_bytes");
}

}  // namespace

std::string work_name(const TaskRow& task) {
  std::string text = std::string(name_of(task.kind)) + " " + std::to_string(task.path);
  for (const ArtifactRef& input : task.inputs) text += "\n" + input.name + " " + input.hash;
  std::map<std::string, std::string> parameters = task.parameters;
  if (is_cut_by_share(task)) {
    const std::uint64_t left = parts_of(task, "left_parts");
    const std::uint64_t right = parts_of(task, "right_parts");
    const std::uint64_t divisor = std::max<std::uint64_t>(1, std::gcd(left, right));
    parameters["left_parts"] = std::to_string(left / divisor);
    parameters["right_parts"] = std::to_string(right / divisor);
  }
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
  const bool chose_parts = done.numbers.contains("left_parts");
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
