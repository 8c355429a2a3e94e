#include "cli/bash_completion.h"

#include <utility>
#include <vector>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr const char* walk_of_bash = R"(
_tetfarm() {
  local current=${COMP_WORDS[COMP_CWORD]} command='' expected='' arguments=0 word i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ $word == [=:]* ]]; then
      # bash has divided a value: --option=value, tcp://host:port.
      [[ $word == '=' && -n $expected ]] || ((++i))
    elif [[ -n $expected ]]; then
      expected=
    elif [[ $word == -?* ]]; then
      _tetfarm_expect "$command" "$word"
    else
      _tetfarm_expect "$command" "$arguments"
      if [[ $expected == 'commands '* ]]; then
        command=${command:+$command }$word
      else
        ((++arguments))
      fi
      expected=
    fi
  done
  ((i == COMP_CWORD)) || return 0
  if [[ $current == [=:]* ]]; then
    [[ $current == '=' && -n $expected ]] || return 0
    current=
  fi
  if [[ -z $expected ]]; then
    [[ $current == -* ]] || _tetfarm_expect "$command" "$arguments"
    [[ -n $expected ]] || _tetfarm_expect "$command" -
  fi
  local before=''
  case $expected in
    files) compopt -o default ;;
    folders) compopt -o dirnames ;;
    list\ *)
      [[ $current != *,* ]] || before=${current%,*},
      mapfile -t COMPREPLY < <(compgen -P "$before" -W "${expected#* }" -- "${current##*,}")
      ;;
    *\ *) mapfile -t COMPREPLY < <(compgen -W "${expected#* }" -- "$current") ;;
  esac
}

complete -F _tetfarm tetfarm
)";

/// What is expected, as the script tells it, and the patterns of what it is expected after.
using BashExpectations = std::vector<std::pair<std::string, std::vector<std::string>>>;

std::string bash_expectation(const DeclaredOption& option) {
  if (!option.choices.empty()) {
    return (option.is_list ? "list " : "words ") + joined_words(option.choices, " ");
  }
  if (option.completion == ValueCompletion::folder) return "folders";
  return option.completion == ValueCompletion::file ? "files" : "anything";
}

void expect_in_bash(BashExpectations& all, const std::string& expected,
                    const std::string& pattern) {
  for (auto& [known, patterns] : all) {
    if (known == expected) return patterns.push_back(pattern);
  }
  all.push_back({expected, {pattern}});
}

BashExpectations bash_expectations(const DeclaredCommand& command) {
  BashExpectations all;
  std::vector<std::string> names;
  for (const DeclaredOption& option : command.options) {
    for (const std::string& name : option.names) {
      TF_CHECK(name.size() > 1 && name.find_first_of(" '*?[") == std::string::npos);
      names.push_back(name);
      if (!option.value.empty()) expect_in_bash(all, bash_expectation(option), name);
    }
  }
  all.push_back({"words " + joined_words(names, " "), {"-"}});
  if (!command.commands.empty()) {
    std::vector<std::string> below;
    for (const DeclaredCommand& sub : command.commands) {
      below.push_back(sub.name.substr(sub.name.rfind(' ') + 1));
    }
    all.push_back({"commands " + joined_words(below, " "), {"0"}});
  }
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const DeclaredOption& argument = command.arguments[i];
    all.push_back({bash_expectation(argument),
                   {argument.may_repeat ? std::string("[0-9]*") : std::to_string(i)}});
  }
  return all;
}

std::string bash_case_of(const DeclaredCommand& command) {
  std::string text = "    '" + command.name + "')\n      case $2 in\n";
  for (const auto& [expected, patterns] : bash_expectations(command)) {
    text += "        " + joined_words(patterns, " | ") + ") expected='" + expected + "' ;;\n";
  }
  text += "      esac\n      ;;\n";
  for (const DeclaredCommand& sub : command.commands) text += bash_case_of(sub);
  return text;
}

}  // namespace

std::string bash_completion(const DeclaredCommand& program) {
  return "# Completion for bash; `tetfarm completion bash` prints it.\n"
         "\n"
         "# Sets `expected` to what may come in the command $1: as its argument number $2, after "
         "its\n"
         "# option $2 or, where that is -, in the place of an option.\n"
         "_tetfarm_expect() {\n"
         "  expected=\n"
         "  case $1 in\n" +
         bash_case_of(program) + "  esac\n}\n" + walk_of_bash;
}

}  // namespace tetfarm
