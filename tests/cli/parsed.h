// Command lines parsed as main parses them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/command_line.h"

namespace tetfarm {

inline Command parsed(const std::vector<std::string>& words) {
  std::vector<const char*> arguments = {"tetfarm"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

template <class Options>
Options parsed_as(const std::vector<std::string>& words) {
  return std::get<Options>(parsed(words));
}

/// What is wrong with a command line, which must be wrong.
inline std::string refusal_of(const std::vector<std::string>& words) {
  try {
    parsed(words);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return error.what();
  }
  return "it was taken";
}

/// A command line and what is wrong with it.
struct Refused {
  std::vector<std::string> words;
  std::string message;
};
inline void expect_refused(const std::vector<Refused>& table) {
  for (const Refused& refused : table) {
    std::string line;
    for (const std::string& word : refused.words) line += " " + word;
    EXPECT_EQ(refusal_of(refused.words), refused.message) << line;
  }
}

/// What help says of a command, all blanks as one.
inline std::string help_words(const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  words.push_back("--help");
  ::testing::internal::CaptureStdout();
  EXPECT_TRUE(std::holds_alternative<NothingToDo>(parsed(words)));
  std::string text;
  for (const char c : ::testing::internal::GetCapturedStdout()) {
    const bool is_blank = c == ' ' || c == '\n';
    if (!is_blank) text += c;
    if (is_blank && !text.ends_with(' ')) text += ' ';
  }
  return text;
}

/// Without variables that stand for options.
class PlainEnvironment : public ::testing::Test {
 protected:
  PlainEnvironment() {
    for (const char* name : {"TETFARM_COORDINATOR", "TETFARM_STORE", "TETFARM_KEY", "TETFARM_KEYS",
                             "TETFARM_COORDINATOR_KEY"}) {
      ::unsetenv(name);
    }
  }
};

}  // namespace tetfarm
