#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/error_with_help.h"
#include "base/file_system.h"
#include "base/program_version.h"
#include "cli/commands.h"
#include "cli/did_you_mean.h"
#include "cli/job_file_page.h"
#include "cli/manual_page.h"

namespace tetfarm {
namespace {

[[noreturn]] void refuse_page(const std::string& name, const DeclaredCommand& program) {
  std::vector<std::string_view> known;
  for (const DeclaredCommand& command : program.commands) known.push_back(command.name);
  known.emplace_back(name_of_job_file_page);
  throw ErrorWithHelp(ExitCode::usage,
                      "unknown command " + in_ticks(name) + did_you_mean(name, known),
                      "`tetfarm --help` lists the commands");
}

ManualPage page_about(const std::string& name, const DeclaredCommand& program) {
  if (name.empty()) return manual_page(program, program_version);
  if (name == name_of_job_file_page) return job_file_page(program_version);
  for (const DeclaredCommand& command : program.commands) {
    if (command.name == name) return manual_page_of(command, program, program_version);
  }
  refuse_page(name, program);
}

void write_page(const ManualPage& page, const std::filesystem::path& folder) {
  const std::string section = std::to_string(page.section);
  const std::filesystem::path chapter = folder / ("man" + section);
  make_folders(chapter);
  write_file_atomically(chapter / (page.name + "." + section), page.text);
}

}  // namespace

ExitCode man_command(const ManCommand& command) {
  const DeclaredCommand program = declared_commands();
  if (command.output.empty()) {
    std::fputs(page_about(command.command, program).text.c_str(), stdout);
    return ExitCode::ok;
  }
  write_page(page_about("", program), command.output);
  write_page(page_about(name_of_job_file_page, program), command.output);
  for (const DeclaredCommand& one : program.commands) {
    write_page(page_about(one.name, program), command.output);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
