#include "coordinator/request_handler.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "coordinator/decisions/job_status.h"
#include "coordinator/decisions/message_translation.h"
#include "coordinator/submitted_job.h"
#include "mesh/job_file/loop_job.h"
#include "proto/doing.h"
#include "proto/field_count.h"
#include "proto/text_limits.h"
#include "proto/wire.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_probe = 256;
constexpr std::int64_t answers_per_lease = 4;

bool is_about_files(const wire::Envelope& envelope) {
  return envelope.has_fetch_file() || envelope.has_offer_file() || envelope.has_file_chunk();
}

std::string problem_with_priority(int priority) {
  if (priority >= -most_priority && priority <= most_priority) return {};
  return "a priority is from " + std::to_string(-most_priority) + " to " +
         std::to_string(most_priority) + ", not " + std::to_string(priority);
}

bool is_question(const wire::Envelope& envelope) {
  return envelope.has_status_request() || envelope.has_query();
}

/// Of a client; it waits for the answer.
bool asks_for_a_decision(const wire::Envelope& envelope) {
  return envelope.has_submit() || envelope.has_cancel() || envelope.has_retry() ||
         envelope.has_drain_workers() || envelope.has_set_priority();
}

bool tells_a_decision(const wire::Envelope& envelope) {
  return envelope.has_submitted() || envelope.has_cancelled() || envelope.has_retried() ||
         envelope.has_draining() || envelope.has_priority_set();
}

Refusal refusal_of(WireState state) {
  switch (state) {
    case WireState::too_large:
      return Refusal::too_large;
    case WireState::wrong_version:
      return Refusal::wrong_version;
    case WireState::no_body:
      return Refusal::senseless;
    default:
      return Refusal::garbage;
  }
}

const char* surface_name() { return field_name(&InspectGiven::input_surface); }

/// The one input that a submission may have. @throws UsageError when it has another.
std::optional<TaskFile> surface_of(const wire::Submit& message) {
  std::optional<TaskFile> surface;
  for (const ArtifactRef& input : files_of(message.inputs())) {
    if (input.name != surface_name() || surface) {
      throw UsageError("has the input '" + input.name + "', and takes one surface and nothing else",
                       "the submission");
    }
    surface = TaskFile{input.hash, input.size};
  }
  return surface;
}

}  // namespace

std::string who(const Sender& sender) {
  if (sender.is_plain()) return "someone without a key";
  if (!sender.role) return "key " + sender.key;
  return std::string(name_of(*sender.role)) + " " + sender.name;
}

void RequestHandler::close(const std::string& reason, ExitCode code) {
  closed_ = reason;
  closed_code_ = code;
}

std::vector<Reply> RequestHandler::take_replies_uncommitted() {
  std::vector<Reply> replies;
  for (Reply& reply : take_replies()) {
    if (!reply.needs_commit) {
      replies.push_back(std::move(reply));
    } else if (is_closed() && tells_a_decision(reply.envelope)) {
      const int code = static_cast<int>(closed_code_);
      replies.push_back({reply.connection, refused_message(closed_, false, code), false});
    }
  }
  return replies;
}

std::vector<Reply> RequestHandler::take_replies() { return std::exchange(replies_, {}); }

std::vector<std::string> RequestHandler::take_complaints() {
  return std::exchange(complaints_, {});
}

WorkerId RequestHandler::worker_of(const std::string& connection) const {
  const auto found = workers_.find(connection);
  return found == workers_.end() ? WorkerId{} : found->second.worker;
}

void RequestHandler::forget_workers() {
  workers_.clear();
  connections_.clear();
  transfers_.forget_connections();
  client_files_.forget_connections();
  checks_.forget();
  leftovers_.forget_workers();
}

void RequestHandler::drop(const Sender& sender, const std::string& why, Moment now) {
  refusals_.count(Refusal::garbage, who(sender) + ": " + why, now.steady_ms);
}

void RequestHandler::answer(const std::string& connection, wire::Envelope envelope,
                            bool needs_commit) {
  TF_CHECK(envelope.body_case() != wire::Envelope::BODY_NOT_SET);
  replies_.push_back({connection, std::move(envelope), needs_commit});
}

void RequestHandler::refuse(const std::string& connection, const std::string& reason,
                            ExitCode code) {
  answer(connection, refused_message(reason, false, static_cast<int>(code)), false);
}

/// Whether the sender may speak at all, on this connection.
bool RequestHandler::is_welcome(const Sender& sender, Moment now) {
  if (!sender.is_plain() && !sender.role) {
    refusals_.count(Refusal::revoked_key, who(sender), now.steady_ms);
    refuse(sender.connection, "this key is no longer authorised", ExitCode::failed);
    return false;
  }
  const auto known = workers_.find(sender.connection);
  if (known != workers_.end() && known->second.key != sender.key) {
    refusals_.count(
        Refusal::foreign_connection,
        who(sender) + " on the connection of worker " + std::to_string(known->second.worker.value),
        now.steady_ms);
    return false;
  }
  return true;
}

void RequestHandler::handle(const Sender& sender, std::string_view bytes, JobState& state,
                            Moment now) {
  if (!is_welcome(sender, now)) return;
  Decoded decoded = has_too_many_fields(bytes) ? Decoded{WireState::too_large, {}} : decode(bytes);
  if (decoded.state != WireState::good) {
    refusals_.count(refusal_of(decoded.state), who(sender), now.steady_ms);
  }
  const wire::Envelope& envelope = decoded.envelope;
  (envelope.has_heartbeat() ? heard_heartbeat_ : heard_other_) = true;
  switch (decoded.state) {
    case WireState::good:
      break;
    case WireState::wrong_version:
      return refuse(sender.connection,
                    "this coordinator speaks protocol version " + std::to_string(protocol_version) +
                        ", not " + std::to_string(envelope.version()),
                    ExitCode::usage);
    case WireState::too_large:
      return refuse(sender.connection,
                    "a message may have at most " + std::to_string(max_message_size) +
                        " bytes and " + std::to_string(max_fields) + " fields",
                    ExitCode::usage);
    default:
      return;
  }
  if (!is_for_the_coordinator(envelope.body_case())) {
    refusals_.count(Refusal::senseless, who(sender) + ": " + name_of(envelope.body_case()),
                    now.steady_ms);
    return;
  }
  if (!sender.may_send(envelope)) {
    const std::string what = who(sender) + " may not send " + name_of(envelope.body_case());
    refusals_.count(Refusal::wrong_role, what, now.steady_ms);
    return refuse(sender.connection, what, ExitCode::failed);
  }
  if (const std::string too_long = apply_text_limits(decoded.envelope); !too_long.empty()) {
    refusals_.count(Refusal::too_large, who(sender) + ": " + too_long, now.steady_ms);
    return refuse(sender.connection, too_long, ExitCode::usage);
  }
  dispatch(sender, envelope, state, now);
}

void RequestHandler::dispatch(const Sender& sender, const wire::Envelope& envelope, JobState& state,
                              Moment now) {
  const std::string& connection = sender.connection;
  const bool is_clients_file = is_of_client(envelope);
  if (is_closed() && !is_question(envelope)) {
    if (is_clients_file || asks_for_a_decision(envelope)) {
      refuse(connection, closed_, closed_code_);
    }
    return;
  }
  if (is_clients_file) return client_file(sender, envelope, state, now);
  switch (envelope.body_case()) {
    case wire::Envelope::kHello:
      return hello(sender, envelope.hello(), state, now);
    case wire::Envelope::kSubmit:
      return submit(sender, envelope.submit(), state, now);
    case wire::Envelope::kStatusRequest:
    case wire::Envelope::kQuery:
      questions_.push_back({connection, envelope});
      return;
    case wire::Envelope::kCancel: {
      wire::Envelope reply;
      reply.mutable_cancelled()->set_found(
          state.cancel(parse_job_name(envelope.cancel().job()), now));
      return answer(connection, std::move(reply));
    }
    case wire::Envelope::kSetPriority:
      return set_priority(connection, envelope.set_priority(), state, now);
    case wire::Envelope::kRetry:
      return retry(connection, envelope.retry(), state, now);
    case wire::Envelope::kDrainWorkers: {
      wire::Envelope reply;
      reply.mutable_draining()->set_count(state.drain(WorkerId{envelope.drain_workers().worker()}));
      return answer(connection, std::move(reply));
    }
    default:
      return handle_worker(connection, envelope, state, now);
  }
}

void RequestHandler::forget(WorkerId worker) {
  const auto connection = connections_.find(worker);
  if (connection == connections_.end()) return;
  workers_.erase(connection->second);
  connections_.erase(connection);
}

void RequestHandler::expel(const Authenticator& authenticator, JobState& state, Moment now) {
  std::vector<WorkerId> gone;
  for (const auto& [connection, known] : workers_) {
    if (!authenticator.admits_worker(known.key)) gone.push_back(known.worker);
  }
  for (const WorkerId worker : gone) {
    refuse(connections_.at(worker), "this key is no longer authorised", ExitCode::failed);
    if (state.knows_worker(worker)) state.worker_left(worker, true, now);
    complaints_.push_back("worker " + std::to_string(worker.value) +
                          " is shut out: its key is no longer authorised");
    forget(worker);
  }
}

void RequestHandler::handle_worker(const std::string& connection, const wire::Envelope& envelope,
                                   JobState& state, Moment now) {
  const WorkerId worker = worker_of(connection);
  if (!worker || !state.knows_worker(worker)) {
    forget(worker);
    if (envelope.has_goodbye()) return;
    answer(connection, refused_message("unknown worker", true, 0), false);
    return;
  }
  if (envelope.has_ready()) {
    state.worker_is_ready(worker, now);
  } else if (envelope.has_heartbeat()) {
    const wire::Heartbeat& beat = envelope.heartbeat();
    answer_heartbeat(connection, beat, now);
    const TaskId task{beat.task()};
    const AttemptId attempt{beat.attempt()};
    state.heartbeat(worker, task, attempt, now);
    if (const auto count = work_count_of(beat.doing())) {
      state.note_work(worker, task, attempt, *count);
    }
  } else if (envelope.has_done()) {
    const wire::Done& done = envelope.done();
    state.done(worker, TaskId{done.task()}, AttemptId{done.attempt()}, result_of(done), now);
  } else if (envelope.has_failed()) {
    failed(worker, envelope.failed(), state, now);
  } else if (is_about_files(envelope)) {
    files(connection, worker, envelope, state, now);
  } else {
    state.worker_left(worker, false, now);
    forget(worker);
  }
}

/// Several times in a lease: a worker that hears nothing for so long connects anew.
void RequestHandler::answer_heartbeat(const std::string& connection, const wire::Heartbeat& beat,
                                      Moment now) {
  std::int64_t& answered_ms = workers_.at(connection).answered_ms;
  if (now.steady_ms - answered_ms < options_.lease_ms / answers_per_lease) return;
  answered_ms = now.steady_ms;
  wire::Envelope reply;
  reply.mutable_heartbeat()->set_task(beat.task());
  reply.mutable_heartbeat()->set_attempt(beat.attempt());
  answer(connection, std::move(reply), false);
}

/// Who sends or gets files is alive; of an attempt that is over it is told so.
void RequestHandler::files(const std::string& connection, WorkerId worker,
                           const wire::Envelope& envelope, JobState& state, Moment now) {
  const auto beat = [&](const auto& message) {
    state.heartbeat(worker, TaskId{message.task()}, AttemptId{message.attempt()}, now);
    return state.holds(worker, TaskId{message.task()}, AttemptId{message.attempt()});
  };
  const bool is_current = envelope.has_fetch_file()   ? beat(envelope.fetch_file())
                          : envelope.has_offer_file() ? beat(envelope.offer_file())
                                                      : beat(envelope.file_chunk());
  if (!is_current || transfers_.take(connection, worker, envelope, state, now)) return;
  refusals_.count(Refusal::senseless,
                  "worker " + std::to_string(worker.value) + ": " + name_of(envelope.body_case()),
                  now.steady_ms);
}

/// Whether what the worker has just written into its store's scratch folder is in ours: the mark of
/// the store alone would be the same in a copy.
bool RequestHandler::sees_store(const wire::Hello& hello) const {
  if (hello.store_probe() != store_.probe() || !ArtifactStore::is_hash(hello.probe_file()) ||
      hello.probe_text().empty()) {
    return false;
  }
  try {
    const std::filesystem::path path = probe_path(store_, hello.probe_file());
    return read_part_of_file(path, 0, longest_probe) == hello.probe_text();
  } catch (const IoError&) {
    return false;
  }
}

void RequestHandler::note_store(const std::string& connection, WorkerId worker,
                                const wire::Hello& hello) {
  const bool sees_it = sees_store(hello);
  workers_.at(connection).sees_store = sees_it;
  if (sees_it) leftovers_.note_probe(worker, hello.probe_file());
}

void RequestHandler::hello(const Sender& sender, const wire::Hello& hello, JobState& state,
                           Moment now) {
  const std::string& connection = sender.connection;
  // Without one, another process could go on with its attempt.
  if (hello.nonce().empty()) {
    refusals_.count(Refusal::senseless, who(sender) + ": hello without a nonce", now.steady_ms);
    return refuse(connection, "a worker's hello must have a nonce", ExitCode::usage);
  }
  WorkerInfo info = worker_info_of(hello);
  info.key = sender.key;
  const TaskId task{hello.running_task()};
  const AttemptId attempt{hello.running_attempt()};
  const WorkerId known = worker_of(connection);
  if (known && state.knows_worker(known)) {
    note_store(connection, known, hello);
    state.greet_again(known, info, task, attempt, now);
    return;
  }
  forget(known);
  if (state.worker_count() >= options_.max_workers) {
    refusals_.count(Refusal::too_many_workers, who(sender), now.steady_ms);
    return refuse(connection,
                  "there are already " + std::to_string(options_.max_workers) + " workers",
                  ExitCode::out_of_resources);
  }
  const WorkerId worker = state.add_worker(info, task, attempt, now);
  TF_CHECK(worker && !connections_.contains(worker));
  workers_[connection] = {worker, sender.key};
  connections_[worker] = connection;
  note_store(connection, worker, hello);
}

std::vector<FileOrder> RequestHandler::take_file_orders(const JobState& state, Moment now) {
  std::vector<FileOrder> orders = transfers_.take_orders(state, now);
  for (FileOrder& order : client_files_.take_orders(now)) orders.push_back(std::move(order));
  for (FileOrder& order : checks_.take_orders()) orders.push_back(std::move(order));
  return orders;
}

void RequestHandler::note_file(const FileAnswer& answer, JobState& state, Moment now) {
  if (!answer.client.empty()) return client_files_.note_answer(answer);
  transfers_.note_answer(answer.connection);
  if (!answer.checked) return;
  const auto failure = checks_.note(*answer.checked);
  // A worker that has connected anew says it again.
  if (!failure || !state.knows_worker(failure->worker)) return;
  state.failed(failure->worker, failure->task, failure->attempt, failure->what, now);
}

/// Inputs that are said to be damaged are looked at first, which may take a while.
void RequestHandler::failed(WorkerId worker, const wire::Failed& message, JobState& state,
                            Moment now) {
  TaskFailure failure = failure_of(message);
  const TaskId task{message.task()};
  const AttemptId attempt{message.attempt()};
  const auto& named = message.damaged_inputs();
  std::vector<ArtifactRef> claimed;
  if (failure.cause == FailureCause::damaged_input && state.holds(worker, task, attempt)) {
    for (const ArtifactRef& input : state.durable().tasks.at(task).inputs) {
      if (std::find(named.begin(), named.end(), input.hash) != named.end())
        claimed.push_back(input);
    }
  }
  if (!claimed.empty()) return checks_.take({worker, task, attempt, std::move(failure)}, claimed);
  // What it names is no input of its task, or nothing: there is nothing to make again.
  if (failure.cause == FailureCause::damaged_input) failure.cause = FailureCause::killed;
  state.failed(worker, task, attempt, failure, now);
}

/// @throws Error when an input is not there.
void RequestHandler::add_loop(const wire::Submit& message, Submission& submission) const {
  if (!message.surface_path().empty()) throw UsageError("names a surface", "the submission");
  const StoredArtifact job_file = store_.publish(message.job_toml());
  add_first_cycle(message, {job_file.hash, job_file.size}, submission);
  for (const ArtifactRef& input : files_of(message.inputs())) {
    if (store_.has(input.hash, input.size)) continue;
    throw Error(ExitCode::not_found, "the input '" + input.name + "' is not in the store");
  }
}

/// @throws Error when the input is not there, or is no place that jobs may name.
Submission RequestHandler::submission_of(const wire::Submit& message) const {
  Submission submission;
  submission.key = message.key();
  submission.name = checked_job_name(message);
  submission.job_toml = message.job_toml();
  submission.replaces_others = message.replaces_others();
  if (is_loop_job(message.job_toml(), "job.toml")) {
    add_loop(message, submission);
    return submission;
  }
  std::optional<TaskFile> surface = surface_of(message);
  if (!message.surface_path().empty()) {
    if (surface) throw UsageError("names two surfaces", "the submission");
    const StoredArtifact taken = roots_.take(message.surface_path(), store_);
    surface = TaskFile{taken.hash, taken.size};
    if (submission.key.empty()) submission.key = hash128(message.job_toml() + taken.hash).hex();
  }
  if (!surface) throw UsageError("names no surface", "the submission");
  if (!store_.has(surface->hash, surface->size)) {
    throw Error(ExitCode::not_found,
                std::string("the input '") + surface_name() + "' is not in the store");
  }
  const StoredArtifact job_file = store_.publish(message.job_toml());
  submission.given = {{job_file.hash, job_file.size}, surface, std::nullopt};
  submission.remeshes = is_remeshed(message);
  return submission;
}

void RequestHandler::submit(const Sender& sender, const wire::Submit& message, JobState& state,
                            Moment now) {
  const std::string& connection = sender.connection;
  if (message.replaces_others() && !options_.may_replace_jobs) {
    const std::string what =
        who(sender) + " may not replace the jobs of this coordinator, which may serve others too";
    refusals_.count(Refusal::wrong_role, what, now.steady_ms);
    return refuse(connection, what, ExitCode::failed);
  }
  if (const std::string problem = problem_with_priority(message.priority()); !problem.empty()) {
    return refuse(connection, problem, ExitCode::usage);
  }
  Submission submission;
  try {
    submission = submission_of(message);
    // What was just being removed, as the last job that had it is forgotten, is put there again.
    if (!state.has_inputs(submission)) submission = submission_of(message);
  } catch (const OutsideRoots& error) {
    refusals_.count(Refusal::outside_roots, error.what(), now.steady_ms);
    return refuse(connection, error.what(), error.code());
  } catch (const Error& error) {
    return refuse(connection, error.what(), error.code());
  }
  submission.owner = sender.key;
  submission.priority = message.priority();
  for (const std::string& name : message.after()) {
    submission.after.push_back(parse_job_name(name));
    if (submission.after.back()) continue;
    return refuse(connection, "`" + name + "` is no job to wait for: jobs are called job-7",
                  ExitCode::usage);
  }
  const SubmitAnswer submitted = state.submit(submission, now);
  if (submitted.differs) {
    return refuse(connection,
                  "this submission has the key of " + job_name(submitted.job) +
                      ", which has a different job file or surface: give it a key of its own",
                  ExitCode::usage);
  }
  if (submitted.is_one_too_many) return refuse_one_too_many(connection);
  if (submitted.unmet) return refuse_unmet(connection, submitted.unmet, state);
  wire::Envelope reply;
  reply.mutable_submitted()->set_job(job_name(submitted.job));
  reply.mutable_submitted()->set_existed(submitted.existed);
  answer(connection, std::move(reply));
}

void RequestHandler::refuse_one_too_many(const std::string& connection) {
  refuse(connection,
         "this user has as many jobs that run or wait as one may have here, which is " +
             std::to_string(options_.jobs_per_user) +
             ": wait until one of them is done (tetfarm wait), or cancel one",
         ExitCode::out_of_resources);
}

/// The job waits for another one that will not end well, as things are.
void RequestHandler::refuse_unmet(const std::string& connection, JobId unmet,
                                  const JobState& state) {
  const auto found = state.durable().jobs.find(unmet);
  if (found == state.durable().jobs.end()) {
    return refuse(connection, "there is no " + job_name(unmet) + " to wait for",
                  ExitCode::not_found);
  }
  const JobRow& job = found->second;
  refuse(connection,
         "it would wait for " + job_words(job) + ", which " +
             (job.phase == JobPhase::failed ? "has failed" : "was cancelled") +
             ": `tetfarm retry " + job_name(unmet) + "` first",
         ExitCode::failed);
}

void RequestHandler::set_priority(const std::string& connection, const wire::SetPriority& message,
                                  JobState& state, Moment now) {
  if (const std::string problem = problem_with_priority(message.priority()); !problem.empty()) {
    return refuse(connection, problem, ExitCode::usage);
  }
  const JobId job = parse_job_name(message.job());
  wire::Envelope reply;
  wire::PrioritySet& answered = *reply.mutable_priority_set();
  answered.set_found(state.set_priority(job, message.priority(), now));
  if (answered.found()) answered.set_state(name_of(state.durable().jobs.at(job).phase));
  answer(connection, std::move(reply));
}

void RequestHandler::retry(const std::string& connection, const wire::Retry& message,
                           JobState& state, Moment now) {
  if (const JobId unmet = state.unmet_by(parse_job_name(message.job()))) {
    return refuse_unmet(connection, unmet, state);
  }
  if (const auto found = state.durable().jobs.find(parse_job_name(message.job()));
      found != state.durable().jobs.end() && is_end(found->second.phase) &&
      found->second.phase != JobPhase::done && state.has_all_jobs(found->second.owner)) {
    return refuse_one_too_many(connection);
  }
  wire::Envelope reply;
  reply.mutable_retried()->set_count(
      message.job().empty()
          ? (state.release_host(message.host(), now) ? 1 : 0)
          : state.retry(parse_job_name(message.job()), TaskId{message.task()}, now));
  answer(connection, std::move(reply));
}

}  // namespace tetfarm
