#include <filesystem>

#include "base/error.h"
#include "base/program_identity.h"
#include "base/program_version.h"
#include "coordinator/decisions/message_translation.h"
#include "coordinator/request_handler.h"
#include "coordinator/views/query_answers.h"
#include "store/disk_room.h"
#include "tasks/inspect_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

/// Workers that the state has forgotten may be remembered here until there are that many.
constexpr std::size_t lost_workers_kept = 64;

/// What the store's disk has for a new job; 0: it does not say, or it is full, which is no fault of
/// this job: the farm waits until there is room (space_watch.h).
std::uint64_t room_for_jobs(const std::filesystem::path& store) {
  try {
    const DiskRoom room = disk_room(store);
    if (room.total_bytes == 0 || room.free_bytes <= room.reserve()) return 0;
    return room.free_bytes - room.reserve();
  } catch (const IoError&) {
    return 0;
  }
}

}  // namespace

/// Each reconnection leaves one; without this they would be remembered for ever.
void RequestHandler::forget_lost_workers(const JobState& state) {
  if (workers_.size() < 2 * state.worker_count() + lost_workers_kept) return;
  std::erase_if(workers_,
                [&](const auto& known) { return !state.knows_worker(known.second.worker); });
  std::erase_if(connections_, [&](const auto& known) { return !state.knows_worker(known.first); });
}

wire::StatusReply RequestHandler::status_of_all(const wire::StatusRequest& request,
                                                const JobState& state,
                                                const Authenticator& authenticator,
                                                Moment now) const {
  wire::StatusReply status = answer_status(request, state, now);
  status.set_dropped_messages(refusals_.total());
  for (std::size_t kind = 0; kind < refusal_kinds; ++kind) {
    const auto refusal = static_cast<Refusal>(kind);
    (*status.mutable_refused())[name_of(refusal)] = refusals_.of(refusal);
  }
  status.set_security(options_.security);
  status.set_trouble(closed_);
  if (is_closed()) status.set_trouble_code(static_cast<int>(closed_code_));
  status.set_connections(static_cast<std::uint32_t>(authenticator.connections()));
  status.set_authorized_keys(static_cast<std::uint32_t>(authenticator.authorized()));
  status.set_program_version(program_version);
  status.set_program(program_identity());
  status.set_wall_ms(now.wall_ms);
  return status;
}

void RequestHandler::answer_questions(const JobState& state, const JobHistory& history,
                                      const Authenticator& authenticator, Moment now) {
  for (const auto& [connection, question] : questions_) {
    wire::Envelope reply;
    try {
      if (question.has_query()) {
        *reply.mutable_query_reply() = answer_query(question.query(), {state, history, now});
        reply.mutable_query_reply()->set_trouble(closed_);
      } else {
        *reply.mutable_status_reply() =
            status_of_all(question.status_request(), state, authenticator, now);
      }
      answer(connection, std::move(reply), false);
    } catch (const Error& error) {
      refuse(connection, error.what(), error.code());
    }
  }
  questions_.clear();
}

void RequestHandler::carry_out(JobState& state, Moment now) {
  for (const Command& command : state.take_commands()) send(command, state, now);
  forget_lost_workers(state);
}

void RequestHandler::send(const Command& command, const JobState& state, Moment now) {
  const WorkerId worker =
      std::visit([](const auto& command_of_kind) { return command_of_kind.worker; }, command);
  const auto connection = connections_.find(worker);
  if (connection == connections_.end()) return;
  if (const auto* welcome = std::get_if<SendWelcome>(&command)) {
    wire::Envelope envelope;
    wire::Welcome& message = *envelope.mutable_welcome();
    message.set_worker(worker.value);
    message.set_heartbeat_ms(static_cast<std::uint32_t>(options_.heartbeat_ms));
    message.set_lease_ms(static_cast<std::uint32_t>(options_.lease_ms));
    message.set_keep_running(welcome->keep_running);
    message.set_sees_store(workers_.at(connection->second).sees_store);
    answer(connection->second, std::move(envelope));
  } else if (const auto* assign = std::get_if<SendAssign>(&command)) {
    const TaskRow& task = state.durable().tasks.at(assign->task);
    wire::Envelope envelope = assign_message(task, assign->attempt);
    envelope.mutable_assign()->set_limit_ms(static_cast<std::uint64_t>(assign->limit_ms));
    if (task.kind == TaskKind::inspect) {
      (*envelope.mutable_assign()->mutable_parameters())[field_name(&InspectGiven::free_bytes)] =
          std::to_string(room_for_jobs(store_.folder()));
    }
    answer(connection->second, std::move(envelope));
  } else if (std::holds_alternative<SendDrain>(command)) {
    wire::Envelope envelope;
    envelope.mutable_drain();
    answer(connection->second, std::move(envelope));
  } else {
    const auto& accepted = std::get<SendAccepted>(command);
    if (!accepted.taken) {
      refusals_.count(Refusal::stale,
                      "worker " + std::to_string(worker.value) + " with attempt " +
                          std::to_string(accepted.attempt.value) + " of task " +
                          std::to_string(accepted.task.value),
                      now.steady_ms);
    }
    answer(connection->second, accepted_message(accepted));
  }
}

}  // namespace tetfarm
