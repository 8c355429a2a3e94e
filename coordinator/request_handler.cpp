#include "coordinator/request_handler.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/error.h"
#include "coordinator/job_status.h"
#include "coordinator/message_translation.h"
#include "proto/wire.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_text = 4096;

bool comes_from_a_worker(const wire::Envelope& envelope) {
  switch (envelope.body_case()) {
    case wire::Envelope::kReady:
    case wire::Envelope::kProgress:
    case wire::Envelope::kDone:
    case wire::Envelope::kFailed:
    case wire::Envelope::kHeartbeat:
    case wire::Envelope::kGoodbye:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::vector<Reply> RequestHandler::take_replies() { return std::exchange(replies_, {}); }

std::vector<std::string> RequestHandler::take_complaints() {
  return std::exchange(complaints_, {});
}

WorkerId RequestHandler::worker_of(const std::string& connection) const {
  const auto found = workers_.find(connection);
  return found == workers_.end() ? WorkerId{} : found->second;
}

void RequestHandler::forget_workers() {
  workers_.clear();
  connections_.clear();
}

void RequestHandler::drop(const std::string& connection, const std::string& why) {
  ++dropped_;
  // A flood must not fill the log: 1, 2, 4, 8 … are told.
  if (!std::has_single_bit(dropped_)) return;
  complaints_.push_back("message " + std::to_string(dropped_) + " dropped: " + why +
                        (worker_of(connection)
                             ? " (worker " + std::to_string(worker_of(connection).value) + ")"
                             : ""));
}

void RequestHandler::answer(const std::string& connection, wire::Envelope envelope,
                            bool needs_commit) {
  replies_.push_back({connection, std::move(envelope), needs_commit});
}

void RequestHandler::handle(const std::string& connection, std::string_view bytes, JobState& state,
                            Moment now) {
  const Decoded decoded = decode(bytes);
  if (decoded.state == WireState::wrong_version) {
    drop(connection, "protocol version " + std::to_string(decoded.envelope.version()));
    answer(connection,
           refused_message("this coordinator speaks protocol version " +
                               std::to_string(protocol_version) + ", not " +
                               std::to_string(decoded.envelope.version()),
                           false, static_cast<int>(ExitCode::usage)),
           false);
    return;
  }
  if (decoded.state != WireState::good) {
    drop(connection, name_of(decoded.state));
    return;
  }
  const wire::Envelope& envelope = decoded.envelope;
  switch (envelope.body_case()) {
    case wire::Envelope::kHello:
      hello(connection, envelope.hello(), state, now);
      break;
    case wire::Envelope::kSubmit:
      submit(connection, envelope.submit(), state, now);
      break;
    case wire::Envelope::kStatusRequest:
      questions_.push_back({connection, envelope.status_request().job()});
      break;
    case wire::Envelope::kCancel: {
      wire::Envelope reply;
      reply.mutable_cancelled()->set_found(
          state.cancel(parse_job_name(envelope.cancel().job()), now));
      answer(connection, std::move(reply));
      break;
    }
    default:
      if (comes_from_a_worker(envelope)) {
        handle_worker(connection, envelope, state, now);
      } else {
        drop(connection, "a message that only the coordinator may send");
      }
  }
}

void RequestHandler::handle_worker(const std::string& connection, const wire::Envelope& envelope,
                                   JobState& state, Moment now) {
  const WorkerId worker = worker_of(connection);
  if (!worker || !state.knows_worker(worker)) {
    if (worker) connections_.erase(worker);
    workers_.erase(connection);
    if (envelope.has_goodbye()) return;
    answer(connection, refused_message("unknown worker", true, 0), false);
    return;
  }
  if (envelope.has_ready()) {
    state.worker_is_ready(worker, now);
  } else if (envelope.has_heartbeat()) {
    const wire::Heartbeat& beat = envelope.heartbeat();
    wire::Envelope reply;
    *reply.mutable_heartbeat() = beat;
    answer(connection, std::move(reply), false);
    state.heartbeat(worker, TaskId{beat.task()}, AttemptId{beat.attempt()}, now);
  } else if (envelope.has_progress()) {
    const wire::Progress& progress = envelope.progress();
    state.heartbeat(worker, TaskId{progress.task()}, AttemptId{progress.attempt()}, now);
  } else if (envelope.has_done()) {
    const wire::Done& done = envelope.done();
    state.done(worker, TaskId{done.task()}, AttemptId{done.attempt()}, result_of(done), now);
  } else if (envelope.has_failed()) {
    failed(worker, envelope.failed(), state, now);
  } else {
    state.worker_left(worker, false, now);
    connections_.erase(worker);
    workers_.erase(connection);
  }
}

void RequestHandler::hello(const std::string& connection, const wire::Hello& hello, JobState& state,
                           Moment now) {
  if (hello.store_probe() != store_.probe()) {
    answer(connection,
           refused_message(
               "worker " + hello.host() + " does not see the store " + store_.folder().string(),
               false, static_cast<int>(ExitCode::usage)),
           false);
    return;
  }
  const TaskId task{hello.running_task()};
  const AttemptId attempt{hello.running_attempt()};
  const WorkerId known = worker_of(connection);
  if (known && state.knows_worker(known)) {
    state.greet_again(known, task, attempt, now);
    return;
  }
  if (known) connections_.erase(known);
  const WorkerId worker = state.add_worker(worker_info_of(hello), task, attempt, now);
  workers_[connection] = worker;
  connections_[worker] = connection;
}

/// Whether the file is really missing or damaged; a damaged one is put aside.
bool RequestHandler::is_damaged(const ArtifactRef& file) {
  try {
    store_.verify(file.hash, file.size);
    return false;
  } catch (const IoError& error) {
    return error.code() == ExitCode::not_found;
  } catch (const CorruptFile& error) {
    complaints_.emplace_back(error.what());
    store_.set_aside(file.hash);
    return true;
  }
}

void RequestHandler::failed(WorkerId worker, const wire::Failed& message, JobState& state,
                            Moment now) {
  TaskFailure failure = failure_of(message);
  if (failure.message.size() > longest_text) failure.message.resize(longest_text);
  const auto task = state.durable().tasks.find(TaskId{message.task()});
  if (task != state.durable().tasks.end()) {
    for (const ArtifactRef& input : task->second.inputs) {
      const auto& claimed = message.damaged_inputs();
      if (std::find(claimed.begin(), claimed.end(), input.hash) == claimed.end()) continue;
      if (is_damaged(input)) failure.damaged_inputs.push_back(input.hash);
    }
  }
  // The worker could not read what is whole here: its view of the disk lags, or its disk fails.
  if (failure.damaged_inputs.empty() && message.damaged_inputs_size() > 0) failure.killed = true;
  state.failed(worker, TaskId{message.task()}, AttemptId{message.attempt()}, failure, now);
}

void RequestHandler::submit(const std::string& connection, const wire::Submit& message,
                            JobState& state, Moment now) {
  Submission submission;
  submission.key = message.key();
  submission.name = message.name();
  submission.job_toml = message.job_toml();
  submission.replaces_others = message.replaces_others();
  submission.inputs = files_of(message.inputs());
  for (const ArtifactRef& input : submission.inputs) {
    if (store_.has(input.hash, input.size)) continue;
    answer(connection,
           refused_message("the input '" + input.name + "' is not in the store", false,
                           static_cast<int>(ExitCode::not_found)),
           false);
    return;
  }
  try {
    const StoredArtifact job_file = store_.publish(message.job_toml());
    submission.job_file = {"job", job_file.hash, job_file.size};
  } catch (const Error& error) {
    answer(connection, refused_message(error.what(), false, static_cast<int>(error.code())), false);
    return;
  }
  const SubmitAnswer submitted = state.submit(submission, now);
  wire::Envelope reply;
  reply.mutable_submitted()->set_job(job_name(submitted.job));
  reply.mutable_submitted()->set_existed(submitted.existed);
  answer(connection, std::move(reply));
}

void RequestHandler::answer_questions(const JobState& state, Moment now) {
  for (const auto& [connection, job] : questions_) {
    wire::Envelope reply;
    wire::StatusReply& status = *reply.mutable_status_reply();
    status.set_workers(static_cast<std::uint32_t>(state.worker_count()));
    status.set_dropped_messages(dropped_);
    for (const auto& [id, row] : state.durable().jobs) {
      if (!job.empty() && job != job_name(id)) continue;
      *status.add_jobs() = status_message(summary_of(
          state.durable(), row, state.is_stuck() ? state.stuck_message() : "", now.wall_ms));
    }
    answer(connection, std::move(reply), false);
  }
  questions_.clear();
}

void RequestHandler::carry_out(JobState& state) {
  for (const Command& command : state.take_commands()) send(command, state);
}

void RequestHandler::send(const Command& command, const JobState& state) {
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
    answer(connection->second, std::move(envelope));
  } else if (const auto* assign = std::get_if<SendAssign>(&command)) {
    answer(connection->second,
           assign_message(state.durable().tasks.at(assign->task), assign->attempt));
  } else {
    answer(connection->second, accepted_message(std::get<SendAccepted>(command)));
  }
}

}  // namespace tetfarm
