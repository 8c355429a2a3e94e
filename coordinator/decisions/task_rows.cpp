#include "coordinator/decisions/task_rows.h"

#include <algorithm>
#include <cmath>

#include "tasks/mesh_contract.h"

namespace tetfarm {
namespace {

std::optional<double> parameter(const TaskRow& task, const std::string& name) {
  const auto found = task.parameters.find(name);
  if (found == task.parameters.end()) return std::nullopt;
  return static_cast<double>(whole_count(found->second).value_or(0));
}

}  // namespace

std::optional<ArtifactRef> find_file(std::span<const ArtifactRef> files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&name](const ArtifactRef& file) { return file.name == name; });
  return found == files.end() ? std::nullopt : std::optional<ArtifactRef>(*found);
}

TaskWords given_words(const TaskRow& task) {
  TaskWords words;
  for (const ArtifactRef& file : task.inputs) {
    words.files.push_back({file.name, {file.hash, file.size}});
  }
  words.texts = task.parameters;
  return words;
}

TaskWords made_words(std::span<const ArtifactRef> outputs,
                     const std::map<std::string, double>& numbers,
                     const std::map<std::string, std::string>& texts) {
  TaskWords words;
  for (const ArtifactRef& file : outputs) {
    words.files.push_back({file.name, {file.hash, file.size}});
  }
  words.numbers = numbers;
  words.texts = texts;
  return words;
}

TaskRow new_task(JobId job, TaskKind kind, std::uint64_t path, const TaskWords& given) {
  TaskRow task;
  task.job = job;
  task.kind = kind;
  task.path = path;
  for (const auto& [name, file] : given.files) {
    TF_CHECK(!file.hash.empty());
    task.inputs.push_back({name, file.hash, file.size});
  }
  task.parameters = given.texts;
  return task;
}

std::uint64_t told_work(double elements) {
  constexpr auto most = static_cast<double>(most_of_a_count);
  return static_cast<std::uint64_t>(std::llround(std::clamp(elements, 0.0, most)));
}

std::optional<ToldSize> told_size(const TaskRow& task) {
  // Whoever is told a size is told it under these names.
  static const std::string work_name = field_name(&MeshGiven::work);
  static const std::string needles_name = field_name(&MeshGiven::needles);
  const std::optional<double> elements = parameter(task, work_name);
  if (!elements) return std::nullopt;
  return ToldSize{*elements, parameter(task, needles_name).value_or(0)};
}

}  // namespace tetfarm
