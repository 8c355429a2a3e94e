#include "cli/error_help.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>

#include "base/error_with_help.h"

namespace tetfarm {
namespace {

std::string help_of(ExitCode code, const std::string& command) {
  return help_for(Error(code, "message"), command);
}

TEST(ErrorHelp, of_a_wrong_command_line_names_the_help_of_its_command) {
  const UsageError error("must be a number", "--size");
  EXPECT_EQ(help_for(error, "run"), "see `tetfarm run --help`");
  EXPECT_EQ(help_for(error, ""), "see `tetfarm --help`");
  EXPECT_EQ(help_for(error, "--versoin"), "see `tetfarm --help`");
  for (const char* command : {"coordinator", "worker", "pool", "keys"}) {
    EXPECT_EQ(help_for(error, command),
              std::string("see `tetfarm ") + command + " --help` and docs/security.md");
  }
}

TEST(ErrorHelp, of_a_wrong_job_file_names_the_page_about_job_files) {
  const UsageError error("unknown key", "wing.toml:3:1");
  EXPECT_EQ(help_for(error, "run"), "see `tetfarm run --help` and docs/job_file.md");
  EXPECT_EQ(help_for(error, "pool"), "see `tetfarm pool --help` and docs/job_file.md");
  EXPECT_EQ(help_for(UsageError("is a folder", "wing.stl"), "run"), "see `tetfarm run --help`");
}

TEST(ErrorHelp, of_bad_geometry_says_where_to_repair) {
  const std::string repair =
      "repair the input there, or mend it by `tetfarm surface --heal-only`; "
      "`tetfarm check` shows every defect of the surface, and which of them healing would mend";
  for (const char* command : {"run", "plan", "submit", "wait", "init"}) {
    EXPECT_EQ(help_of(ExitCode::bad_geometry, command), repair) << command;
  }
  EXPECT_EQ(help_of(ExitCode::bad_geometry, "check"), "repair the input there");
  for (const char* command : {"quality", "convert", ""}) {
    EXPECT_EQ(help_of(ExitCode::bad_geometry, command), "") << command;
  }
}

TEST(ErrorHelp, of_what_is_missing_sends_to_the_path_or_to_the_coordinator) {
  EXPECT_EQ(help_for(IoError("cannot open", "a.stl", ENOENT), "submit"), "check the path");
  for (const char* command :
       {"submit", "status", "wait", "priority", "cancel", "retry", "drain", "jobs", "tasks",
        "workers", "events", "logs", "explain", "trace", "report", "pool", "worker", "dashboard"}) {
    EXPECT_EQ(help_of(ExitCode::not_found, command),
              "check the name, and that the coordinator is running and can be reached")
        << command;
  }
  for (const char* command : {"run", "quality", "gc", "keys", "coordinator", ""}) {
    EXPECT_EQ(help_of(ExitCode::not_found, command), "") << command;
  }
}

TEST(ErrorHelp, of_a_failure_says_where_the_logs_are_and_how_to_go_on) {
  EXPECT_EQ(help_of(ExitCode::failed, "run"),
            "the logs are in .tetfarm in the output folder; run the same command again to retry");
  EXPECT_EQ(help_of(ExitCode::failed, "wait"), "`tetfarm logs JOB` shows the output of its tasks");
  EXPECT_EQ(help_of(ExitCode::failed, "submit"), "");
  EXPECT_EQ(help_of(ExitCode::out_of_resources, "run"),
            "make room, then run the same command again to continue");
  EXPECT_EQ(help_of(ExitCode::out_of_resources, "export"), "make room, then try again");
}

TEST(ErrorHelp, of_a_path_that_is_barred_sends_to_the_path_and_not_to_logs_that_are_not_there) {
  for (const int number : {EACCES, EPERM, EROFS, ENOTDIR, EISDIR, ENAMETOOLONG}) {
    EXPECT_EQ(help_for(IoError("cannot create the folder", "out", number), "run"),
              "check the path, and what you may read and write there")
        << number;
  }
  EXPECT_EQ(help_for(IoError("cannot read", "out", EIO), "run"), help_of(ExitCode::failed, "run"));
}

TEST(ErrorHelp, of_an_error_that_has_its_own_is_that_one) {
  EXPECT_EQ(help_for(ErrorWithHelp(ExitCode::usage, "message", "do this"), "run"), "do this");
  EXPECT_EQ(help_for(ErrorWithHelp(ExitCode::usage, "message", ""), "run"), "");
}

TEST(ErrorHelp, a_complaint_has_a_line_of_help_only_where_there_is_some) {
  EXPECT_EQ(complaint("it broke", "mend it"), "error: it broke\nhelp: mend it\n");
  EXPECT_EQ(complaint("it broke", ""), "error: it broke\n");
}

}  // namespace
}  // namespace tetfarm
