/// Manual pages of the program and of each command, as roff (man(7)) and by the same declarations
/// as
/// --help.
#pragma once

#include <string>

#include "cli/declared_command.h"

namespace tetfarm {

struct ManualPage {
  std::string name;  ///< "tetfarm-run"
  int section = 1;   ///< 8 of what those use who keep a farm running, 5 of files
  std::string text;
};

/// tetfarm(1), with every command and its options. @param version "0.1.0"
ManualPage manual_page(const DeclaredCommand& program, const std::string& version);

/// One command's, with those below it. @pre `command` is one of `program`.
ManualPage manual_page_of(const DeclaredCommand& command, const DeclaredCommand& program,
                          const std::string& version);

}  // namespace tetfarm
