#include "cli/declared_command.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "cli/command_line.h"
#include "cli/option_checks.h"
#include "tests/cli/other_programs.h"
#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A program with a command that has every kind of option.
class DeclaredCommandTest : public ::testing::Test {
 protected:
  CLI::Option& add(const char* name) { return *command_.add_option(name, text_, "What it is"); }

  DeclaredOption declared(const CLI::Option& option) const {
    const DeclaredCommand command = declared_command(app_).commands.at(0);
    for (const auto* options : {&command.options, &command.arguments}) {
      for (const DeclaredOption& one : *options) {
        if (one.names.empty() ? one.value == option.get_name(true)
                              : one.names.back() == option.get_name()) {
          return one;
        }
      }
    }
    ADD_FAILURE() << option.get_name() << " is not there";
    return {};
  }

  CLI::App app_{"What it makes", "tetfarm"};
  CLI::App& command_ = *app_.add_subcommand("make", "Make it");
  std::string text_;
  std::vector<std::string> texts_;
  bool flag_ = false;
};

TEST_F(DeclaredCommandTest, has_names_values_and_conditions) {
  CLI::Option& input = *add("INPUT").required();
  CLI::Option& output = *add("-o,--output").option_text("DIR")->envname("TETFARM_OUT");
  CLI::Option& size = *add("--size").needs(&output)->excludes(&input);
  EXPECT_THAT(declared(input).names, IsEmpty());
  EXPECT_EQ(declared(input).value, "INPUT");
  EXPECT_TRUE(declared(input).is_required);
  EXPECT_EQ(declared(input).completion, ValueCompletion::file);
  EXPECT_THAT(declared(output).names, ElementsAre("-o", "--output"));
  EXPECT_EQ(declared(output).value, "DIR");
  EXPECT_EQ(declared(output).what, "What it is");
  EXPECT_EQ(declared(output).variable, "TETFARM_OUT");
  EXPECT_EQ(declared(output).completion, ValueCompletion::folder);
  EXPECT_FALSE(declared(output).is_required);
  EXPECT_EQ(declared(size).value, "TEXT");
  EXPECT_EQ(declared(size).completion, ValueCompletion::none);
  EXPECT_THAT(declared(size).needs, ElementsAre("--output"));
  EXPECT_THAT(declared(size).excludes, ElementsAre("INPUT"));
}

TEST_F(DeclaredCommandTest, has_the_words_that_values_may_be) {
  EXPECT_THAT(declared(*add("--a").check(CLI::IsMember({"x", "y"}))).choices,
              ElementsAre("x", "y"));
  EXPECT_THAT(declared(*add("--b").option_text("box[:FACTOR]|G|off")).choices,
              ElementsAre("box", "off"));
  EXPECT_THAT(declared(*add("--c").check(CLI::IsMember({"x", "old"}))->option_text("x|y")).choices,
              ElementsAre("x", "y"))
      << "help shows these";
  const std::vector<std::string_view> known = {"lb8.ugrid", "su2"};
  const CLI::Option& suggesting = *add("--d").check(suggested(known))->option_text("F");
  EXPECT_THAT(declared(suggesting).choices, ElementsAre("lb8.ugrid", "su2"));
  EXPECT_THAT(declared(*add("--e").check(positive_number())->option_text("H")).choices, IsEmpty());
}

TEST_F(DeclaredCommandTest, knows_what_may_be_given_more_than_once) {
  const CLI::Option& many = *command_.add_option("--many", texts_);
  const CLI::Option& list = *command_.add_option("--list", texts_)->delimiter(',');
  EXPECT_TRUE(declared(many).may_repeat);
  EXPECT_FALSE(declared(many).is_list);
  EXPECT_TRUE(declared(list).is_list);
  EXPECT_FALSE(declared(add("--one")).may_repeat);
}

TEST_F(DeclaredCommandTest, has_flags_without_a_value) {
  EXPECT_EQ(declared(*command_.add_flag("--force", flag_)).value, "");
  const CLI::Option& no = *command_.add_flag("!--no-check", flag_);
  EXPECT_THAT(declared(no).names, ElementsAre("--no-check"));
  EXPECT_EQ(declared(no).value, "");
}

TEST_F(DeclaredCommandTest, leaves_out_what_is_hidden) {
  command_.add_flag("--secret", flag_)->group("");
  app_.add_subcommand("hidden", "")->group("");
  const DeclaredCommand program = declared_command(app_);
  ASSERT_EQ(program.commands.size(), 1U);
  ASSERT_EQ(program.commands[0].options.size(), 1U);
  EXPECT_THAT(program.commands[0].options[0].names, ElementsAre("-h", "--help"));
}

TEST_F(DeclaredCommandTest, divides_the_footer) {
  command_.footer("Formats:\n  a\n\nExample: tetfarm make it");
  const DeclaredCommand command = declared_command(app_).commands.at(0);
  EXPECT_EQ(command.example, "tetfarm make it");
  EXPECT_EQ(command.notes, "Formats:\n  a\n\n");
}

TEST_F(DeclaredCommandTest, names_commands_with_those_above_them) {
  command_.add_subcommand("again", "Make it again");
  const DeclaredCommand program = declared_command(app_);
  EXPECT_EQ(program.name, "");
  EXPECT_EQ(program.commands.at(0).name, "make");
  EXPECT_EQ(program.commands.at(0).commands.at(0).name, "make again");
}

TEST(DeclaredCommandInBrief, ends_before_what_is_said_besides) {
  EXPECT_EQ(in_brief("Folder (default: out)"), "Folder");
  EXPECT_EQ(in_brief("Folder; made anew: always"), "Folder");
  EXPECT_EQ(in_brief("For ssh: hosts"), "For ssh: hosts");
  EXPECT_EQ(in_brief("All"), "All");
}

/// The options that a line of help begins with, such as "  -o,--output DIR".
void collect_options_of_help(const std::string& line, std::set<std::string>& names) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin != 2 || line[begin] != '-') return;
  std::string word = line.substr(begin, line.find_first_of(" =", begin) - begin);
  std::replace(word.begin(), word.end(), ',', ' ');
  std::istringstream words(word);
  for (std::string name; words >> name;) names.insert(name.substr(0, name.find('{')));
}

TEST(DeclaredCommands, are_those_of_help_with_all_their_options) {
  for (const DeclaredCommand& command : with_all_below(declared_commands())) {
    std::vector<std::string> words;
    std::istringstream stream(command.name + " --help");
    for (std::string word; stream >> word;) words.push_back(word);
    ::testing::internal::CaptureStdout();
    parsed(words);
    std::set<std::string> of_help;
    for (const std::string& line : lines_of(::testing::internal::GetCapturedStdout())) {
      collect_options_of_help(line, of_help);
    }
    std::set<std::string> of_declaration;
    for (const DeclaredOption& option : command.options) {
      of_declaration.insert(option.names.begin(), option.names.end());
      EXPECT_NE(option.what, "") << command.name << " " << option.names.front();
    }
    EXPECT_EQ(of_declaration, of_help) << command.name;
  }
}

// A new name for a value is either among those that stand for files or folders, or here.
TEST(DeclaredCommands, have_values_of_which_it_is_known_whether_they_are_paths) {
  const std::set<std::string> no_paths = {"A",
                                          "C",
                                          "D",
                                          "DEG",
                                          "F",
                                          "G",
                                          "H",
                                          "H:MM:SS",
                                          "JOB",
                                          "JOB|TASK",
                                          "K",
                                          "KIND",
                                          "L",
                                          "LENGTH",
                                          "MARGIN",
                                          "MS",
                                          "N",
                                          "NAME",
                                          "P",
                                          "RE",
                                          "SECONDS",
                                          "SHARE",
                                          "SIZE",
                                          "T",
                                          "TASK",
                                          "TEXT",
                                          "W",
                                          "WORKER",
                                          "WxH",
                                          "X,Y,Z",
                                          "Y",
                                          "Z",
                                          "1.2GHz",
                                          "2GiB",
                                          "LOW,HIGH",
                                          "PATCH,...",
                                          "PATCH=KIND",
                                          "NAME:N,...",
                                          "POOL/JOB",
                                          "127.0.0.1:8080",
                                          "tcp://HOST:PORT",
                                          "tcp://ADDRESS:PORT",
                                          "PATCH,...:KEY=VALUE,...",
                                          "PATCH,...=TYPE",
                                          "PATCH,...=H[:G]",
                                          "y=0",
                                          "PATCH,...[:KEY=VALUE,...]"};
  for (const DeclaredCommand& command : with_all_below(declared_commands())) {
    for (const auto* options : {&command.options, &command.arguments}) {
      for (const DeclaredOption& option : *options) {
        const bool is_known = option.value.empty() || !option.choices.empty() ||
                              option.completion != ValueCompletion::none ||
                              no_paths.contains(option.value);
        EXPECT_TRUE(is_known) << command.name << ": " << option.value;
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
