#include "cli/job_file_page.h"

#include "cli/job_file_documents.h"
#include "cli/markdown_roff.h"
#include "cli/roff_text.h"

namespace tetfarm {
namespace {

constexpr std::string_view section_about_loops = "Cycles with a solver";

std::string see_also() {
  std::string text;
  for (const char* name : {"tetfarm", "tetfarm-run", "tetfarm-check", "tetfarm-plan",
                           "tetfarm-submit", "tetfarm-loop"}) {
    text += (text.empty() ? "" : ",\n") + roff_bold(name) + "(1)";
  }
  return ".SH SEE ALSO\n" + text + "\n";
}

}  // namespace

ManualPage job_file_page(const std::string& version) {
  std::string text = ".TH TETFARM\\-JOB 5 \"\" \"tetfarm " + version + "\" \"Tetfarm\"\n";
  text += ".SH NAME\n" + roff_text("tetfarm-job") + " \\- the job file: what to mesh, and how\n";
  text += ".SH DESCRIPTION\n" + roff_of_markdown(job_file_document);
  text += ".SH ADAPTATION LOOPS\n" +
          roff_of_markdown(markdown_section(adaptation_document, section_about_loops));
  return {"tetfarm-job", 5, text + see_also()};
}

}  // namespace tetfarm
