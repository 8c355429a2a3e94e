#include "worker/run_task.h"

#include <cerrno>
#include <new>

#include "base/error.h"
#include "store/attempt_scratch.h"
#include "tasks/failure_cause.h"
#include "worker/job_forecast.h"

namespace tetfarm {
namespace {

wire::Failed failure(const Error& error, FailureCause cause) {
  wire::Failed failed;
  failed.set_message(error.what());
  failed.set_exit_code(static_cast<int>(error.code()));
  failed.set_cause(on_wire(cause));
  return failed;
}

/// Where no more is known of an error than its code.
FailureCause cause_of(ExitCode code) {
  return code == ExitCode::out_of_resources ? FailureCause::disk_full : FailureCause::error;
}

/// Evidence that cannot be stored must not hide the reason itself.
void add_evidence(wire::Failed& failed, const ArtifactStore& store, const TaskRefusal& refused) {
  for (const TaskRefusal::File& file : refused.evidence()) {
    try {
      const StoredArtifact stored = store.publish(file.bytes);
      wire::Artifact& artifact = *failed.add_evidence();
      artifact.set_name(file.name);
      artifact.set_hash(stored.hash);
      artifact.set_size(stored.size);
    } catch (const IoError& error) {
      failed.set_message(failed.message() + "; " + file.name +
                         " could not be kept: " + error.what());
    }
  }
}

/// The failure that the exception being handled stands for.
wire::Failed caught_failure(const ArtifactStore* store) {
  try {
    throw;
  } catch (const TaskRefusal& refused) {
    wire::Failed failed = failure(refused, FailureCause::for_good);
    if (store != nullptr) add_evidence(failed, *store, refused);
    return failed;
  } catch (const DamagedInput& error) {
    wire::Failed failed = failure(error, FailureCause::damaged_input);
    failed.add_damaged_inputs(error.hash());
    return failed;
  } catch (const IoError& error) {
    const bool starved = error.error_number() == ENOMEM;
    return failure(error, starved ? FailureCause::out_of_memory : cause_of(error.code()));
  } catch (const InvalidInput& error) {
    return failure(error, FailureCause::for_good);
  } catch (const UsageError& error) {
    return failure(error, FailureCause::for_good);
  } catch (const JobTooLarge& error) {
    // What is short is room for this job, not for all of them.
    return failure(error, FailureCause::for_good);
  } catch (const Error& error) {
    return failure(error, cause_of(error.code()));
  } catch (const std::bad_alloc&) {
    return failure(Error(ExitCode::out_of_resources, "out of memory"), FailureCause::out_of_memory);
  } catch (const std::exception& error) {
    return failure(Error(ExitCode::failed, error.what()), FailureCause::error);
  }
}

/// Goes with the attempt, whether it succeeds or not.
class ScratchOfAttempt {
 public:
  ScratchOfAttempt(const ArtifactStore& store, const wire::Assign& assign)
      : store_(store), attempt_{assign.attempt()} {}
  ~ScratchOfAttempt() { remove_attempt_scratch(store_, attempt_); }
  ScratchOfAttempt(const ScratchOfAttempt&) = delete;
  ScratchOfAttempt& operator=(const ScratchOfAttempt&) = delete;

 private:
  const ArtifactStore& store_;
  AttemptId attempt_;
};

}  // namespace

wire::Envelope run_task(const ArtifactStore& store, const wire::Assign& assign,
                        const TaskBody& body, const TaskIo::Say& say,
                        bool is_without_shared_store) {
  wire::Envelope envelope;
  try {
    if (!body) {
      throw Error(ExitCode::failed,
                  "this worker cannot run tasks of kind " + std::to_string(assign.kind()));
    }
    const ScratchOfAttempt scratch(store, assign);
    TaskIo io(store, assign, say, is_without_shared_store);
    body(io);
    *envelope.mutable_done() = io.done();
  } catch (...) {
    *envelope.mutable_failed() = caught_failure(&store);
  }
  return envelope;
}

wire::Envelope run_task_in(const std::filesystem::path& store_folder, const wire::Assign& assign,
                           const TaskBody& body, const TaskIo::Say& say,
                           bool is_without_shared_store) {
  try {
    const ArtifactStore store = ArtifactStore::open_existing(store_folder);
    return run_task(store, assign, body, say, is_without_shared_store);
  } catch (...) {
    wire::Envelope envelope;
    *envelope.mutable_failed() = caught_failure(nullptr);
    return envelope;
  }
}

}  // namespace tetfarm
