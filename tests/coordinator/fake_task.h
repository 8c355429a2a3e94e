// Tasks that need no geometry: outputs and numbers are a pure function of the inputs, as a real
// task's are.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/hash.h"
#include "coordinator/decisions/task_graph.h"
#include "coordinator/decisions/task_reuse.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/inspect_contract.h"
#include "tasks/task_contracts.h"

namespace tetfarm {

inline ArtifactRef fake_file(const std::string& name, const std::string& content) {
  const std::string hash = hash128(content).hex();
  return {name, hash, content.size() + 1};
}

inline std::vector<std::string> names_of(const std::vector<ArtifactRef>& files) {
  std::vector<std::string> names;
  for (const ArtifactRef& file : files) names.push_back(file.name);
  return names;
}

inline TaskFile without_name(const ArtifactRef& file) { return {file.hash, file.size}; }

/// What a submission comes with.
inline InspectGiven to_inspect(const ArtifactRef& job_file, const ArtifactRef& surface) {
  return {without_name(job_file), without_name(surface), std::nullopt};
}

/// The inspect task of a job of so many parts, done.
inline TaskRow inspected(double parts) {
  TaskRow task =
      new_task(JobId{1}, 0, to_inspect(fake_file("job", "j"), fake_file("input_surface", "i")));
  task.outputs = {fake_file("surface", "s"), fake_file("spacing", "p"), fake_file("root", "r"),
                  fake_file("settings", "t")};
  task.numbers["parts"] = parts;
  return task;
}

/// A job file that asks for so many parts and groups, and for layers that come in so many chunks;
/// its size tells the make-believe inspect task.
inline ArtifactRef fake_job(std::uint64_t parts, std::uint64_t groups, std::uint64_t chunks = 0) {
  const std::uint64_t size = (chunks * 1000 + parts) * 1000 + groups;
  return {"job", hash128("job " + std::to_string(size)).hex(), size};
}

/// Every third leaf goes to the same group.
inline void assimilate_fakes(const TaskRow& task, const std::string& seed, TaskResult& result) {
  std::map<std::size_t, std::string> group2first;
  std::size_t leaves = 0;
  for (const ArtifactRef& input : task.inputs) {
    const std::string prefix = "subdomain:";
    if (!input.name.starts_with(prefix)) continue;
    const std::string heap = input.name.substr(prefix.size());
    const std::string first = group2first.emplace(leaves++ % 3, heap).first->second;
    if (first == heap) {
      const std::string name = "group:" + heap;
      result.outputs.push_back(fake_file(name, seed + name));
    }
    result.texts["groups"] += heap + " " + first + "\n";
  }
  result.outputs.push_back(fake_file("dropped", seed + "dropped"));
}

inline void decompose_fake(const std::string& seed, TaskResult& result) {
  const Hash128 hash = hash128(seed);
  if (hash.high % 7 == 0) {
    result.texts["reason"] = "no valid plane";
    return;
  }
  for (const char* side : {"left", "right"}) {
    result.outputs.push_back(fake_file(side, seed + side));
  }
  result.numbers["interdomain_nodes"] = static_cast<double>(hash.low % 50);
  result.numbers["left_work"] = static_cast<double>(hash.low % 500);
  result.numbers["right_work"] = static_cast<double>(hash.high % 500);
  result.numbers["left_needles"] = 0;
  result.numbers["right_needles"] = static_cast<double>(hash.low % 3);
}

/// @throws std::logic_error where a worker refuses the task.
inline void require_given(const TaskRow& task) {
  const std::string breach = breach_of_given(task.kind, given_words(task));
  if (!breach.empty()) throw std::logic_error(name_of(task.kind) + (": " + breach));
}

/// Adds the layers of an inspected surface, in chunks that follow one another down the right side.
inline void add_fake_layers(std::uint64_t chunks, TaskResult& result) {
  if (chunks == 0) return;
  result.outputs.push_back(fake_file("layer_table", "layer_table"));
  for (std::uint64_t heap = 3; chunks > 0; --chunks, heap = 2 * heap + 1) {
    const std::string name = "layers:" + std::to_string(chunks > 1 ? 2 * heap : heap);
    result.outputs.push_back(fake_file(name, name));
  }
}

inline TaskResult run_fake_task(const TaskRow& task) {
  require_given(task);
  const std::string seed = work_name(task);
  const Hash128 hash = hash128(seed);
  TaskResult result;
  const auto add = [&](const char* name) {
    result.outputs.push_back(fake_file(name, seed + name));
  };
  switch (task.kind) {
    case TaskKind::remesh:
      add("surface");
      break;
    case TaskKind::inspect: {
      // What lies in the surface does not depend on the number of parts.
      for (const char* name : {"surface", "spacing", "root", "settings"}) {
        result.outputs.push_back(fake_file(name, name));
      }
      const std::uint64_t size = task.inputs.front().size;
      add_fake_layers(size / 1'000'000, result);
      result.numbers = {{"parts", static_cast<double>(size < 1000 ? 12 : size / 1000 % 1000)},
                        {"groups", static_cast<double>(size < 1000 ? 0 : size % 1000)},
                        {"total_work", 1000},
                        {"most_bytes", 0},
                        {"needles", 0},
                        {"across_cuts", 1}};
      break;
    }
    case TaskKind::decompose:
      decompose_fake(seed, result);
      break;
    case TaskKind::assimilate:
      assimilate_fakes(task, seed, result);
      break;
    case TaskKind::mesh:
      add("mesh");
      result.numbers = {{"interior_nodes", static_cast<double>(hash.low % 1000)},
                        {"tets", static_cast<double>(hash.high % 5000)}};
      break;
    case TaskKind::order: {
      // Each leaf is the neighbour of the two before and after it; three colours are enough.
      const std::size_t leaves = task.inputs.size();
      const auto heap = [&](std::size_t i) { return task.inputs[i].name.substr(10); };
      std::string text;
      for (std::size_t i = 0; i < leaves; ++i) {
        text += heap(i) + " " + std::to_string(i % 3);
        for (std::size_t j = i < 2 ? 0 : i - 2; j < std::min(leaves, i + 3); ++j) {
          if (j != i) text += " " + heap(j);
        }
        text += "\n";
        add(("shared:" + heap(i)).c_str());
      }
      result.texts["order"] = text;
      break;
    }
    case TaskKind::extract:
    case TaskKind::cosmetic:
      add("elements");
      break;
    case TaskKind::number:
      add("numbering");
      break;
    case TaskKind::write:
      add("portion");
      add("tets");
      break;
    case TaskKind::grow:
      add("portion");
      add("cells");
      break;
    case TaskKind::solve:
      add("solution");
      add("log");
      break;
    case TaskKind::adapt:
      add("mesh");
      add("start");
      add("figures");
      break;
    case TaskKind::collect:
      add("cycle_01.mesh");
      break;
    case TaskKind::assemble:
      add("mesh.vtu");
      result.numbers = {{"tets", static_cast<double>(hash.high % 100000)}};
      break;
  }
  return result;
}

}  // namespace tetfarm
