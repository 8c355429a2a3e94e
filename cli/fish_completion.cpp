#include "cli/fish_completion.h"

#include <string_view>

namespace tetfarm {
namespace {

constexpr const char* conditions_of_fish = R"(
# Whether the command line is in this command, such as: keys new
function __tetfarm_in
    set -l words (commandline -opc)
    string match -q -- "$argv *" "$words[2..] "
end

# Whether the next word is to be a command below this one.
function __tetfarm_before
    set -l words (commandline -opc)
    test "$argv" = "$words[2..]"
end

complete -c tetfarm -f
)";

/// A value, of which nothing is known.
constexpr const char* nothing_in_fish = " -x";

std::string fish_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string fish_values(const DeclaredOption& option) {
  const std::string words = joined_words(option.choices, " ");
  if (option.is_list && !words.empty()) {
    return " -x -a " + fish_quoted("(__fish_append , " + words + ")");
  }
  if (!words.empty()) return " -x -a " + fish_quoted(words);
  if (option.completion == ValueCompletion::folder) {
    return " -x -a '(__fish_complete_directories)'";
  }
  return option.completion == ValueCompletion::file ? " -r -F" : nothing_in_fish;
}

std::string fish_names(const DeclaredOption& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return names;
}

std::string fish_lines(const DeclaredCommand& command) {
  const std::string begin = "complete -c tetfarm -n ";
  // The options of a command with others below it stand before these.
  const std::string before = begin + fish_quoted("__tetfarm_before " + command.name);
  const std::string here =
      command.commands.empty() ? begin + fish_quoted("__tetfarm_in " + command.name) : before;
  std::string text = "\n";
  for (const DeclaredOption& option : command.options) {
    text += here + fish_names(option) + (option.value.empty() ? "" : fish_values(option)) + " -d " +
            fish_quoted(in_brief(option.what)) + "\n";
  }
  for (const DeclaredOption& argument : command.arguments) {
    const std::string values = fish_values(argument);
    if (values != nothing_in_fish) text += here + values + "\n";
  }
  for (const DeclaredCommand& sub : command.commands) {
    text += before + " -a " + sub.name.substr(sub.name.rfind(' ') + 1) + " -d " +
            fish_quoted(sub.what) + "\n";
  }
  for (const DeclaredCommand& sub : command.commands) text += fish_lines(sub);
  return text;
}

}  // namespace

std::string fish_completion(const DeclaredCommand& program) {
  return std::string("# Completion for fish; `tetfarm completion fish` prints it.\n") +
         conditions_of_fish + fish_lines(program);
}

}  // namespace tetfarm
