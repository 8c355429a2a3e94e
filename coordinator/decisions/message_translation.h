/// Messages of the wire to the plain structs of job_state, and back.
///
/// What comes from the network is made harmless here: file names become plain names; malformed
/// hashes are left to the store, which has no such file. Its texts are bounded before, see
/// proto/text_limits.h.
#pragma once

#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/job_status.h"
#include "proto/messages.pb.h"

namespace tetfarm {

WorkerInfo worker_info_of(const wire::Hello& hello);
TaskResult result_of(const wire::Done& done);
/// Without the damaged inputs: only the shell can tell whether they are.
TaskFailure failure_of(const wire::Failed& failed);
std::vector<ArtifactRef> files_of(const google::protobuf::RepeatedPtrField<wire::Artifact>& files);

wire::Envelope assign_message(const TaskRow& task, AttemptId attempt);
wire::Envelope accepted_message(const SendAccepted& accepted);
wire::Envelope refused_message(const std::string& reason, bool hello_again, int exit_code);
/// Who is here, and which hosts are in quarantine.
void add_farm(const JobState& state, wire::StatusReply& message);
wire::JobStatus status_message(const JobSummary& summary);

}  // namespace tetfarm
