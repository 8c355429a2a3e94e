/// The decisions of the coordinator: what is ready, who gets it, whose result counts.
///
/// A class without I/O and without a clock: events and the time go in; changed rows (to be
/// committed) and commands (to be carried out after the commit) come out. Built again from the
/// committed rows it goes on where it was, so the daemon may be killed at any instant.
///
/// What it knows beside the rows is in parts, each with its own invariants:
/// worker_sessions.h (who is here), leases.h (who holds
/// which attempt until when), races.h (second attempts of slow tasks), retry_delays.h and
/// host_crashes.h (what fails, when it is tried again, whose fault it is), task_lists.h (what is on
/// offer, at work, in quarantine, and where), tree_progress.h (how far each job is),
/// task_expectation.h, full_disk_pause.h, file_needs.h (which files nobody needs any more);
/// pending_changes.h collects what is to be committed.
///
/// States and transitions of a task: coordinator/decisions/task_states.dot. Messages:
/// proto/protocol.md. Invariants, checked by validate() with those of the parts (5: wherever a task
/// is leased):
///  1. A task is leased exactly when its attempt is running; at most one other, its rival, runs
///  too.
///  2. A done task names the attempt that was accepted; no other is ever accepted for it.
///  3. Every running attempt has a lease; a process holds at most one, whatever its connections,
///  and only the process that was given an attempt holds it.
///  4. A task is on offer exactly when it is ready and its job is running.
///  5. A host in quarantine gets no tasks.
///  6. A place in the graph has one task; those that were replaced there are never run again.
///  7. What is known of the work of an attempt is forgotten with it.
///  8. A job waits for jobs of lower ids, and is listed as waiting exactly when it does.
///  9. An end is listed as untold exactly when its row says so.
/// Units: times in milliseconds.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "coordinator/decisions/attempt_work.h"
#include "coordinator/decisions/cosmetic_graph.h"
#include "coordinator/decisions/fair_turns.h"
#include "coordinator/decisions/file_needs.h"
#include "coordinator/decisions/finished_jobs.h"
#include "coordinator/decisions/full_disk_pause.h"
#include "coordinator/decisions/host_crashes.h"
#include "coordinator/decisions/leases.h"
#include "coordinator/decisions/pending_changes.h"
#include "coordinator/decisions/races.h"
#include "coordinator/decisions/retry_delays.h"
#include "coordinator/decisions/task_expectation.h"
#include "coordinator/decisions/task_graph.h"
#include "coordinator/decisions/task_lists.h"
#include "coordinator/decisions/task_outlook.h"
#include "coordinator/decisions/tree_progress.h"
#include "coordinator/decisions/worker_sessions.h"
#include "store/rows.h"
#include "tasks/failure_cause.h"
#include "tasks/inspect_contract.h"
#include "tasks/solve_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// The time of an event: the steady clock decides, the wall clock is written into tables.
struct Moment {
  std::int64_t steady_ms = 0;
  std::int64_t wall_ms = 0;
};

struct FarmRules {
  std::int64_t lease_ms = 10000;
  std::uint32_t max_crashes = 3;  ///< errors, of the task's own doing; then it is in quarantine
  std::uint32_t max_losses =
      50;  ///< kills and lost leases: operators and schedulers kill processes
  std::uint32_t max_oom_count = 12;    ///< out of memory, each time with twice the room
  std::uint32_t max_further_cuts = 6;  ///< of a leaf, one below the other, for want of memory
  std::uint32_t host_tasks = 3;        ///< that a host failed at and others did: its quarantine
  std::int64_t crash_delay_ms = 1000;  ///< doubled by each crash
  std::int64_t loss_delay_ms = 100;    ///< doubled by each loss
  std::int64_t longest_delay_ms = 30000;
  /// Names the program: results of another one do not serve.
  std::string program;
  std::int64_t elsewhere_ms = 5000;  ///< how long a task waits for a worker it has not failed on
  // A worker ends an attempt after this many times what is expected of its kind, at least …
  std::int64_t limit_factor = 20;
  std::int64_t least_limit_ms = 3'600'000;
  std::int64_t unknown_limit_ms = 86'400'000;  ///< where nothing is expected
  /// Of a program of somebody else's, which has a limit of its own.
  std::int64_t foreign_limit_ms = 31 * std::int64_t{86'400'000};
  // A second attempt races one that takes this many times what is expected, at least …
  std::int64_t late_factor = 3;
  std::int64_t least_late_ms = 10'000;
  /// Which jobs keep all files between their tasks; without it all do.
  KeepsAllFiles keeps_all_files = {};
  std::size_t jobs_per_user = 0;  ///< that may run and wait at once; 0: any number
  bool tells_ends = false;        ///< somebody is to be told of each job's end; see untold_ends()
};

struct WorkerInfo {
  std::string host = {};
  std::int64_t process = 0;
  std::uint32_t cores = 0;
  std::uint64_t memory_bytes = 0;
  std::string program_version = {};
  std::string nonce = {};       ///< random, of this process, on each of its connections; never kept
  bool shares_memory = true;    ///< memory_bytes are the host's, not this worker's own
  std::int64_t ends_in_ms = 0;  ///< until its batch system ends it; 0: not known
  std::string tag = {};         ///< of the pool that brought it
  std::uint64_t pool_memory_bytes = 0;  ///< the most that another worker of its pool can have
  bool runs_solvers = false;            ///< programs of somebody else's, which job files name
  std::string key = {};                 ///< public key of its connection, "": plain
};

struct TaskFailure {
  std::int32_t exit_code = 1;
  std::string message;
  FailureCause cause = FailureCause::for_good;
  std::uint64_t peak_rss_bytes = 0;
  std::vector<std::string> damaged_inputs;  ///< hashes; the shell has checked that they are damaged
  std::vector<ArtifactRef> evidence;
  std::string log;  ///< of the attempt
};

struct Submission {
  std::string key;
  std::string name;
  std::string job_toml;
  InspectGiven given;            ///< job_toml, published, and the surface
  bool replaces_others = false;  ///< running jobs are cancelled: this is the one that is wanted
  std::string owner = {};        ///< the submitter's public key, "": a plain connection
  std::optional<SolveGiven> loop = {};  ///< in place of `given`: the first cycle of a loop
  std::uint64_t loop_memory_bytes = 0;  ///< that its solver asks for; 0: it does not say
  bool remeshes = false;                ///< the surface, before it is inspected
  int priority = 0;                     ///< as of a JobRow; of a job that is there it stays
  std::vector<JobId> after = {};        ///< likewise, in any order
};

struct SubmitAnswer {
  JobId job;
  bool existed = false;
  bool differs = false;  ///< the job of that key has other contents: nothing was done
  /// Of those to wait for one that is unknown, or has failed or was cancelled: nothing was done.
  JobId unmet = {};
  bool is_one_too_many = false;  ///< its owner has as many as one may have: nothing was done
};

/// A worker that is here.
struct WorkerAtWork {
  WorkerRow row;
  TaskId task;  ///< that it runs, 0: none
  AttemptId attempt;
  bool drains = false;
  std::string tag;  ///< of the pool that brought it
};

struct SendWelcome {
  WorkerId worker;
  bool keep_running = false;
};
struct SendAssign {
  WorkerId worker;
  TaskId task;
  AttemptId attempt;
  std::int64_t limit_ms = 0;
};
struct SendDrain {
  WorkerId worker;
};
struct SendAccepted {
  WorkerId worker;
  TaskId task;
  AttemptId attempt;
  bool taken = false;
};
using Command = std::variant<SendWelcome, SendAssign, SendAccepted, SendDrain>;

class JobState {
 public:
  /// Whether the store has a file of that hash and size, without reading it. One that was about to
  /// be removed, as take_unneeded_files() told, stays when it is asked for.
  using HasFile = std::function<bool(const ArtifactRef&)>;

  /// Goes on from what was committed. Attempts that were running keep their lease for another term,
  /// so that their workers can come back. `durable` may lack tasks and sub-domains of jobs that are
  /// in `finished`, where they are read when they are wanted again; without it, it lacks none.
  JobState(DurableState durable, const FarmRules& rules, HasFile has_file, Moment now,
           const FinishedJobs* finished = nullptr);

  // Workers. An unknown worker id is a mistake of the caller: ask knows_worker first.
  bool knows_worker(WorkerId worker) const { return workers_.has(worker); }
  /// Whether the attempt is running there: what else comes in its name is refused.
  bool holds(WorkerId worker, TaskId task, AttemptId attempt) const;
  /// A worker that says Hello; `task` and `attempt` are what it still works on, 0 for nothing.
  WorkerId add_worker(const WorkerInfo& info, TaskId task, AttemptId attempt, Moment now);
  /// Hello again on a known connection.
  void greet_again(WorkerId worker, const WorkerInfo& info, TaskId task, AttemptId attempt,
                   Moment now);
  void worker_is_ready(WorkerId worker, Moment now);
  void heartbeat(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  /// What it says of an attempt that it does not hold is not heard.
  void note_work(WorkerId worker, TaskId task, AttemptId attempt, const WorkCount& count);
  void done(WorkerId worker, TaskId task, AttemptId attempt, const TaskResult& result, Moment now);
  void failed(WorkerId worker, TaskId task, AttemptId attempt, const TaskFailure& failure,
              Moment now);
  /// A worker that said Goodbye, or (`lost`) that cannot be reached any more.
  void worker_left(WorkerId worker, bool lost, Moment now);

  // Clients.
  SubmitAnswer submit(const Submission& submission, Moment now);
  /// Whether the files are there that its first task reads; such as were about to be removed stay.
  bool has_inputs(const Submission& submission) const;
  bool cancel(JobId job, Moment now);
  /// What runs goes on; which tasks are handed out next changes. Of a job that has ended it stays.
  /// False: there is no such job. @pre it is one that a job may have.
  bool set_priority(JobId job, int priority, Moment now);
  /// Takes a task out of quarantine, or (task 0) all of the job; it goes on. How many were taken
  /// out; 0 when there is no such job or task in quarantine.
  std::size_t retry(JobId job, TaskId task, Moment now);
  /// Whether its owner has as many jobs as one may have that run and wait. Cost: O(jobs).
  bool has_all_jobs(const std::string& owner) const;
  /// The job for which this one cannot go on: it waits for that, and that has failed or was
  /// cancelled. 0: there is none, or no such job.
  JobId unmet_by(JobId job) const;
  /// False when the host is not in quarantine.
  bool release_host(const std::string& host, Moment now);
  /// The worker, or (0) every one that is here, gets no more tasks and is told to leave. How many.
  std::size_t drain(WorkerId worker);

  /// The disk is full: nothing is handed out for a while, which is recorded.
  void out_of_resources(const std::string& message, Moment now);
  /// The same without a record, which a full disk would not take. False when it was so already.
  bool hold_back(const std::string& message, Moment now);

  /// Ends leases that have run out and hands out what is ready. Call after every batch of events,
  /// and every now and then.
  void tick(Moment now);

  /// Rows changed since the last call; commit them before carrying out the commands.
  ChangeSet take_changes();
  std::vector<Command> take_commands();

  /// Files that no job needs any more, by their hashes: to be removed once all changes that were
  /// taken are durable, and not before. Some may be gone already.
  std::vector<std::string> take_unneeded_files();
  /// Was in that list, and was not removed.
  void consider_file(const std::string& hash) { file_needs_.consider(hash); }

  /// Jobs that have ended and of which nothing runs, each with its rows, which are forgotten here.
  /// None without a FinishedJobs that takes them. @pre all changes are taken, and committed.
  std::vector<DurableState> take_finished();

  /// Jobs whose end nobody was told yet, durable once the changes are that were taken.
  const std::set<JobId>& untold_ends() const { return untold_ends_; }
  /// It was told, or given up with `trouble`. Nothing happens where the job has gone on meanwhile.
  /// @param finished_ms as of its row then
  void end_was_told(JobId job, std::int64_t finished_ms, const std::string& trouble, Moment now);

  /// Forgets a job that ended that long ago, the newest of them: none of which anything is at hand,
  /// whose end is still to be told, or for which another one waits, or would when it is retried.
  /// Its rows go with the next changes, and once these are durable FinishedJobs is to forget it. 0:
  /// there is none. Cost: O(jobs). @pre keep_ms > 0
  JobId remove_old_job(std::int64_t keep_ms, Moment now);

  /// Jobs all; tasks and sub-domains of those that are not finished.
  const DurableState& durable() const { return durable_; }
  const FinishedJobs& finished() const { return *finished_; }
  bool is_at_hand(JobId job) const { return at_hand_.contains(job); }
  std::size_t worker_count() const { return workers_.all().size(); }
  std::vector<WorkerAtWork> workers_at_work() const;
  /// What a running attempt does; null when nothing was heard of it. Good until it is heard again.
  const AttemptWork* work_of(AttemptId attempt) const { return leases_.work_of(attempt); }
  /// How many tasks would run if there were workers for them, by the memory that each wants (0: not
  /// known): ready ones, and those that a running one brings beside the first. Cost: O(running and
  /// ready tasks), at most O(sub-domains) for each job that joins or orders them.
  /// @param of_solvers those that only workers with solvers do, or the others
  std::map<std::uint64_t, std::uint64_t> demand(bool of_solvers = false) const;
  /// The tasks that run, and as many of the ready ones as are named, those first that are handed
  /// out first.
  std::vector<TaskId> running_and_next(std::size_t count) const;
  bool is_stuck() const { return disk_pause_.is_stuck(); }
  const std::string& stuck_message() const { return disk_pause_.message(); }

  /// A job whose rows are not at hand, by itself, for questions about it; changes nothing here.
  /// @pre finished() has it. Cost: reads its rows.
  JobState past_job(JobId job, Moment now) const;
  /// Why a task does not run, and what it would be given. @pre its rows are at hand.
  TaskOutlook outlook(TaskId task, Moment now) const;
  bool has_file(const ArtifactRef& file) const { return has_file_(file); }

  /// The broken invariants, in words; empty when all is well. Cost: looks at everything.
  std::vector<std::string> validate() const;

 private:
  using Complaints = std::vector<std::string>;

  // job_invariants.cpp
  void find_broken_tasks(Complaints& broken) const;
  void find_broken_attempts(Complaints& broken) const;
  void find_broken_waiting(Complaints& broken) const;

  // job_state.cpp: rows and indexes
  TaskRow& edit(TaskId task);
  JobRow& edit(JobId job);
  void set_state(TaskRow& task, TaskState state);
  void set_phase(JobRow& job, JobPhase phase, Moment now);
  void set_untold(JobRow& job, bool is_untold);
  void put(const SubdomainRow& subdomain);
  void take_in(const TaskRow& task);
  void bring_back(JobId job);
  DurableState take_out(JobId job);
  void index(const TaskRow& task);
  void add_task(TaskRow task, Moment now);
  bool is_served(TaskRow& task) const;
  std::optional<TaskRow> find_row(TaskId task) const;
  void remember_work(const TaskRow& task);
  void record(Moment now, const TaskRow& task, AttemptId attempt, WorkerId worker, const char* what,
              const std::string& message = {});
  const TaskRow* find_task(JobId job, TaskKind kind, std::uint64_t path) const;
  std::vector<SubdomainRow> tree_of(JobId job) const;

  // job_processes.cpp: who is who
  bool is_current(TaskId task, AttemptId attempt) const;
  bool was_accepted(TaskId task, AttemptId attempt) const;
  bool settle_in(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  bool take_over(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  void move_attempt(AttemptId attempt, WorkerId worker, Moment now);

  // job_workers.cpp: sessions, leases, handing out
  void store_log(AttemptId attempt, const std::string& log, std::uint64_t peak_rss_bytes);
  AttemptRow end_attempt(AttemptId attempt, AttemptState state, const std::string& message,
                         Moment now);
  void lose_attempt(AttemptId attempt, AttemptState state, const std::string& message, Moment now);
  void end_leases(Moment now);
  void hand_out(Moment now);
  bool may_work(WorkerId worker) const;
  static bool does_kind(const WorkerSession& session, TaskKind kind);
  bool suits(WorkerId worker, TaskId task, std::uint64_t free_bytes, Moment now) const;
  UsersAtWork users_at_work() const;
  TaskId pick_for(WorkerId worker, const WorkerSessions::HostMemory& used, const UsersAtWork& users,
                  Moment now);
  void lease(WorkerId worker, TaskId task, WorkerSessions::HostMemory& used, Moment now);

  // job_outlook.cpp: why a task does not run
  TaskId maker_of(JobId job, const ArtifactRef& file) const;
  std::vector<std::string> missing_inputs(const TaskRow& task) const;
  std::string why_not(const TaskRow& task, Moment now) const;
  std::vector<std::string> reasons_to_wait(const TaskRow& task, Moment now) const;
  std::vector<std::string> obstacles(const TaskRow& task, Moment now) const;

  // job_dependencies.cpp: jobs that wait for others
  JobId unmet_of(const std::vector<JobId>& after) const;
  JobPhase phase_to_go_on(const JobRow& job) const;
  void settle_waiting_jobs(Moment now);
  void begin(JobRow& job, Moment now);
  void end_with(JobRow& job, const JobRow& other, Moment now);

  // job_removal.cpp: jobs that are forgotten
  bool has_aged(const JobRow& job, std::int64_t keep_ms, Moment now) const;

  // job_races.cpp: time and room
  std::int64_t limit_ms(const TaskRow& task) const;
  std::uint64_t tasks_brought_by(const TaskRow& running) const;
  std::uint64_t memory_for(const TaskRow& task) const;
  bool has_time_for(const WorkerSession& session, const TaskRow& task, Moment now) const;
  std::vector<TaskId> late_tasks(Moment now);
  TaskId pick_late(WorkerId worker, std::vector<TaskId>& late,
                   const WorkerSessions::HostMemory& used, Moment now) const;
  void leave_race(const AttemptRow& ended);
  void revoke_attempts(TaskRow& task, const std::string& why, Moment now);

  // job_decisions.cpp: results, failures, clients
  void advance(const TaskRow& task, Moment now);
  void tree_has_grown(JobId job, Moment now);
  void number_tree(JobId job, Moment now);
  void write_leaves(const TaskRow& number, Moment now);
  void grow_layers(const TaskRow& number, Moment now);
  void assemble_when_written(JobId job, Moment now);
  void carry_out(const GraphStep& step, Moment now);
  void take_failure(TaskRow& task, WorkerId worker, AttemptId attempt, const TaskFailure& failure,
                    Moment now);
  bool has_results(JobId job) const;
  void cancel_others(const Submission& submission, Moment now);

  // job_quarantine.cpp: what fails again and again
  void fail_task(TaskRow& task, std::int32_t exit_code, const std::string& message, Moment now);
  void fail_job(JobId job, std::int32_t exit_code, const std::string& message, Moment now);
  void end_hopeless_jobs(Moment now);
  void count_crash(TaskRow& task, WorkerId worker, const std::string& message, Moment now);
  void count_loss(TaskRow& task, const std::string& message, Moment now);
  void count_out_of_memory(TaskRow& task, std::uint64_t had_bytes, const TaskFailure& failure,
                           Moment now);
  void forgive(TaskId task);
  void resume(JobRow& job, Moment now);

  // job_hosts.cpp: hosts on which tasks crash
  void note_crash_on_host(const TaskRow& task, WorkerId worker, const std::string& message);
  bool waits_for_another_host(const TaskRow& task, const std::string& host, Moment now) const;
  bool counts_against_host(const TaskRow& task, WorkerId worker, Moment now) const;
  void note_done_on_host(TaskId task, const std::string& host, Moment now);
  void quarantine_if_proven(const std::string& host, Moment now);
  bool has_host_besides(const std::string& host) const;

  // job_further_cuts.cpp: leaves that no worker has the memory for
  std::string why_no_further_cut(const TaskRow& task) const;
  void cut_further(JobId job, std::uint64_t leaf, const std::string& why, std::uint64_t room_bytes,
                   Moment now);
  void replace(TaskId task, const std::string& why, Moment now);
  void replace_turns(JobId job, const std::string& why, Moment now);
  void note_replaced(const TaskRow& task);
  std::string why_cut_further(JobId job, std::uint64_t path) const;

  // job_cosmetics.cpp: turns in cosmetics across cuts
  const TaskRow* find_done(JobId job, TaskKind kind, std::uint64_t path) const;
  const TurnOrder& turns_of(JobId job);
  void order_when_whole(JobId job, Moment now);
  void extract_when_ordered(JobId job, std::uint64_t leaf, Moment now);
  void give_turns_round(JobId job, std::uint64_t leaf, Moment now);

  // job_files.cpp: files that nobody needs
  struct FilesOfJob {
    FileStage stage = FileStage::growing;
    bool stay = true;
  };
  FileStage file_stage(JobId job) const;
  FilesOfJob files_of(JobId job);
  void note_files(const TaskRow& task, const FilesOfJob& files);
  void note_files(const SubdomainRow& subdomain, const FilesOfJob& files);
  void note_files_of_tree(JobId job);

  // job_repair.cpp: files that were lost
  void settle_waiting(TaskId task, Moment now);
  void wake_waiting(JobId job, Moment now);
  void remake(JobId job, const ArtifactRef& file, Moment now);
  void remake_results(JobRow& job, Moment now);

  DurableState durable_;
  FarmRules rules_;
  HasFile has_file_;
  const FinishedJobs* finished_;

  std::set<JobId> at_hand_;       ///< whose tasks and sub-domains are in durable_
  std::set<JobId> waiting_jobs_;  ///< for others
  bool some_job_ended_ = true;    ///< since those were looked at
  std::set<JobId> untold_ends_;   ///< as their rows say
  std::int64_t next_end_ms_ = std::numeric_limits<std::int64_t>::min();  ///< see end_leases
  /// After a restart workers come back one by one: until then the largest may be missing.
  std::int64_t all_back_ms_ = std::numeric_limits<std::int64_t>::min();
  WorkerSessions workers_;
  Leases leases_;
  Races races_;
  RetryDelays delays_;
  HostCrashes host_crashes_;
  TaskLists lists_;
  TreeProgress progress_;
  TaskExpectation expectation_;
  FullDiskPause disk_pause_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::set<TaskId>> done_work_;  ///< by work_key
  std::map<std::pair<std::string, std::string>, JobId> keys_;  ///< by owner and key
  std::map<JobId, FilesOfJob> files_of_jobs_;
  FileNeeds file_needs_;
  PendingChanges changes_;
  std::vector<Command> commands_;
};

/// "mesh of sub-domain 5", for people.
std::string place_of(const TaskRow& task);

/// Whether the files of a task that is not done are the outputs of an earlier run, which other
/// tasks build upon; otherwise they are the evidence of a failure.
bool was_done_before(const TaskRow& task);

}  // namespace tetfarm
