#include "coordinator/store_at_rest.h"

#include "base/clock.h"
#include "coordinator/job_state.h"
#include "coordinator/query_answers.h"
#include "store/artifact_store.h"
#include "store/job_database.h"

namespace tetfarm {
namespace {

Moment now() { return {steady_ms(), wall_ms()}; }

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
            &finished) {}

  DurableState unfinished() {
    DurableState rows = database.load_unfinished();
    finished.put_others_than(rows);
    return rows;
  }

  ArtifactStore store;
  JobDatabase database;
  FinishedJobs finished;
  JobState state;
};

StoreAtRest::StoreAtRest(const std::filesystem::path& store, const std::filesystem::path& database)
    : rows_(std::make_unique<Rows>(store, database / "tetfarm.db")) {}

StoreAtRest::~StoreAtRest() = default;

wire::QueryReply StoreAtRest::answer(const wire::Query& query) const {
  const JobHistory history = rows_->database.history();
  return answer_query(query, {rows_->state, history, now()});
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
  return all;
}

}  // namespace tetfarm
