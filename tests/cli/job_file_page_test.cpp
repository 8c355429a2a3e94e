#include "cli/job_file_page.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "cli/roff_text.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/loop_job.h"
#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

/// What is in bold at the heads of entries: "a.b" of ".TP\n\fBa.b\fR, \fBa.c\fR\n".
std::set<std::string> heads_of(const std::string& page) {
  std::set<std::string> heads;
  const std::vector<std::string> lines = lines_of(page);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i] != ".TP") continue;
    std::string rest = lines[i + 1];
    for (std::size_t begin = rest.find("\\fB"); begin != std::string::npos;
         begin = rest.find("\\fB")) {
      const std::size_t end = rest.find("\\fR", begin);
      heads.insert(rest.substr(begin + 3, end - begin - 3));
      rest.erase(0, end + 3);
    }
  }
  return heads;
}

TEST(JobFilePage, has_an_entry_for_every_key_that_the_readers_know) {
  std::set<std::string> heads = heads_of(job_file_page("0.1.0").text);
  EXPECT_THAT(heads, IsSupersetOf(job_file_keys()));
  for (const std::string& key : loop_job_keys()) {
    const bool is_of_source = key.starts_with("point") || key.starts_with("line");
    const std::string array = key.starts_with("point") ? "[[point]]" : "[[line]]";
    EXPECT_TRUE(heads.contains(is_of_source ? array : key)) << key;
  }
}

TEST(JobFilePage, has_no_key_that_the_readers_do_not_know) {
  std::set<std::string> known = {"[[point]]", "[[line]]"};
  for (const std::string& key : job_file_keys()) known.insert(key);
  for (const std::string& key : loop_job_keys()) known.insert(key);
  for (const std::string& head : heads_of(job_file_page("0.1.0").text)) {
    EXPECT_TRUE(known.contains(head)) << head;
  }
}

TEST(JobFilePage, tells_defaults_units_and_what_must_be_given) {
  const std::string page = job_file_page("0.1.0").text;
  EXPECT_THAT(page, StartsWith(".TH TETFARM\\-JOB 5 \"\" \"tetfarm 0.1.0\" \"Tetfarm\"\n.SH NAME\n"
                               "tetfarm\\-job \\- the job file"));
  EXPECT_THAT(page, HasSubstr(".TP\n\\fBspacing.growth\\fR\nby how much the edge length may grow "
                              "per unit of length; more than 0. Default: 0.3.\n"));
  EXPECT_THAT(page, HasSubstr(" Must be given."));
  EXPECT_THAT(page, HasSubstr(" Unit: degrees."));
  EXPECT_THAT(page, HasSubstr(".nf\n[geometry]\nsurface = \"wing.stl\"\n"));
  EXPECT_THAT(page, HasSubstr(".SH REGIONS\n"));
}

TEST(JobFilePage, has_nothing_that_mandoc_warns_of_but_that_it_has_no_date) {
  const test::TemporaryFolder folder;
  test::write_contents(folder.path() / "page", job_file_page("0.1.0").text);
  const test::Ended judged =
      test::Program({"mandoc", "-Tlint", "-Wwarning", "page"}, folder.path(), {"/usr/bin/env"})
          .wait();
  for (const std::string& line : lines_of(judged.out + judged.err)) {
    EXPECT_THAT(line, HasSubstr("missing date"));
  }
}

}  // namespace
}  // namespace tetfarm
