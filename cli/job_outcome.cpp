#include "cli/job_outcome.h"

#include <cstdio>
#include <utility>

#include "base/check.h"
#include "base/printable_text.h"
#include "cli/coloured_text.h"
#include "cli/job_text.h"
#include "cli/loop_report.h"
#include "cli/progress_lines.h"
#include "json/job_json.h"
#include "json/quality_gates.h"

namespace tetfarm {
namespace {

/// A file below the current folder by its way from there, as a person would type it.
std::string shown(const std::filesystem::path& file) {
  const std::string near = file.lexically_proximate(std::filesystem::current_path()).string();
  return near.starts_with("..") ? file.string() : near;
}

/// Of a job that is done. Ok, or that it is below a quality gate.
ExitCode report_result(const wire::JobStatus& status, const OutcomeOptions& options) {
  if (is_of_loop(status)) {
    report_loop(status, options.files, options.seconds, options.json);
    return ExitCode::ok;
  }
  if (options.json) {
    std::printf("%s\n", result_json(status, options.seconds, options.files).c_str());
  } else {
    const std::string text =
        result_text(status, options.seconds, options.files, standard_error_has_colours());
    std::fputs(text.c_str(), stderr);
  }
  bool is_passed = true;
  for (const QualityGate& gate : quality_gates_of(status)) {
    if (gate.is_passed()) continue;
    is_passed = false;
    std::fputs(gate_text(gate).c_str(), stderr);
  }
  return is_passed ? ExitCode::ok : ExitCode::gate;
}

}  // namespace

bool has_ended(const wire::JobStatus& status) {
  return status.state() == "done" || status.state() == "failed" || status.state() == "cancelled";
}

ExitCode report_outcome(const wire::JobStatus& status, const OutcomeOptions& options) {
  TF_CHECK(has_ended(status));
  if (status.state() == "cancelled") {
    throw Error(ExitCode::failed,
                "the job was cancelled" +
                    (status.message().empty() ? "" : ": " + printable(status.message())));
  }
  if (status.state() == "failed") {
    std::string message = printable(status.message());
    for (const std::filesystem::path& file : options.files) {
      message += "\n  see " + printable(shown(file));
    }
    throw Error(static_cast<ExitCode>(status.exit_code()), message);
  }
  const ExitCode code = report_result(status, options);
  std::fflush(stdout);  // the end is the last, also where both go to one place
  CommandEnd end;
  end.state = status.state();
  end.job = status.job();
  end.exit_code = static_cast<int>(code);
  end.files = options.files;
  tell_end(options.progress, std::move(end));
  return code;
}

}  // namespace tetfarm
