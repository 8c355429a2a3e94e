/// What a pool of workers decides: how many to submit and how large, whom to let go, what to
/// cancel.
///
/// A class without I/O and without a clock: what the batch system lists and what the coordinator
/// says go in, what is to be done comes out. Built anew it goes on from what is listed, so the pool
/// may be killed at any instant: nothing that it remembers is needed to stay below its maximum.
///
/// Rules:
///  1. Jobs that are listed, and those that were submitted and are not listed yet, are together
///     never more than `max`. While the batch system does not answer nothing is submitted.
///  2. While the coordinator does not answer all stays as it is: workers outlive it.
///  3. A worker that has nothing to do is drained, not killed: only when it does not leave within
///     `leave_ms` its job is cancelled.
/// Units: milliseconds of the steady clock; bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tetfarm {

struct PoolRules {
  std::string name;               ///< tags of its workers are NAME/JOB
  std::size_t min = 0;            ///< workers that are kept without work
  std::size_t max = 1;            ///< jobs at the batch system, whatever their state
  std::uint64_t least_bytes = 0;  ///< memory of a job: at least, at most; least doubled in between
  std::uint64_t most_bytes = 0;
  std::size_t jobs_a_minute = 60;
  std::size_t most_at_once = 100;     ///< jobs in one submission, or in one cancellation
  std::int64_t idle_ms = 120'000;     ///< without work, before a worker is let go
  std::int64_t unwanted_ms = 15'000;  ///< before a waiting job is taken back
  std::int64_t leave_ms = 120'000;    ///< a drained worker has left by then
  std::int64_t start_ms = 600'000;    ///< a running job's worker is with the coordinator by then
  std::int64_t listing_ms = 60'000;   ///< a submitted job is listed by then
  std::int64_t first_backoff_ms = 5'000;  ///< doubled by each trouble in a row
  std::int64_t longest_backoff_ms = 600'000;
  bool stops = false;  ///< all are let go
};

/// pending: waits for a machine. ending: needs nothing more, but is still there. broken: will never
/// run as it is (held, in error).
enum class PoolJobState { pending, running, ending, broken };

/// A worker's job, as the batch system lists it.
struct PoolJob {
  std::string id;
  PoolJobState state = PoolJobState::pending;
  std::uint64_t bytes = 0;  ///< that were asked for
};

/// A worker, as the coordinator knows it.
struct PoolWorker {
  std::uint64_t worker = 0;
  std::string tag;
  bool is_busy = false;
  bool drains = false;
  std::uint64_t bytes = 0;  ///< for its tasks
  bool is_shunned = false;  ///< gets no tasks: its host is in quarantine
};

struct CoordinatorView {
  std::vector<PoolWorker> workers;
  std::map<std::uint64_t, std::uint64_t> demand;  ///< tasks without worker, by memory
};

struct PoolView {
  std::optional<std::vector<PoolJob>> jobs;  ///< nothing: the batch system did not answer
  std::optional<CoordinatorView> farm;       ///< nothing: the coordinator did not answer
};

/// `count` workers in jobs of `bytes`.
struct WorkerOrder {
  std::size_t count = 0;
  std::uint64_t bytes = 0;

  friend bool operator==(const WorkerOrder&, const WorkerOrder&) = default;
};

struct PoolActions {
  std::vector<WorkerOrder> submit;
  std::vector<std::uint64_t> drain;  ///< workers
  std::vector<std::string> cancel;   ///< jobs
};

/// What a job of so many bytes leaves for tasks: the worker itself and the pages of files that it
/// reads count too, where a control group bounds the job.
std::uint64_t task_bytes(std::uint64_t job_bytes);

class PoolDecisions {
 public:
  explicit PoolDecisions(const PoolRules& rules) : rules_(rules) {}

  /// Cost: O((jobs + workers + max) log).
  PoolActions decide(const PoolView& view, std::int64_t now_ms);

  /// A submission succeeded; `ids` are its jobs.
  void submitted(const WorkerOrder& order, const std::vector<std::string>& ids,
                 std::int64_t now_ms);
  /// One failed, or nobody knows whether it did: the next listing will tell.
  void submission_failed(const WorkerOrder& order, std::int64_t now_ms);

  /// Until when nothing is submitted, for people; 0: not waiting.
  std::int64_t quiet_until_ms() const { return quiet_until_ms_; }

 private:
  struct Known {
    std::uint64_t bytes = 0;
    std::int64_t submitted_ms = 0;
    bool was_listed = false;
    bool had_worker = false;
    std::int64_t running_ms = -1;  ///< since when without worker; -1: not
    std::int64_t surplus_ms = -1;  ///< since when not wanted
    std::int64_t leaves_ms = -1;   ///< when it was told to leave
    std::int64_t cancelled_ms = -1;
  };
  /// A job or a foreign worker that could take a task.
  struct Server {
    std::uint64_t bytes = 0;
    std::string id;            ///< of the job, "": somebody else's worker
    std::uint64_t worker = 0;  ///< idle; 0: still to come
  };
  using Free = std::multimap<std::uint64_t, Server>;  ///< by bytes for tasks

  void note_listing(const std::vector<PoolJob>& jobs, bool farm_answers, std::int64_t now_ms);
  void trouble(std::int64_t now_ms);
  void sort_servers(const PoolView& view, std::int64_t now_ms);
  void take_job(const PoolJob& job, const PoolWorker* worker, std::int64_t now_ms);
  std::vector<std::uint64_t> match(const std::map<std::uint64_t, std::uint64_t>& demand);
  void order(const std::vector<std::uint64_t>& missing, std::int64_t now_ms);
  void drain(const PoolWorker& worker, const std::string& job, std::int64_t now_ms);
  void let_go(std::int64_t now_ms);
  void let_all_go(const PoolView& view, std::int64_t now_ms);
  bool is_spare(const Server& server, bool at_once, std::int64_t patience_ms, std::int64_t now_ms);
  void cancel(const std::string& job, std::int64_t now_ms);
  std::size_t budget(std::int64_t now_ms);
  std::uint64_t size_for(std::uint64_t need) const;

  PoolRules rules_;
  std::map<std::string, Known> jobs_;
  std::deque<std::int64_t> submissions_ms_;  ///< of the last minute, one for each job
  std::int64_t quiet_until_ms_ = 0;
  int troubles_ = 0;

  // Of one decision.
  PoolActions actions_;
  std::size_t present_ = 0;  ///< jobs that count for the maximum
  std::size_t serving_ = 0;  ///< of them, those that work or will
  Free idle_;
  Free coming_;
  std::set<std::string> wanted_;
};

}  // namespace tetfarm
