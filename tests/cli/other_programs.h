// Shells and readers of manual pages, which judge what the program prints for them. They have to be
// there (./dev packages).
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "cli/declared_command.h"
#include "tests/support/program.h"

namespace tetfarm {

/// What `words`, of which the first is found in $PATH, print in `folder`; they must end well and
/// complain of nothing.
inline std::string printed_by(const std::vector<std::string>& words,
                              const std::filesystem::path& folder) {
  const test::Ended ended = test::Program(words, folder, {"/usr/bin/env"}).wait();
  EXPECT_EQ(ended.code, 0) << words.front() << ": " << ended.out << ended.err;
  EXPECT_EQ(ended.err, "") << words.front();
  return ended.out;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The program and all commands, those below others too.
inline std::vector<DeclaredCommand> with_all_below(const DeclaredCommand& command) {
  std::vector<DeclaredCommand> all = {command};
  for (const DeclaredCommand& sub : command.commands) {
    for (DeclaredCommand& below : with_all_below(sub)) all.push_back(std::move(below));
  }
  return all;
}

}  // namespace tetfarm
