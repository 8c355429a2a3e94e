#include "cli/zsh_completion.h"

#include <string_view>

namespace tetfarm {
namespace {

/// In single quotes.
std::string zsh_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// A text within a specification of _arguments, where colons and brackets have a meaning.
std::string zsh_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view(":[]\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zsh_action(const DeclaredOption& option) {
  const std::string words = joined_words(option.choices, " ");
  if (!words.empty()) return option.is_list ? "_sequence compadd - " + words : "(" + words + ")";
  if (option.completion == ValueCompletion::folder) return "_files -/";
  return option.completion == ValueCompletion::file ? "_files" : " ";
}

/// ":VALUE:what completes it"
std::string zsh_value(const DeclaredOption& option) {
  return ":" + zsh_escaped(option.value) + ":" + zsh_action(option);
}

/// One specification for each name: an option that was given is not offered again.
std::string zsh_specifications(const DeclaredOption& option) {
  std::string specifications;
  for (const std::string& name : option.names) {
    std::string one = option.may_repeat ? "*" : "(" + joined_words(option.names, " ") + ")";
    one += name;
    if (!option.value.empty()) one += name.starts_with("--") ? "=" : "+";
    one += "[" + zsh_escaped(in_brief(option.what)) + "]";
    if (!option.value.empty()) one += zsh_value(option);
    specifications += " \\\n    " + zsh_quoted(one);
  }
  return specifications;
}

std::string zsh_arguments(const DeclaredCommand& command) {
  std::string specifications;
  for (const DeclaredOption& argument : command.arguments) {
    const char* how_many = argument.may_repeat ? "*" : argument.is_required ? "" : ":";
    specifications += " \\\n    " + zsh_quoted(how_many + zsh_value(argument));
  }
  return specifications;
}

std::string name_of_zsh_function(const DeclaredCommand& command) {
  std::string name = "_tetfarm " + command.name;
  if (command.name.empty()) name.pop_back();
  for (char& c : name) c = c == ' ' ? '_' : c;
  return name;
}

/// "new" of "keys new".
std::string last_word(const DeclaredCommand& command) {
  return command.name.substr(command.name.rfind(' ') + 1);
}

/// What follows _arguments where commands are below this one.
std::string zsh_choice_of_command(const DeclaredCommand& command) {
  std::string text = " \\\n    '1:command:->command' '*::argument:->argument' && return\n";
  text += "  case $state in\n    command)\n      local -a commands=(\n";
  for (const DeclaredCommand& sub : command.commands) {
    text += "        " + zsh_quoted(last_word(sub) + ":" + sub.what) + "\n";
  }
  text += "      )\n      _describe -t commands command commands\n      ;;\n";
  text += "    argument)\n      case $words[1] in\n";
  for (const DeclaredCommand& sub : command.commands) {
    text += "        " + last_word(sub) + ") " + name_of_zsh_function(sub) + " ;;\n";
  }
  return text + "      esac\n      ;;\n  esac\n";
}

std::string zsh_functions(const DeclaredCommand& command) {
  std::string text;
  for (const DeclaredCommand& sub : command.commands) text += zsh_functions(sub);
  text += name_of_zsh_function(command) + "() {\n";
  const bool has_commands = !command.commands.empty();
  if (has_commands)
    text +=
        "  local curcontext=$curcontext context state state_descr line\n"
        "  local -A opt_args\n";
  text += has_commands ? "  _arguments -C" : "  _arguments";
  for (const DeclaredOption& option : command.options) text += zsh_specifications(option);
  text += has_commands ? zsh_choice_of_command(command) : zsh_arguments(command) + "\n";
  return text + "}\n\n";
}

}  // namespace

std::string zsh_completion(const DeclaredCommand& program) {
  return "#compdef tetfarm\n# Completion for zsh; `tetfarm completion zsh` prints it.\n\n" +
         zsh_functions(program) +
         "if [[ $funcstack[1] == _tetfarm ]]; then\n  _tetfarm \"$@\"\nelse\n"
         "  compdef _tetfarm tetfarm\nfi\n";
}

}  // namespace tetfarm
