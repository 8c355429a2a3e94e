/// The commands with their options as plain data, taken from their declarations: for what tells of
/// them elsewhere than in --help, such as completion in shells and manual pages.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tetfarm {

/// How a shell may complete a value that is none of a few words.
enum class ValueCompletion { none, file, folder };

/// An option, or an argument, which has no name.
struct DeclaredOption {
  std::vector<std::string> names;  ///< "-o", "--output"; empty: an argument
  std::string value;               ///< "DIR"; "": a flag, which takes none
  std::string what;
  std::vector<std::string> choices;  ///< words that its value may be, maybe beside others
  ValueCompletion completion = ValueCompletion::none;
  bool is_list = false;  ///< a value may be several, with commas between them
  bool may_repeat = false;
  bool is_required = false;
  std::string variable;               ///< of the environment, that stands for it; "": none
  std::vector<std::string> needs;     ///< by name or, an argument, by its value; sorted
  std::vector<std::string> excludes;  ///< likewise
};

struct DeclaredCommand {
  std::string name;     ///< "run", "keys new"; "" of the program
  std::string what;     ///< one line
  std::string purpose;  ///< see command_purposes.h
  std::string example;  ///< a line; "": none
  std::string notes;    ///< lines as they are; "": none
  std::vector<DeclaredOption> options;
  std::vector<DeclaredOption> arguments;  ///< in their order
  std::vector<DeclaredCommand> commands;  ///< below it; one of them has to be given
};

/// All that a person may use: hidden commands and options are left out.
DeclaredCommand declared_command(const CLI::App& app);

/// The first words of what an option or a command is for, for a list of many.
std::string in_brief(const std::string& what);

/// "a, b, c" with ", " between them.
std::string joined_words(const std::vector<std::string>& words, const std::string& between);

}  // namespace tetfarm
