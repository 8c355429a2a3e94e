#include "cli/job_outcome.h"

#include <cstdio>

#include "cli/job_report.h"

namespace tetfarm {
namespace {

std::vector<std::filesystem::path> deliver(const wire::JobStatus& status,
                                           const OutcomeOptions& options) {
  if (options.store.empty() || options.output.empty()) return {};
  return deliver_files(status, options.store, options.output);
}

double number_or_zero(const wire::JobStatus& status, const char* name) {
  const auto found = status.numbers().find(name);
  return found == status.numbers().end() ? 0 : found->second;
}

}  // namespace

bool has_ended(const wire::JobStatus& status) {
  return status.state() == "done" || status.state() == "failed" || status.state() == "cancelled";
}

ExitCode report_outcome(const wire::JobStatus& status, const OutcomeOptions& options) {
  const std::vector<std::filesystem::path> files = deliver(status, options);
  if (status.state() == "cancelled") throw Error(ExitCode::failed, "the job was cancelled");
  if (status.state() == "failed") {
    std::string message = status.message();
    for (const std::filesystem::path& file : files) message += "\n  see " + file.string();
    throw Error(static_cast<ExitCode>(status.exit_code()), message);
  }
  if (options.json) {
    std::printf("%s\n", result_json(status, options.seconds, files).c_str());
  } else {
    std::fprintf(stderr, "%s", result_text(status, options.seconds, files).c_str());
  }
  const double gate = number_or_zero(status, "min_dihedral_gate_deg");
  const double smallest = number_or_zero(status, "min_dihedral_deg");
  if (smallest >= gate) return ExitCode::ok;
  std::fprintf(stderr,
               "error: the smallest dihedral angle is %.3f deg, the job's gate is %.3f deg\n"
               "help: the mesh is complete; look at it with `tetfarm quality`\n",
               smallest, gate);
  return ExitCode::gate;
}

}  // namespace tetfarm
