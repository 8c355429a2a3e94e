#include "cli/command_purposes.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "base/check.h"

namespace tetfarm {
namespace {

struct Purpose {
  const char* name = "";
  std::vector<std::string_view> commands;
};

const std::vector<Purpose>& purposes() {
  static const std::vector<Purpose> all = {
      {"Mesh a surface",
       {"run", "check", "plan", "init", "surface", "convert", "shape", "spacing"}},
      {"Use a mesh", {"quality", "export", "render", "report"}},
      {"Mesh the plane", {"plane", "adapt", "loop", "transfer"}},
      {"Work on a farm", {"submit", "wait", "priority", "cancel", "retry"}},
      {"Watch a farm",
       {"dashboard", "top", "jobs", "status", "tasks", "workers", "events", "logs", "explain",
        "trace"}},
      {of_operators,
       {"coordinator", "worker", "pool", "drain", "keys", "doctor", "gc", "backup", "restore"}},
      {"The program itself", {"man", "completion", "version"}}};
  return all;
}

const char* purpose_of(const std::string& command) {
  for (const Purpose& purpose : purposes()) {
    const auto& names = purpose.commands;
    if (std::find(names.begin(), names.end(), command) != names.end()) return purpose.name;
  }
  return nullptr;
}

}  // namespace

void group_by_purpose(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
    if (command->get_group().empty()) continue;
    const char* purpose = purpose_of(command->get_name());
    TF_CHECK(purpose != nullptr);
    command->group(purpose);
  }
}

std::string commands_by_purpose(const DeclaredCommand& program) {
  constexpr std::size_t longest_line = 80;
  constexpr std::size_t indentation = 22;
  std::string text;
  for (const Purpose& purpose : purposes()) {
    std::string line = std::string("  ") + purpose.name;
    line.resize(indentation, ' ');
    for (const DeclaredCommand& command : program.commands) {
      if (command.purpose != purpose.name) continue;
      if (line.size() + 1 + command.name.size() > longest_line) {
        text += line + "\n";
        line.assign(indentation, ' ');
      }
      line += " " + command.name;
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace tetfarm
