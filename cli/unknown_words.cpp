#include "cli/unknown_words.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/error_with_help.h"
#include "cli/did_you_mean.h"

namespace tetfarm {
namespace {

std::string nearest_of(const std::string& word, const std::vector<std::string>& known) {
  return did_you_mean(word, {known.begin(), known.end()});
}

/// What a person may call: those that only processes call are in no group.
std::vector<std::string> names_of_commands(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](CLI::App*) { return true; })) {
    if (!sub->get_group().empty()) names.push_back(sub->get_name());
  }
  return names;
}

/// Null when there is none.
CLI::App* find_command(CLI::App& app, const std::string& word) {
  const auto found = app.get_subcommands([&](CLI::App* sub) { return sub->check_name(word); });
  return found.empty() ? nullptr : found.front();
}

/// Whether commands are below it: "keys".
bool is_group(CLI::App& app) {
  return !app.get_subcommands([](CLI::App*) { return true; }).empty();
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The command that was chosen, the innermost where there are several.
const CLI::App& innermost(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost(*chosen.front());
}

}  // namespace

void require_known_command(CLI::App& app, int argc, const char* const* argv, int first) {
  const std::string word = argc > first ? argv[first] : "";
  const std::string before = first == 1 ? "" : app.get_name() + " ";
  const std::string list = "`tetfarm " + before + "--help` lists the commands";
  if (word.empty()) {
    throw ErrorWithHelp(
        ExitCode::usage,
        "no command given" + (before.empty() ? "" : " after " + in_ticks(app.get_name())),
        before.empty() ? "`tetfarm run wing.stl -o out` meshes a surface; " + list : list);
  }
  if (word.starts_with('-')) return;
  CLI::App* chosen = find_command(app, word);
  if (chosen != nullptr && is_group(*chosen)) require_known_command(*chosen, argc, argv, first + 1);
  if (chosen != nullptr) return;
  const bool is_surface = before.empty() && std::filesystem::exists(word);
  const std::string meant = is_surface ? "; did you mean " + in_ticks("tetfarm run " + word) + "?"
                                       : nearest_of(word, names_of_commands(app));
  throw ErrorWithHelp(ExitCode::usage, "unknown command " + in_ticks(before + word) + meant, list);
}

std::string what_is_wrong(CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-')) continue;
    const std::string name = word.substr(0, word.find('='));
    return "unknown option " + in_ticks(name) + nearest_of(name, names_of_options(command));
  }
  return error.what();
}

}  // namespace tetfarm
