#include "coordinator/submitted_job.h"

#include <utility>

#include "base/error.h"
#include "base/job_name.h"
#include "coordinator/decisions/message_translation.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/loop_job.h"

namespace tetfarm {
namespace {

std::string good_name(const std::string& name) {
  const std::string problem = problem_with_job_name(name);
  if (!problem.empty()) throw UsageError("the job's name " + problem, "");
  return name;
}

std::string checked_loop_name(const wire::Submit& submit) {
  const LoopJob job = parse_loop_job(submit.job_toml(), "job.toml");
  return good_name(submit.name().empty() ? job.name : submit.name());
}

}  // namespace

std::string checked_job_name(const wire::Submit& submit) {
  if (is_loop_job(submit.job_toml(), "job.toml")) return checked_loop_name(submit);
  const JobFile job = parse_job_file(submit.job_toml(), "job.toml");
  if (!job.sources_file.empty()) {
    throw UsageError("`sources` names a file; a submitted job must contain its sources",
                     "job.toml");
  }
  return good_name(submit.name().empty() ? job.name : submit.name());
}

bool is_remeshed(const wire::Submit& submit) {
  return parse_job_file(submit.job_toml(), "job.toml").remeshing.has_value();
}

void add_first_cycle(const wire::Submit& submit, const TaskFile& job_file, Submission& submission) {
  const LoopJob job = parse_loop_job(submit.job_toml(), "job.toml");
  TaskWords words = to_words(SolveGiven{});
  words.files = {{field_name(&SolveGiven::job), job_file}};
  for (const ArtifactRef& input : files_of(submit.inputs())) {
    words.files.push_back({input.name, {input.hash, input.size}});
  }
  ContractReading<SolveGiven> reading = from_words<SolveGiven>(words);
  if (!reading.breach.empty()) throw UsageError(reading.breach, "the submission");
  reading.contract.cycles = static_cast<std::uint64_t>(job.cycles);
  submission.loop = std::move(reading.contract);
  submission.loop_memory_bytes = static_cast<std::uint64_t>(job.solver.memory_bytes);
}

}  // namespace tetfarm
