#include <cstdio>

#include "base/check.h"
#include "cli/bash_completion.h"
#include "cli/commands.h"
#include "cli/fish_completion.h"
#include "cli/zsh_completion.h"

namespace tetfarm {

ExitCode completion_command(const CompletionCommand& command) {
  const DeclaredCommand program = declared_commands();
  std::string script;
  if (command.shell == "bash") script = bash_completion(program);
  if (command.shell == "zsh") script = zsh_completion(program);
  if (command.shell == "fish") script = fish_completion(program);
  TF_CHECK(!script.empty());
  std::fputs(script.c_str(), stdout);
  return ExitCode::ok;
}

}  // namespace tetfarm
