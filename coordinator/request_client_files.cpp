#include "base/error.h"
#include "coordinator/request_handler.h"
#include "coordinator/views/query_answers.h"

namespace tetfarm {
namespace {

/// What the job's status tells of: results, or evidence of why it failed.
std::optional<std::vector<StoredArtifact>> files_of_job(JobId job, const JobState& state,
                                                        Moment now) {
  if (!job) return std::nullopt;
  wire::StatusRequest request;
  request.set_job(job_name(job));
  const wire::StatusReply reply = answer_status(request, state, now);
  if (reply.jobs_size() == 0) return std::nullopt;
  std::vector<StoredArtifact> files;
  for (const wire::Artifact& file : reply.jobs(0).files()) {
    files.push_back({file.hash(), file.size()});
  }
  return files;
}

}  // namespace

void RequestHandler::client_file(const Sender& sender, const wire::Envelope& envelope,
                                 const JobState& state, Moment now) {
  const ClientSender client{sender.connection, client_name(sender.key)};
  try {
    if (envelope.has_fetch_file()) {
      const auto files = [&](JobId job) { return files_of_job(job, state, now); };
      client_files_.fetch(client, envelope.fetch_file(), files, now);
    } else if (envelope.has_offer_file()) {
      client_files_.offer(client, envelope.offer_file(), now);
    } else {
      client_files_.append(client, envelope.file_chunk(), now);
    }
  } catch (const Error& error) {
    if (envelope.has_fetch_file()) {
      refusals_.count(Refusal::no_result, who(sender) + ": " + error.what(), now.steady_ms);
    }
    refuse(sender.connection, error.what(), error.code());
  }
}

}  // namespace tetfarm
