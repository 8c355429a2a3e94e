#include "coordinator/server.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <zmq_addon.hpp>

#include "base/clock.h"
#include "base/file_system.h"
#include "base/program_identity.h"
#include "coordinator/authenticator.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/file_thread.h"
#include "coordinator/guarded_database.h"
#include "coordinator/job_end_program.h"
#include "coordinator/kept_files.h"
#include "coordinator/log_lines.h"
#include "coordinator/removal_thread.h"
#include "coordinator/request_handler.h"
#include "coordinator/service_manager.h"
#include "coordinator/space_watch.h"
#include "coordinator/start_rules.h"
#include "coordinator/stop_signals.h"
#include "coordinator/surface_roots.h"
#include "coordinator/views/refusals.h"
#include "coordinator/views/status_server.h"
#include "proto/address_family.h"
#include "proto/keys_folder.h"
#include "proto/local_endpoint.h"
#include "proto/peer_security.h"
#include "proto/wire.h"
#include "store/artifact_store.h"
#include "store/attempt_scratch.h"
#include "store/folder_lock.h"
#include "store/garbage.h"

namespace tetfarm {
namespace {

constexpr int turn_ms = 50;
constexpr int messages_per_commit = 256;
/// After a turn for nothing but heartbeats: those of a large farm then come several at a time.
constexpr std::chrono::milliseconds rest{4};
constexpr int linger_ms = 500;
constexpr std::int64_t between_removals_ms = 10'000;
constexpr std::int64_t scratch_age_ms = std::int64_t{7} * 24 * 3600 * 1000;

spdlog::logger make_log(const CoordinatorOptions& options) {
  auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>(
      (options.store / "coordinator.log").string());
  auto terminal = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  terminal->set_level(options.log_to_stderr ? spdlog::level::info : spdlog::level::warn);
  spdlog::logger log("coordinator", {file, terminal});
  log.set_formatter(one_line_formatter());
  log.flush_on(spdlog::level::warn);
  // A full disk must not flood the terminal with spdlog's own complaints.
  log.set_error_handler([](const std::string&) {});
  return log;
}

KeyPlaces key_places(const CoordinatorOptions& options) {
  return {options.keys, default_keys_folder(),
          database_folder(options.store, options.database) / "keys"};
}

/// None where this coordinator shall not use them: a run of its own speaks with itself only.
KeysInUse keys_of(const CoordinatorOptions& options) {
  if (options.insecure) return {{}, "--insecure", {}};
  if (options.one_job) return {};
  return find_keys(key_places(options));
}

/// Also the folders of keys that are not used now: they may have some.
ClosedPlaces closed_places(const CoordinatorOptions& options) {
  const KeyPlaces keys = key_places(options);
  ClosedPlaces closed{options.store,
                      database_folder(options.store, options.database),
                      {keys.standard, keys.old, options.store / "keys"},
                      {}};
  if (!keys.wanted.empty()) closed.keys.push_back(keys.wanted);
  if (!options.http_token.empty()) closed.files.push_back(options.http_token);
  return closed;
}

/// Others than the group never see what a service writes; what the group may, the umask says. The
/// store of a run is its user's own business.
void keep_others_out(const CoordinatorOptions& options) {
  if (!options.one_job) ::umask(::umask(0) | S_IRWXO);
}

Moment now() { return {steady_ms(), wall_ms()}; }

bool keeps_all_of_row(const JobRow& job) { return keeps_all_files(job); }

std::string environment_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

class Server {
 public:
  explicit Server(const CoordinatorOptions& options)
      : options_(options),
        store_(options.store),
        lock_(FolderLock::of_store(options.store)),
        log_(make_log(options)),
        database_(prepared_database(options.store, options.database, store_.probe())),
        finished_(rows_in(database_.rows()), keeps_all_of_row),
        roots_(options.allowed_roots, closed_places(options)),
        keys_(keys_of(options)),
        authenticator_(context_,
                       {.keys_folder = keys_.folder,
                        .max_connections = options.max_connections,
                        .handshake_ms = options.handshake_ms},
                       refusals_),
        socket_(context_, zmq::socket_type::router),
        handler_(store_, roots_,
                 {.heartbeat_ms = options.heartbeat_ms,
                  .lease_ms = options.lease_ms,
                  .max_workers = options.max_workers,
                  .may_replace_jobs = options.one_job,
                  .jobs_per_user = options.jobs_per_user},
                 refusals_),
        files_(store_),
        removals_(store_),
        space_(options.store, database_folder(options.store, options.database)),
        status_({.address = options.http_address, .token_file = options.http_token}, options.store,
                wall_ms()),
        service_(environment_variable) {
    rules_.lease_ms = options.lease_ms;
    rules_.least_limit_ms = options.task_limit_ms;
    rules_.unknown_limit_ms = options.first_task_limit_ms;
    rules_.program = program_identity();
    rules_.keeps_all_files = keeps_all_of_row;
    rules_.jobs_per_user = options.jobs_per_user;
    rules_.tells_ends = !options.on_job_end.empty();
    allow_open_files(2 * options.max_connections);
    restore();
    sweep_up();
    bind();
    if (rules_.tells_ends) watch_ends();
  }

  void run() {
    const StopSignals signals(options_.handle_signals);
    log_.info("started, protocol {}, store {}", protocol_version, options_.store.string());
    tell_security();
    log_.flush();
    if (options_.on_listening) options_.on_listening(endpoints_);
    if (options_.on_http && !status_.address().empty()) options_.on_http(status_.address());
    service_.ready("listening on " + endpoints_.front());
    while (!signals.stopped() && !(options_.stop != nullptr && options_.stop->load())) turn();
    service_.stopping();
    remove_file(endpoints_file(options_.store));
    const std::string saved = database_.save_when_removed(wall_ms());
    if (!saved.empty()) log_.warn("what the database held has been saved in {}", saved);
    log_.info("stopped");
  }

 private:
  void restore() {
    DurableState rows = database_.rows().load_unfinished();
    finished_.put_others_than(rows, [this](const ArtifactRef& file) { return has_file(file); });
    state_ = std::make_unique<JobState>(
        std::move(rows), rules_, [this](const ArtifactRef& file) { return has_file(file); }, now(),
        &finished_);
    for (const std::string& hash : finished_.take_leavings()) state_->consider_file(hash);
    for (const auto& [id, task] : state_->durable().tasks) space_.note(task);
  }

  void sweep_up() {
    std::set<AttemptId> running;
    for (const auto& [id, attempt] : state_->durable().running_attempts) running.insert(id);
    drop_uploads_but(running, store_);
    sweep_leftovers(store_, running, untouchable_since_ms(state_->durable()));
    handler_.remember_surfaces(begun_surfaces(store_), now());
  }

  void watch_ends() {
    JobEndOptions told;
    told.program = checked_job_end_program(options_.on_job_end);
    told.store = std::filesystem::absolute(options_.store);
    told.endpoint = endpoints_.front();
    ends_ = std::make_unique<JobEndProgram>(std::move(told));
  }

  /// One in a turn, as its rows are read; the rows of which to forget when that is durable.
  std::optional<DurableState> remove_old_job() {
    if (options_.keep_ms == 0 || now().steady_ms < next_removal_ms_) return std::nullopt;
    const JobId job = state_->remove_old_job(options_.keep_ms, now());
    if (job) return finished_.rows_of(job);
    next_removal_ms_ = now().steady_ms + between_removals_ms;
    return std::nullopt;
  }

  /// Its files that no other job needs go in the next turn.
  void forget(const DurableState& job) {
    finished_.forget(job);
    for (const auto& [id, task] : job.tasks) {
      for (const ArtifactRef& file : task.inputs) state_->consider_file(file.hash);
      for (const ArtifactRef& file : task.outputs) state_->consider_file(file.hash);
    }
  }

  /// Of those that were told, before the commit.
  void note_told_ends() {
    if (!ends_) return;
    for (const ToldEnd& told : ends_->take_told()) {
      if (!told.trouble.empty()) log_.error("{}", told.trouble);
      state_->end_was_told(told.job, told.finished_ms, told.trouble, now());
    }
    for (const std::string& line : ends_->take_troubles()) log_.warn("{}", line);
  }

  /// While tasks are handed out, a file that many of them read is looked for once. One that
  /// somebody asks for is not removed now.
  bool has_file(const ArtifactRef& file) const {
    if (removals_.keep(file.hash)) spared_files_.push_back(file.hash);
    if (seen_files_ && seen_files_->contains({file.hash, file.size})) return true;
    try {
      const bool is_there = store_.has(file.hash, file.size);
      if (seen_files_ && is_there) seen_files_->emplace(file.hash, file.size);
      return is_there;
    } catch (const IoError& error) {
      log_.warn("{}", error.what());
      return false;
    }
  }

  void bind() {
    if (options_.endpoints.empty())
      throw UsageError("is missing: there is no address to listen on", "--listen");
    socket_.set(zmq::sockopt::router_mandatory, true);
    // No handover: whoever claims the name of another's connection is not heard.
    socket_.set(zmq::sockopt::linger, linger_ms);
    // Workers' heartbeats are our own; these find connections whose other end is gone.
    socket_.set(zmq::sockopt::heartbeat_ivl, 10'000);
    socket_.set(zmq::sockopt::heartbeat_timeout, 20'000);
    authenticator_.guard(socket_);
    std::string list;
    for (const std::string& endpoint : options_.endpoints) {
      listen(endpoint);
      list += endpoints_.back() + "\n";
    }
    // Whoever finds the endpoints shall find the key too.
    if (authenticator_.has_keys()) {
      write_public_key(published_key_path(options_.store), authenticator_.public_key());
    } else {
      remove_file(published_key_path(options_.store));
    }
    write_file_atomically(endpoints_file(options_.store), list);
    store_.sweep_scratch(scratch_age_ms);
  }

  void listen(const std::string& endpoint) {
    if (!options_.insecure && !authenticator_.has_keys() && !is_local(endpoint)) {
      throw UsageError("other hosts can connect, and this coordinator has no key (" + keys_.remark +
                           "): make one with `tetfarm keys new coordinator --keys " +
                           default_keys_folder().string() + "`, or let anyone in with --insecure",
                       endpoint);
    }
    authenticator_.make_next_listener(socket_, authenticator_.has_keys() && !is_ipc(endpoint));
    set_address_family(socket_, endpoint, EndpointUse::bind);
    try {
      socket_.bind(endpoint);
    } catch (const zmq::error_t& error) {
      throw UsageError(std::string("cannot listen: ") + error.what(), endpoint);
    }
    endpoints_.push_back(socket_.get(zmq::sockopt::last_endpoint));
  }

  void tell_security() {
    const bool is_open =
        std::any_of(options_.endpoints.begin(), options_.endpoints.end(),
                    [](const std::string& endpoint) { return !is_local(endpoint); });
    if (authenticator_.has_keys()) {
      handler_.set_security("keys");
      log_.info("encrypted, {}, {} authorised", keys_.remark, authenticator_.authorized());
    } else if (is_open) {
      handler_.set_security("insecure");
      log_.warn(
          "INSECURE: anyone who can reach this coordinator may submit and cancel jobs and hand in "
          "results");
    } else {
      log_.info("plain text, this host only{}", keys_.remark.empty() ? "" : ": " + keys_.remark);
    }
    if (!keys_.warning.empty()) log_.warn("{}", keys_.warning);
  }

  void turn() {
    watch_database();
    receive();
    if (database_.is_closed()) return turn_while_closed();
    watch_space();
    for (const std::string& hash : std::exchange(spared_files_, {})) state_->consider_file(hash);
    note_told_ends();
    seen_files_.emplace();
    state_->tick(now());
    seen_files_.reset();
    handler_.carry_out(*state_, now());
    const std::optional<DurableState> removed = remove_old_job();
    const ChangeSet changes = state_->take_changes();
    const std::vector<std::string> unneeded = state_->take_unneeded_files();
    const bool committed = commit(changes);
    if (committed) note(changes);
    if (committed && removed) forget(*removed);
    if (committed) removals_.give(unneeded);
    write_complaints();
    send_all(committed ? handler_.take_replies() : handler_.take_replies_uncommitted());
    if (!committed) start_over();
    tell();
    const bool moved_files = move_files();
    if (handler_.take_only_heartbeats() && !moved_files) std::this_thread::sleep_for(rest);
  }

  /// Nothing is decided. What files bring is forgotten like all else when it opens again.
  void turn_while_closed() {
    handler_.close(database_.trouble(), database_.trouble_code());
    state_->hold_back(database_.trouble(), now());
    files_.take_answers();
    write_complaints();
    send_all(handler_.take_replies());
    tell();
    if (handler_.take_only_heartbeats()) std::this_thread::sleep_for(rest);
  }

  /// Answers who only wants to know.
  void tell() {
    const JobHistory history = database_.rows().history();
    handler_.answer_questions(*state_, history, authenticator_, now());
    send_all(handler_.take_replies());
    status_.serve({*state_, history, now()},
                  {refusals_, database_.trouble(), authenticator_.connections()});
    service_.turn(now().steady_ms);
  }

  void watch_database() {
    switch (database_.look(now().steady_ms)) {
      case GuardedDatabase::Look::as_before:
        return;
      case GuardedDatabase::Look::has_closed:
        return close();
      case GuardedDatabase::Look::has_opened:
        log_.warn("the database can be written to again");
        handler_.open();
        handler_.forget_workers();
        restore();
    }
  }

  void close() {
    log_.error("{}", database_.trouble());
    handler_.close(database_.trouble(), database_.trouble_code());
  }

  void watch_space() {
    try {
      const std::string trouble = space_.trouble(*state_, now());
      if (!trouble.empty()) state_->out_of_resources(trouble, now());
    } catch (const IoError& error) {
      log_.warn("{}", error.what());
    }
  }

  /// After the commit: an attempt whose end is not durable may still bring its files. Last of all:
  /// what is decided here is committed in the next turn. Whether there were any.
  bool move_files() {
    std::vector<FileAnswer> answers = files_.take_answers();
    for (FileAnswer& answer : answers) {
      handler_.note_file(answer, *state_, now());
      if (!answer.trouble.empty()) log_.warn("{}", answer.trouble);
      if (answer.is_out_of_room) state_->out_of_resources(answer.trouble, now());
      if (answer.envelope.body_case() == wire::Envelope::BODY_NOT_SET) continue;
      send({answer.connection, std::move(answer.envelope), false});
    }
    for (FileOrder& order : handler_.take_file_orders(*state_, now())) {
      files_.give(std::move(order));
    }
    return !answers.empty();
  }

  void receive() {
    std::vector<zmq::pollitem_t> items = authenticator_.poll_items();
    items.push_back({nullptr, files_.fd(), ZMQ_POLLIN, 0});
    items.push_back({socket_.handle(), 0, ZMQ_POLLIN, 0});
    status_.add_poll_items(items);
    try {
      zmq::poll(items, std::chrono::milliseconds(turn_ms));
    } catch (const zmq::error_t& error) {
      if (error.num() != EINTR) throw;
      return;
    }
    authenticator_.serve(now().steady_ms);
    for (int i = 0; i < messages_per_commit; ++i) {
      std::vector<zmq::message_t> parts;
      const auto count =
          zmq::recv_multipart(socket_, std::back_inserter(parts), zmq::recv_flags::dontwait);
      // What has changed until now counts for this message already.
      if (authenticator_.has_new_list()) handler_.expel(authenticator_, *state_, now());
      if (!count) return;
      const Sender sender = authenticator_.sender_of(parts.back(), parts.front().to_string());
      try {
        if (parts.size() != 2) {
          handler_.drop(sender, std::to_string(parts.size()) + " frames", now());
        } else {
          handler_.handle(sender, parts[1].to_string_view(), *state_, now());
        }
      } catch (const Error& error) {
        log_.error("while answering a message: {}", error.what());
      }
    }
  }

  void write_complaints() {
    for (const std::string& line : authenticator_.take_complaints()) log_.warn("{}", line);
    for (const std::string& line : refusals_.take_complaints()) log_.warn("{}", line);
    for (const std::string& line : handler_.take_complaints()) log_.warn("{}", line);
    for (const std::string& line : removals_.take_troubles()) log_.warn("{}", line);
  }

  /// False when the database is locked by somebody, which passes, or closed.
  bool commit(const ChangeSet& changes) {
    const auto start = std::chrono::steady_clock::now();
    const GuardedDatabase::Outcome outcome = database_.commit(changes);
    if (outcome == GuardedDatabase::Outcome::committed) {
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      status_.note(changes, took.count());
      return true;
    }
    status_.note_failed_commit();
    log_.error("cannot commit: {}", database_.last_failure());
    if (database_.is_closed()) close();
    return false;
  }

  /// What was decided but not committed never happened: the same as a restart.
  void start_over() {
    handler_.forget_workers();
    restore();
    state_->hold_back(database_.last_failure(), now());
  }

  void note(const ChangeSet& changes) {
    for (const TaskRow& task : changes.tasks) space_.note(task);
    write_log(changes);
    for (FileOrder& order : handler_.orders_after(changes)) files_.give(std::move(order));
    for (const DurableState& job : state_->take_finished()) finished_.put(job);
    if (!ends_) return;
    for (const JobId id : state_->untold_ends()) ends_->give(state_->durable().jobs.at(id));
  }

  void write_log(const ChangeSet& changes) {
    for (const EventRow& event : changes.events) {
      const bool is_bad = event.what == "job failed" || event.what == "stuck";
      log_.log(is_bad ? spdlog::level::warn : spdlog::level::info,
               "job={} task={} attempt={} worker={} {} {}", event.job.value, event.task.value,
               event.attempt.value, event.worker.value, event.what, event.message);
    }
    if (!changes.events.empty()) log_.flush();
  }

  void send_all(std::vector<Reply> replies) {
    for (Reply& reply : replies) send(std::move(reply));
  }

  void send(Reply reply) {
    const bool is_assign = reply.envelope.has_assign();
    try {
      const std::string bytes = encode(std::move(reply.envelope));
      const auto head = socket_.send(zmq::buffer(reply.connection),
                                     zmq::send_flags::sndmore | zmq::send_flags::dontwait);
      if (head && socket_.send(zmq::buffer(bytes), zmq::send_flags::dontwait)) return;
      log_.info("a reply was dropped: its receiver does not read");
    } catch (const zmq::error_t& error) {
      if (error.num() != EHOSTUNREACH) log_.warn("cannot send: {}", error.what());
    } catch (const Error& error) {
      log_.error("cannot send: {}", error.what());
    }
    // Other messages are said again when they are missed; a lost task would wait for its lease.
    const WorkerId worker = handler_.worker_of(reply.connection);
    if (is_assign && worker) state_->worker_left(worker, true, now());
  }

  CoordinatorOptions options_;
  ArtifactStore store_;
  FolderLock lock_;
  mutable spdlog::logger log_;
  GuardedDatabase database_;
  FinishedJobs finished_;
  FarmRules rules_;
  SurfaceRoots roots_;
  KeysInUse keys_;
  Refusals refusals_;
  zmq::context_t context_;
  Authenticator authenticator_;
  zmq::socket_t socket_;
  RequestHandler handler_;
  FileThread files_;
  mutable RemovalThread removals_;
  SpaceWatch space_;
  StatusServer status_;
  ServiceManager service_;
  std::unique_ptr<JobState> state_;
  std::unique_ptr<JobEndProgram> ends_;  ///< none where nobody is to be told
  std::int64_t next_removal_ms_ = 0;     ///< of the steady clock
  std::vector<std::string> endpoints_;
  mutable std::optional<std::set<std::pair<std::string, std::uint64_t>>> seen_files_;
  mutable std::vector<std::string> spared_files_;  ///< that were to be removed, and were asked for
};

}  // namespace

std::filesystem::path endpoints_file(const std::filesystem::path& store) {
  return store / "endpoints";
}

ExitCode run_coordinator(const CoordinatorOptions& options) {
  keep_others_out(options);
  Server(options).run();
  return ExitCode::ok;
}

}  // namespace tetfarm
