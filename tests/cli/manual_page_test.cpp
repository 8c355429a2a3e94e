#include "cli/manual_page.h"

#include <gmock/gmock.h>

#include "cli/command_line.h"
#include "cli/exit_codes.h"
#include "cli/roff_text.h"
#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;
using ::testing::Not;

const DeclaredCommand& the_program() {
  static const DeclaredCommand program = declared_commands();
  return program;
}

ManualPage page_called(const std::string& name) {
  for (const DeclaredCommand& command : the_program().commands) {
    if (command.name == name) return manual_page_of(command, the_program(), "0.1.0");
  }
  ADD_FAILURE() << name;
  return {};
}

std::vector<ManualPage> all_pages() {
  std::vector<ManualPage> pages = {manual_page(the_program(), "0.1.0")};
  for (const DeclaredCommand& command : the_program().commands) {
    pages.push_back(manual_page_of(command, the_program(), "0.1.0"));
  }
  return pages;
}

void expect_told(const DeclaredCommand& command, const std::string& page) {
  for (const DeclaredCommand& one : with_all_below(command)) {
    for (const DeclaredOption& option : one.options) {
      for (const std::string& name : option.names) {
        EXPECT_THAT(page, HasSubstr(roff_bold(name))) << one.name;
      }
      EXPECT_THAT(page, HasSubstr(roff_text(option.what))) << one.name;
    }
    for (const DeclaredOption& argument : one.arguments) {
      EXPECT_THAT(page, HasSubstr(".TP\n" + roff_italic(argument.value) + "\n")) << one.name;
    }
  }
}

TEST(ManualPages, tell_every_option_of_every_command) {
  expect_told(the_program(), manual_page(the_program(), "0.1.0").text);
  for (const DeclaredCommand& command : the_program().commands) {
    expect_told(command, page_called(command.name).text);
  }
}

TEST(ManualPages, tell_every_exit_code) {
  for (const ManualPage& page : all_pages()) {
    for (const MeaningOfCode& code : exit_codes()) {
      EXPECT_THAT(page.text, HasSubstr(roff_bold(std::to_string(static_cast<int>(code.code))) +
                                       "\n" + roff_text(code.meaning)))
          << page.name;
    }
  }
}

TEST(ManualPages, have_nothing_that_mandoc_warns_of_but_that_they_have_no_date) {
  const TemporaryFolder folder;
  for (const ManualPage& page : all_pages()) {
    write_contents(folder.path() / page.name, page.text);
    const test::Ended judged =
        test::Program({"mandoc", "-Tlint", "-Wwarning", page.name}, folder.path(), {"/usr/bin/env"})
            .wait();
    for (const std::string& line : lines_of(judged.out + judged.err)) {
      EXPECT_THAT(line, HasSubstr("missing date"));
    }
  }
}

TEST(ManualPages, can_be_read) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "page", page_called("run").text);
  // Bold and underlined letters are printed over themselves and over lines.
  std::string text;
  for (const char c : printed_by({"mandoc", "-Tascii", "page"}, folder.path())) {
    if (c == '\b') {
      text.pop_back();
    } else {
      text += c;
    }
  }
  EXPECT_THAT(text, HasSubstr("TETFARM-RUN(1)"));
  EXPECT_THAT(text, HasSubstr("tetfarm run INPUT [options]"));
  EXPECT_THAT(text, HasSubstr("-o, --output DIR\n"));
  EXPECT_THAT(text, HasSubstr("tetfarm run wing.stl -o out -j 4 --outer sphere:10"));
}

TEST(ManualPages, are_in_the_section_of_those_who_use_them) {
  EXPECT_EQ(manual_page(the_program(), "0.1.0").name, "tetfarm");
  for (const char* name : {"run", "submit", "status", "completion"}) {
    EXPECT_EQ(page_called(name).section, 1) << name;
    EXPECT_EQ(page_called(name).name, std::string("tetfarm-") + name);
  }
  for (const char* name : {"coordinator", "worker", "pool", "keys", "gc", "backup", "restore"}) {
    EXPECT_EQ(page_called(name).section, 8) << name;
  }
  EXPECT_THAT(page_called("run").text, HasSubstr(".TH TETFARM\\-RUN 1 "));
  EXPECT_THAT(page_called("keys").text, HasSubstr(".TH TETFARM\\-KEYS 8 "));
}

TEST(ManualPages, tell_conditions_and_variables) {
  const std::string check = page_called("check").text;
  EXPECT_THAT(check, HasSubstr("Needs \\-\\-store."));
  EXPECT_THAT(check, HasSubstr("Not with \\-\\-frequency, \\-\\-growth, "));
  const std::string worker = page_called("worker").text;
  EXPECT_THAT(worker,
              HasSubstr("\\fBtetfarm worker\\fR \\fB\\-\\-connect\\fR \\fItcp://HOST:PORT"));
  EXPECT_THAT(worker, HasSubstr(".TP\n" + roff_bold("TETFARM_COORDINATOR") + "\n"));
  EXPECT_THAT(worker, HasSubstr("Required."));
  EXPECT_THAT(page_called("pool").text, HasSubstr("One of slurm, condor, lsf, ge, ssh, local."));
  EXPECT_THAT(page_called("run").text, HasSubstr("Known are vtkhdf, "));
  EXPECT_THAT(page_called("shape").text, Not(HasSubstr("TETFARM_COORDINATOR")));
}

TEST(ManualPages, of_a_command_with_others_below_it_tell_these_too) {
  const std::string keys = page_called("keys").text;
  EXPECT_THAT(keys, HasSubstr(".SS tetfarm keys authorize\n"));
  EXPECT_THAT(keys, HasSubstr("\ntetfarm keys list \\-\\-json\n"));
}

TEST(ManualPages, name_those_that_are_near) {
  const std::string run = page_called("run").text;
  EXPECT_THAT(run, HasSubstr("\\fBtetfarm\\fR(1),\n\\fBtetfarm\\-check\\fR(1)"));
  EXPECT_THAT(run, Not(HasSubstr("\\fBtetfarm\\-pool\\fR(8)")));
  EXPECT_THAT(run, HasSubstr("\\fBtetfarm\\-job\\fR(5)\n"));
  EXPECT_THAT(page_called("shape").text, Not(HasSubstr("tetfarm\\-job")));
  EXPECT_THAT(manual_page(the_program(), "0.1.0").text, HasSubstr("\\fBtetfarm\\-pool\\fR(8)"));
}

TEST(ManualPages, show_the_formats_of_export_line_by_line) {
  EXPECT_THAT(page_called("export").text, HasSubstr(".SH NOTES\n.nf\nFormats, each with the file"));
}

}  // namespace
}  // namespace tetfarm
