// Tasks that need no geometry: outputs and numbers are a pure function of the inputs, as a real
// task's are.
#pragma once

#include <string>

#include "base/hash.h"
#include "coordinator/task_graph.h"

namespace tetfarm {

inline ArtifactRef make_believe_file(const std::string& name, const std::string& content) {
  const std::string hash = hash128(content).hex();
  return {name, hash, content.size() + 1};
}

inline TaskResult run_make_believe(const TaskRow& task) {
  std::string seed = std::string(name_of(task.kind)) + std::to_string(task.path);
  for (const ArtifactRef& input : task.inputs) seed += input.name + input.hash;
  for (const auto& [name, text] : task.parameters) seed += name + text;
  const Hash128 hash = hash128(seed);
  TaskResult result;
  const auto add = [&](const char* name) {
    result.outputs.push_back(make_believe_file(name, seed + name));
  };
  switch (task.kind) {
    case TaskKind::inspect:
      add("surface");
      add("spacing");
      add("root");
      result.numbers = {{"parts", 12}, {"total_work", 1000}, {"across_cuts", 1}};
      break;
    case TaskKind::decompose: {
      const auto parts = static_cast<std::uint64_t>(std::stoul(task.parameters.at("parts")));
      if (hash.high % 7 == 0) {
        result.texts["reason"] = "no valid plane";
        break;
      }
      const std::uint64_t left = 1 + hash.low % (parts - 1);
      add("left");
      add("right");
      result.numbers = {{"left_parts", static_cast<double>(left)},
                        {"right_parts", static_cast<double>(parts - left)},
                        {"interdomain_nodes", static_cast<double>(hash.low % 50)}};
      break;
    }
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
    case TaskKind::assemble:
      add("mesh.vtu");
      result.numbers = {{"tets", static_cast<double>(hash.high % 100000)}};
      break;
  }
  return result;
}

}  // namespace tetfarm
