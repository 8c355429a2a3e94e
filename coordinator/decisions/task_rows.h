/// The rows of tasks as what their contracts say. Graph rules make tasks and read results here, and
/// name no field themselves.
///
/// A row that an older version wrote may lack fields that came later: these are as a contract
/// begins, 0 or no file. What a worker says now is held against its contract before it becomes a
/// row (problem_with in task_graph.h).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "base/check.h"
#include "store/rows.h"
#include "tasks/task_contract.h"

namespace tetfarm {

/// The file called `name` in a list; nothing when there is none. Cost: O(files).
std::optional<ArtifactRef> find_file(std::span<const ArtifactRef> files, const std::string& name);

/// What a task was given, as it travels.
TaskWords given_words(const TaskRow& task);

/// What a task has made, as it travels.
TaskWords made_words(std::span<const ArtifactRef> outputs,
                     const std::map<std::string, double>& numbers,
                     const std::map<std::string, std::string>& texts);

/// @pre every file is known.
TaskRow new_task(JobId job, TaskKind kind, std::uint64_t path, const TaskWords& given);

/// A task that has no id yet. @pre every file is known.
template <class Given>
TaskRow new_task(JobId job, std::uint64_t path, const Given& given) {
  return new_task(job, Given::kind, path, to_words(given));
}

/// Cost: O(n log n) for all n that the task was given.
template <class Given>
Given given_to(const TaskRow& task) {
  TF_CHECK(task.kind == Given::kind);
  return from_words<Given>(given_words(task)).contract;
}

/// @pre the task is done, and without problem. Cost: O(n log n) for all n that it made.
template <class Made>
Made made_by(const TaskRow& task) {
  TF_CHECK(task.kind == Made::kind);
  return from_words<Made>(made_words(task.outputs, task.numbers, task.texts)).contract;
}

/// The file of one leaf, without a look at what else the task made. @pre it is there.
/// Cost: O(files).
template <class Made>
TaskFile made_for_leaf(const TaskRow& task, LeafFiles Made::*files, std::uint64_t leaf) {
  TF_CHECK(task.kind == Made::kind);
  const auto file = find_file(task.outputs, field_name(files) + std::to_string(leaf));
  TF_CHECK(file.has_value());
  return {file->hash, file->size};
}

/// The estimated elements of a sub-domain, as tasks on it are told.
std::uint64_t told_work(double elements);

/// How large a task was told that its sub-domain is.
struct ToldSize {
  double elements = 0;
  double needles = 0;
};

/// Nothing of a task that is told no size. Cost: O(log fields).
std::optional<ToldSize> told_size(const TaskRow& task);

}  // namespace tetfarm
