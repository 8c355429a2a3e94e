#include "cli/manual_page.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "base/check.h"
#include "cli/command_purposes.h"
#include "cli/exit_codes.h"
#include "cli/roff_text.h"

namespace tetfarm {
namespace {

struct ToldOnPage {
  const char* name;
  const char* what;
};

constexpr std::array<ToldOnPage, 5> told_files = {
    {{"DIR/.tetfarm",
      "What a run in the output folder DIR needs to go on after an interruption: its store, its "
      "database and the logs of its tasks."},
     {"/etc/tetfarm/keys", "The keys of a coordinator that root runs."},
     {"$XDG_CONFIG_HOME/tetfarm/keys",
      "Those of others; without the variable ~/.config/tetfarm/keys."},
     {"STORE/coordinator.pub",
      "The public key of the coordinator that uses the store, as it leaves it there."},
     {"NAME.defects.vtp", "The bad triangles of a surface, which check and run write."}}};

constexpr std::array<ToldOnPage, 2> told_variables = {
    {{"NO_COLOR", "Where it is set, nothing is shown in red."},
     {"TMPDIR", "The folder for temporary files, where no option names another."}}};

constexpr const char* told_of_program =
    "Fills a closed triangulated surface with tetrahedra, on as many machines as there are: it "
    "cuts "
    "the domain into sub-domains, worker processes mesh these one by one, and one conforming mesh "
    "comes out, the same to the last bit whatever the number of workers and whichever of them "
    "fail. "
    "Data goes to standard output, progress and messages to standard error; with --json the data "
    "are "
    "JSON, one object per line.";

/// "tetfarm-run", of the program "tetfarm".
std::string page_name(const DeclaredCommand& command) {
  return command.name.empty() ? "tetfarm" : "tetfarm-" + command.name;
}

int page_section(const DeclaredCommand& command) { return command.purpose == of_operators ? 8 : 1; }

std::string reference_to(const DeclaredCommand& command) {
  return roff_bold(page_name(command)) + "(" + std::to_string(page_section(command)) + ")";
}

std::string header_of_page(const DeclaredCommand& command, const std::string& version) {
  std::string title = page_name(command);
  // "Tetfarm: …"
  const std::string what =
      command.what.substr(command.name.empty() ? command.what.find(' ') + 1 : 0);
  for (char& c : title) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return ".TH " + roff_text(title) + " " + std::to_string(page_section(command)) +
         " \"\" \"tetfarm " + version + "\" \"Tetfarm\"\n.SH NAME\n" +
         roff_text(page_name(command)) + " \\- " + roff_text(what) + "\n";
}

/// "-o FILE", by its last name.
std::string option_in_synopsis(const DeclaredOption& option) {
  TF_CHECK(!option.names.empty());
  return roff_bold(option.names.back()) +
         (option.value.empty() ? "" : " " + roff_italic(option.value));
}

/// "tetfarm export FILE --output OUT [options]"
std::string synopsis_of(const DeclaredCommand& command) {
  std::string line = roff_bold("tetfarm" + (command.name.empty() ? "" : " " + command.name));
  if (!command.commands.empty()) line += " " + roff_italic("command");
  for (const DeclaredOption& argument : command.arguments) {
    const std::string name = roff_italic(argument.value) + (argument.may_repeat ? " ..." : "");
    line += argument.is_required ? " " + name : " [" + name + "]";
  }
  for (const DeclaredOption& option : command.options) {
    if (option.is_required) line += " " + option_in_synopsis(option);
  }
  return line + " [" + roff_italic("options") + "]\n";
}

std::string full_stop(const std::string& sentence) {
  return sentence.empty() || sentence.ends_with('.') ? sentence : sentence + ".";
}

/// What is to be known of an option beside what its declaration says in words.
std::string conditions_of(const DeclaredOption& option) {
  std::string text;
  const bool is_in_value = option.value.find('|') != std::string::npos;
  if (!option.choices.empty() && !is_in_value) {
    text += option.is_list ? " Known are " : " One of ";
    text += joined_words(option.choices, ", ") + ".";
  }
  if (option.is_required && !option.names.empty()) text += " Required.";
  if (!option.needs.empty()) text += " Needs " + joined_words(option.needs, ", ") + ".";
  if (!option.excludes.empty()) text += " Not with " + joined_words(option.excludes, ", ") + ".";
  if (!option.variable.empty()) text += " Where it is not given, $" + option.variable + " counts.";
  return text;
}

std::string option_entry(const DeclaredOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(roff_bold(name));
  std::string head = joined_words(names, ", ");
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + roff_italic(option.value);
  return roff_entry(head, full_stop(option.what) + conditions_of(option));
}

std::string entries_of(const DeclaredCommand& command) {
  std::string text;
  for (const DeclaredOption& argument : command.arguments) text += option_entry(argument);
  for (const DeclaredOption& option : command.options) text += option_entry(option);
  return text;
}

/// One after the other: a command that has others below it is told with them.
template <class Tell>
void tell_each(const DeclaredCommand& command, const Tell& tell) {
  tell(command);
  for (const DeclaredCommand& sub : command.commands) tell_each(sub, tell);
}

std::string section_of_commands(const DeclaredCommand& command) {
  std::string text;
  std::string purpose;
  for (const DeclaredCommand& sub : command.commands) {
    if (command.name.empty() && sub.purpose != purpose) {
      text += ".SS " + roff_text(purpose = sub.purpose) + "\n";
    }
    const std::string head = command.name.empty() ? reference_to(sub) : synopsis_of(sub);
    text += roff_entry(head.substr(0, head.find('\n')), sub.what);
  }
  return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string section_of_options(const DeclaredCommand& command) {
  std::string text = ".SH OPTIONS\n";
  tell_each(command, [&](const DeclaredCommand& one) {
    if (&one != &command) text += ".SS tetfarm " + roff_text(one.name) + "\n" + synopsis_of(one);
    text += entries_of(one);
  });
  return text;
}

std::string section_of_exit_codes() {
  std::string text = ".SH EXIT STATUS\n";
  for (const MeaningOfCode& code : exit_codes()) {
    text += roff_entry(roff_bold(std::to_string(static_cast<int>(code.code))), code.meaning);
  }
  return text;
}

/// variable -> the option that it stands for
std::map<std::string, std::string> variables_of(const DeclaredCommand& command) {
  std::map<std::string, std::string> found;
  tell_each(command, [&](const DeclaredCommand& one) {
    for (const DeclaredOption& option : one.options) {
      if (!option.variable.empty()) found.emplace(option.variable, option.names.front());
    }
  });
  return found;
}

std::string section_of_variables(const DeclaredCommand& command) {
  std::string text;
  for (const auto& [variable, option] : variables_of(command)) {
    text += roff_entry(roff_bold(variable), "Counts where " + option + " is not given.");
  }
  for (const auto& [name, what] : told_variables) text += roff_entry(roff_bold(name), what);
  return ".SH ENVIRONMENT\n" + text;
}

std::string section_of_files() {
  std::string text = ".SH FILES\n";
  for (const auto& [name, what] : told_files) text += roff_entry(roff_italic(name), what);
  return text;
}

std::string section_of_example(const DeclaredCommand& command) {
  std::string text;
  tell_each(command, [&](const DeclaredCommand& one) {
    if (!one.example.empty()) text += one.example + "\n";
  });
  return ".SH EXAMPLES\n" + roff_lines(text);
}

bool takes_job_file(const DeclaredCommand& command) {
  return std::any_of(command.arguments.begin(), command.arguments.end(),
                     [](const DeclaredOption& argument) { return argument.value == "INPUT"; });
}

/// The program, and the commands that have the same purpose; the job file.
std::string section_of_references(const DeclaredCommand& command, const DeclaredCommand& program) {
  std::vector<std::string> references;
  if (!command.name.empty()) references.push_back(reference_to(program));
  for (const DeclaredCommand& other : program.commands) {
    const bool is_near = command.name.empty() || other.purpose == command.purpose;
    if (is_near && other.name != command.name) references.push_back(reference_to(other));
  }
  if (command.name.empty() || takes_job_file(command)) {
    references.push_back(roff_bold("tetfarm-job") + "(5)");
  }
  return ".SH SEE ALSO\n" + joined_words(references, ",\n") + "\n";
}

}  // namespace

ManualPage manual_page(const DeclaredCommand& program, const std::string& version) {
  std::string text = header_of_page(program, version) + ".SH SYNOPSIS\n" + synopsis_of(program);
  text += ".SH DESCRIPTION\n" + roff_text(told_of_program) + "\n" + section_of_commands(program);
  text += section_of_options(program) + section_of_exit_codes() + section_of_variables(program);
  text += section_of_files() + section_of_example(program);
  text += section_of_references(program, program);
  return {page_name(program), page_section(program), text};
}

ManualPage manual_page_of(const DeclaredCommand& command, const DeclaredCommand& program,
                          const std::string& version) {
  TF_CHECK(!command.name.empty());
  std::string text = header_of_page(command, version) + ".SH SYNOPSIS\n" + synopsis_of(command);
  text += ".SH DESCRIPTION\n" + roff_text(full_stop(command.what)) + "\n";
  text += section_of_commands(command) + section_of_options(command);
  if (!command.notes.empty()) text += ".SH NOTES\n" + roff_lines(command.notes);
  text += section_of_exit_codes() + section_of_variables(command) + section_of_example(command);
  text += section_of_references(command, program);
  return {page_name(command), page_section(command), text};
}

}  // namespace tetfarm
