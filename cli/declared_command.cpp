#include "cli/declared_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/check.h"

namespace tetfarm {
namespace {

// What values are called in help where they are paths.
constexpr std::array<std::string_view, 2> folder_values = {"DIR", "STORE"};
constexpr std::array<std::string_view, 15> file_values = {
    "FILE", "INPUT", "IN",   "OUT",      "MESH",     "BOUNDARY",   "KEY",    "PNG",
    "HTML", "JSON",  "PATH", "NAME.key", "FILE.pub", "MESH,FIELD", "SURFACE"};

ValueCompletion completion_of(const std::string& value) {
  const auto is_in = [&](const auto& names) {
    return std::find(names.begin(), names.end(), value) != names.end();
  };
  if (is_in(folder_values)) return ValueCompletion::folder;
  return is_in(file_values) ? ValueCompletion::file : ValueCompletion::none;
}

std::vector<std::string> split_at(std::string_view text, char border) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(border), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// A word to be typed as it is; other values are in capital letters.
bool is_word(std::string_view text) {
  const auto may_be = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  };
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' &&
         std::all_of(text.begin(), text.end(), may_be);
}

/// "box" and "sphere" of "box[:FACTOR]|sphere[:FACTOR]", "off" of "G|off".
std::vector<std::string> words_of_value(const std::string& value) {
  std::vector<std::string> words;
  if (value.find('|') == std::string::npos) return words;
  for (const std::string& part : split_at(value, '|')) {
    const std::string word = part.substr(0, part.find('['));
    if (is_word(word)) words.push_back(word);
  }
  return words;
}

/// "a" and "b" of "TEXT:{a,b}", which is how the checks of a value describe its words.
std::vector<std::string> words_of_checks(const std::string& type) {
  std::vector<std::string> words;
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return words;
  for (std::string word : split_at(type.substr(begin + 1, end - begin - 1), ',')) {
    word.erase(0, word.find_first_not_of(' '));
    if (is_word(word)) words.push_back(word);
  }
  return words;
}

std::string name_for_people(const CLI::Option& option) {
  return option.get_name(option.get_positional());
}

std::vector<std::string> sorted_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(name_for_people(*option));
  std::sort(names.begin(), names.end());
  return names;
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

std::string value_of(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  if (is_flag(option)) return "";
  const std::string& text = option.get_option_text();
  return text.empty() ? split_at(option.get_type_name(), ':').front() : text;
}

DeclaredOption declared_option(const CLI::Option& option) {
  DeclaredOption declared;
  for (const std::string& name : option.get_snames()) declared.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) declared.names.push_back("--" + name);
  TF_CHECK(declared.names.empty() == option.get_positional());
  declared.value = value_of(option);
  declared.what = option.get_description();
  declared.choices = words_of_value(declared.value);
  if (declared.choices.empty()) declared.choices = words_of_checks(option.get_type_name());
  declared.completion = completion_of(declared.value);
  declared.is_list = option.get_delimiter() != '\0';
  declared.may_repeat = option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
  declared.is_required = option.get_required();
  declared.variable = option.get_envname();
  declared.needs = sorted_names(option.get_needs());
  declared.excludes = sorted_names(option.get_excludes());
  return declared;
}

/// The footer: an example, or lines and then an example.
void take_footer(const std::string& footer, DeclaredCommand& declared) {
  constexpr std::string_view mark = "Example: ";
  const std::size_t at = footer.rfind(mark);
  declared.notes = footer.substr(0, at);
  if (at != std::string::npos) declared.example = footer.substr(at + mark.size());
}

DeclaredCommand declared_below(const CLI::App& app, const std::string& name) {
  DeclaredCommand declared;
  declared.name = name;
  declared.what = app.get_description();
  declared.purpose = app.get_group();
  take_footer(app.get_footer(), declared);
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? declared.arguments : declared.options)
        .push_back(declared_option(*option));
  }
  for (const CLI::App* sub : app.get_subcommands({})) {
    if (sub->get_group().empty()) continue;
    declared.commands.push_back(
        declared_below(*sub, (name.empty() ? "" : name + " ") + sub->get_name()));
  }
  return declared;
}

}  // namespace

DeclaredCommand declared_command(const CLI::App& app) { return declared_below(app, ""); }

std::string in_brief(const std::string& what) {
  std::size_t end = what.size();
  for (const char* border : {"; ", " ("}) end = std::min(end, what.find(border));
  return what.substr(0, end);
}

std::string joined_words(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace tetfarm
