/// The decisions of the coordinator: what is ready, who gets it, whose result counts.
///
/// A class without I/O and without a clock: events and the time go in; changed rows (to be
/// committed) and commands (to be carried out after the commit) come out. Built again from the
/// committed rows it goes on where it was, so the daemon may be killed at any instant.
///
/// States and transitions of a task: coordinator/task_states.dot. Messages: proto/protocol.md.
/// Invariants, checked by validate():
///  1. A task is leased exactly when its attempt is the one running attempt of that task.
///  2. A done task names the attempt that was accepted; no other is ever accepted for it.
///  3. Every running attempt has a lease; a worker holds at most one.
///  4. A task is on offer exactly when it is ready and its job is running.
/// Units: times in milliseconds.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "coordinator/cosmetic_graph.h"
#include "coordinator/task_graph.h"
#include "store/rows.h"

namespace tetfarm {

/// The time of an event: the steady clock decides, the wall clock is written into tables.
struct Moment {
  std::int64_t steady_ms = 0;
  std::int64_t wall_ms = 0;
};

struct FarmRules {
  std::int64_t lease_ms = 10000;
  std::uint32_t max_crashes = 3;  ///< of the task's own doing; then it is poisoned
  std::uint32_t max_losses =
      50;  ///< kills and lost leases: operators and schedulers kill processes
  std::int64_t crash_delay_ms = 1000;  ///< doubled by each crash
  std::int64_t loss_delay_ms = 100;    ///< doubled by each loss
  std::int64_t longest_delay_ms = 30000;
  /// Names the program: results of another one do not serve.
  std::string program;
  std::int64_t elsewhere_ms = 5000;  ///< how long a task waits for a worker it has not failed on
};

struct WorkerInfo {
  std::string host;
  std::int64_t process = 0;
  std::uint32_t cores = 0;
  std::uint64_t memory_bytes = 0;
  std::string program_version;
};

struct TaskFailure {
  std::int32_t exit_code = 1;
  std::string message;
  bool may_retry = false;
  bool out_of_resources = false;
  bool killed = false;
  std::vector<std::string> damaged_inputs;  ///< hashes; the shell has checked that they are damaged
  std::vector<ArtifactRef> evidence;
};

struct Submission {
  std::string key;
  std::string name;
  std::string job_toml;
  ArtifactRef job_file;  ///< job_toml, published
  std::vector<ArtifactRef> inputs;
  bool replaces_others = false;  ///< running jobs are cancelled: this is the one that is wanted
};

struct SubmitAnswer {
  JobId job;
  bool existed = false;
};

struct SendWelcome {
  WorkerId worker;
  bool keep_running = false;
};
struct SendAssign {
  WorkerId worker;
  TaskId task;
  AttemptId attempt;
};
struct SendAccepted {
  WorkerId worker;
  TaskId task;
  AttemptId attempt;
  bool taken = false;
};
using Command = std::variant<SendWelcome, SendAssign, SendAccepted>;

class JobState {
 public:
  /// Whether the store has a file of that hash and size, without reading it.
  using HasFile = std::function<bool(const ArtifactRef&)>;

  /// Goes on from what was committed. Attempts that were running keep their lease for another term,
  /// so that their workers can come back.
  JobState(DurableState durable, const FarmRules& rules, HasFile has_file, Moment now);

  // Workers. An unknown worker id is a mistake of the caller: ask knows_worker first.
  bool knows_worker(WorkerId worker) const { return sessions_.contains(worker); }
  /// A worker that says Hello; `task` and `attempt` are what it still works on, 0 for nothing.
  WorkerId add_worker(const WorkerInfo& info, TaskId task, AttemptId attempt, Moment now);
  /// Hello again on a known connection.
  void greet_again(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  void worker_is_ready(WorkerId worker, Moment now);
  void heartbeat(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  void done(WorkerId worker, TaskId task, AttemptId attempt, const TaskResult& result, Moment now);
  void failed(WorkerId worker, TaskId task, AttemptId attempt, const TaskFailure& failure,
              Moment now);
  /// A worker that said Goodbye, or (`lost`) that cannot be reached any more.
  void worker_left(WorkerId worker, bool lost, Moment now);

  // Clients.
  SubmitAnswer submit(const Submission& submission, Moment now);
  bool cancel(JobId job, Moment now);

  /// The disk is full: nothing is handed out for a while.
  void out_of_resources(const std::string& message, Moment now);

  /// Ends leases that have run out and hands out what is ready. Call after every batch of events,
  /// and every now and then.
  void tick(Moment now);

  /// Rows changed since the last call; commit them before carrying out the commands.
  ChangeSet take_changes();
  std::vector<Command> take_commands();

  const DurableState& durable() const { return durable_; }
  std::size_t worker_count() const { return sessions_.size(); }
  bool is_stuck() const { return stuck_delay_ms_ > 0; }
  const std::string& stuck_message() const { return stuck_message_; }

  /// The broken invariants, in words; empty when all is well. Cost: looks at everything.
  std::vector<std::string> validate() const;

 private:
  struct Session {
    AttemptId attempt;  ///< running there, 0: none
    bool ready = false;
    std::int64_t heard_ms = 0;
  };
  using Offer = std::tuple<int, TaskId>;  ///< rank, task
  using Place = std::tuple<JobId, TaskKind, std::uint64_t>;

  // job_state.cpp: rows and indexes
  TaskRow& edit(TaskId task);
  JobRow& edit(JobId job);
  void set_state(TaskRow& task, TaskState state);
  void set_phase(JobRow& job, JobPhase phase, Moment now);
  void put(const SubdomainRow& subdomain);
  void index(const TaskRow& task);
  void index(const SubdomainRow& subdomain, bool adds);
  void add_task(TaskRow task, Moment now);
  bool is_served(TaskRow& task) const;
  void remember_work(const TaskRow& task);
  void record(Moment now, const TaskRow& task, AttemptId attempt, WorkerId worker, const char* what,
              const std::string& message = {});
  const TaskRow* find_task(JobId job, TaskKind kind, std::uint64_t path) const;
  std::vector<TaskId> tasks_of(JobId job) const;
  std::vector<SubdomainRow> tree_of(JobId job) const;

  // job_workers.cpp: sessions, leases, handing out
  bool is_current(TaskId task, AttemptId attempt) const;
  bool was_accepted(TaskId task, AttemptId attempt) const;
  bool take_over(WorkerId worker, TaskId task, AttemptId attempt, Moment now);
  AttemptRow end_attempt(AttemptId attempt, AttemptState state, const std::string& message,
                         Moment now);
  void lose_attempt(AttemptId attempt, AttemptState state, const std::string& message, Moment now);
  void hand_out(Moment now);
  TaskId pick_for(WorkerId worker, Moment now);
  void lease(WorkerId worker, TaskId task, Moment now);

  // job_decisions.cpp: results, failures, clients
  void advance(const TaskRow& task, Moment now);
  void tree_has_grown(JobId job, Moment now);
  void finish_tree(JobId job, Moment now);
  void carry_out(const GraphStep& step, Moment now);
  void fail_task(TaskRow& task, std::int32_t exit_code, const std::string& message, Moment now);
  void fail_job(JobId job, std::int32_t exit_code, const std::string& message, Moment now);
  void count_crash(TaskRow& task, const std::string& message, Moment now);
  void count_loss(TaskRow& task, const std::string& message, Moment now);
  void resume(JobRow& job, Moment now);
  void cancel_others(const std::string& key, Moment now);

  // job_cosmetics.cpp: turns in cosmetics across cuts
  const TaskRow* find_done(JobId job, TaskKind kind, std::uint64_t path) const;
  const TurnOrder& turns_of(JobId job);
  void order_when_whole(JobId job, Moment now);
  void extract_when_ordered(JobId job, std::uint64_t leaf, Moment now);
  void give_turns_round(JobId job, std::uint64_t leaf, Moment now);
  bool had_all_turns(JobId job);

  // job_repair.cpp: files that were lost
  void settle_waiting(TaskId task, Moment now);
  void wake_waiting(JobId job, Moment now);
  void remake(JobId job, const ArtifactRef& file, Moment now);
  void remake_results(JobRow& job, Moment now);

  DurableState durable_;
  FarmRules rules_;
  HasFile has_file_;

  std::map<WorkerId, Session> sessions_;
  std::map<AttemptId, std::int64_t> lease_ends_ms_;
  std::set<Offer> offers_;
  std::map<TaskId, std::int64_t> not_before_ms_;
  std::map<TaskId, WorkerId> failed_on_;
  std::map<Place, TaskId> places_;
  std::map<JobId, std::int64_t> unsettled_;  ///< sub-domains still to be cut or meshed
  std::map<JobId, std::int64_t> open_;       ///< sub-domains still to be cut
  std::map<JobId, TurnOrder> turns_;
  std::map<JobId, std::int64_t> turns_over_;
  std::multimap<std::string, TaskId> done_work_;
  std::map<std::string, JobId> keys_;
  std::int64_t stuck_until_ms_ = 0;
  std::int64_t stuck_delay_ms_ = 0;  ///< 0: not stuck
  std::string stuck_message_;

  std::set<JobId> dirty_jobs_;
  std::set<TaskId> dirty_tasks_;
  std::set<SubdomainKey> dirty_subdomains_;
  std::map<AttemptId, AttemptRow> dirty_attempts_;
  std::map<WorkerId, WorkerRow> dirty_workers_;
  std::map<WorkerId, WorkerRow> workers_;
  std::vector<EventRow> new_events_;
  std::vector<Command> commands_;
};

}  // namespace tetfarm
