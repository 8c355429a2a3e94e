#include "coordinator/views/store_at_rest.h"

#include <optional>

#include "base/clock.h"
#include "coordinator/decisions/job_state.h"
#include "coordinator/views/query_answers.h"
#include "store/artifact_store.h"
#include "store/folder_lock.h"
#include "store/job_database.h"

namespace tetfarm {
namespace {

Moment now() { return {steady_ms(), wall_ms()}; }

/// A coordinator on another host may be there though it does not answer here.
bool may_be_served(const std::filesystem::path& store) {
  const std::optional<LockHolder> holder = FolderLock::holder_of_store(store);
  return holder && holder->may_live();
}

void mark_stopped(wire::JobStatus& job) {
  if (job.state() != "running") return;
  job.set_state("stopped");
  job.set_tasks_ready(job.tasks_ready() + job.tasks_running());
  job.set_tasks_running(0);
}

void mark_stopped(wire::TaskLine& task) {
  if (task.state() == "leased") task.set_state("ready");
}

}  // namespace

/// Everything that a coordinator would know, but for who is here.
struct StoreAtRest::Rows {
  Rows(const std::filesystem::path& folder, const std::filesystem::path& path)
      : store(ArtifactStore::open_existing(folder)),
        database(JobDatabase::open_to_read(path)),
        finished(rows_in(database)),
        state(
            unfinished(), {},
            [this](const ArtifactRef& file) { return store.has(file.hash, file.size); }, now(),
            &finished),
        is_served(may_be_served(folder)) {}

  DurableState unfinished() {
    DurableState rows = database.load_unfinished();
    finished.put_others_than(rows);
    return rows;
  }

  ArtifactStore store;
  JobDatabase database;
  FinishedJobs finished;
  JobState state;
  bool is_served;  ///< perhaps: a coordinator has the store, and only does not answer
};

StoreAtRest::StoreAtRest(const std::filesystem::path& store, const std::filesystem::path& database)
    : rows_(std::make_unique<Rows>(store, database / "tetfarm.db")) {}

StoreAtRest::~StoreAtRest() = default;

wire::QueryReply StoreAtRest::answer(const wire::Query& query) const {
  const JobHistory history = rows_->database.history();
  wire::QueryReply reply = answer_query(query, {rows_->state, history, now()});
  if (rows_->is_served) return reply;
  for (wire::JobStatus& job : *reply.mutable_jobs()) mark_stopped(job);
  for (wire::TaskLine& task : *reply.mutable_tasks()) mark_stopped(task);
  if (reply.has_explanation()) mark_stopped(*reply.mutable_explanation()->mutable_task());
  return reply;
}

wire::StatusReply StoreAtRest::status(const std::string& job) const {
  wire::StatusRequest request;
  request.set_job(job);
  wire::StatusReply all = answer_status(request, rows_->state, now());
  while (all.next() != 0) {
    request.set_after(all.next());
    const wire::StatusReply page = answer_status(request, rows_->state, now());
    all.mutable_jobs()->MergeFrom(page.jobs());
    all.set_next(page.next());
  }
  if (rows_->is_served) return all;
  for (wire::JobStatus& one : *all.mutable_jobs()) mark_stopped(one);
  return all;
}

}  // namespace tetfarm
