#include "cli/about_command_line.h"

#include <string_view>
#include <vector>

#include "cli/client_options.h"
#include "cli/job_file_page.h"
#include "cli/option_checks.h"

namespace tetfarm {
namespace {

/// Of commands for people, and of the job file.
std::vector<std::string_view> names_of_pages(const CLI::App& app) {
  std::vector<std::string_view> names;
  for (const CLI::App* sub : app.get_subcommands({})) {
    if (!sub->get_group().empty()) names.emplace_back(sub->get_name());
  }
  names.emplace_back(name_of_job_file_page);
  return names;
}

}  // namespace

void add_about(CLI::App& app, About& about, const std::function<void(const Command&)>& chosen) {
  CLI::App& man = add_command(app, "man", "Print a page of the manual, for man or groff",
                              "tetfarm man run | man -l -", about.man, chosen);
  CLI::App& completion = add_command(
      app, "completion", "Print the script that makes a shell complete commands and options",
      "source <(tetfarm completion bash)", about.completion, chosen);
  completion.add_option("SHELL", about.completion.shell, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  CLI::App& version = add_command(app, "version", "Tell which program this is, and of what",
                                  "tetfarm version --json", about.version, chosen);
  add_json(version, about.version.json);
  CLI::Option* command =
      man.add_option("COMMAND", about.man.command,
                     "One command's page, or that of the job file: job (default: the program's)")
          ->check(suggested(names_of_pages(app)));
  man.add_option("-o,--output", about.man.output,
                 "Folder to write all pages into, as man1/tetfarm.1 and so on")
      ->option_text("DIR")
      ->excludes(command);
}

}  // namespace tetfarm
