#include "worker/run_task.h"

#include <cerrno>
#include <new>

#include "base/error.h"
#include "store/attempt_scratch.h"
#include "worker/job_forecast.h"

namespace tetfarm {
namespace {

wire::Failed failure(const std::string& message, ExitCode code, bool may_retry) {
  wire::Failed failed;
  failed.set_message(message);
  failed.set_exit_code(static_cast<int>(code));
  failed.set_may_retry(may_retry);
  failed.set_out_of_resources(code == ExitCode::out_of_resources);
  return failed;
}

/// Not the disk, which all tasks share: this one needs more room than it had.
void call_out_of_memory(wire::Failed& failed) {
  failed.set_out_of_memory(true);
  failed.set_out_of_resources(false);
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
    wire::Failed failed = failure(refused.what(), refused.code(), false);
    if (store != nullptr) add_evidence(failed, *store, refused);
    return failed;
  } catch (const DamagedInput& error) {
    wire::Failed failed = failure(error.what(), error.code(), true);
    failed.add_damaged_inputs(error.hash());
    return failed;
  } catch (const IoError& error) {
    wire::Failed failed = failure(error.what(), error.code(), true);
    if (error.error_number() == ENOMEM) call_out_of_memory(failed);
    return failed;
  } catch (const InvalidInput& error) {
    return failure(error.what(), error.code(), false);
  } catch (const UsageError& error) {
    return failure(error.what(), error.code(), false);
  } catch (const JobTooLarge& error) {
    // What is short is room for this job, not for all of them.
    wire::Failed failed = failure(error.what(), error.code(), false);
    failed.set_out_of_resources(false);
    return failed;
  } catch (const Error& error) {
    return failure(error.what(), error.code(), true);
  } catch (const std::bad_alloc&) {
    wire::Failed failed = failure("out of memory", ExitCode::out_of_resources, true);
    call_out_of_memory(failed);
    return failed;
  } catch (const std::exception& error) {
    return failure(error.what(), ExitCode::failed, true);
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
                        const TaskBody& body, const TaskIo::Say& say) {
  wire::Envelope envelope;
  try {
    if (!body) {
      throw Error(ExitCode::failed, "this worker cannot run tasks of kind " +
                                        std::to_string(static_cast<int>(assign.kind())));
    }
    const ScratchOfAttempt scratch(store, assign);
    TaskIo io(store, assign, say);
    body(io);
    *envelope.mutable_done() = io.done();
  } catch (...) {
    *envelope.mutable_failed() = caught_failure(&store);
  }
  return envelope;
}

wire::Envelope run_task_in(const std::filesystem::path& store_folder, const wire::Assign& assign,
                           const TaskBody& body, const TaskIo::Say& say) {
  try {
    const ArtifactStore store = ArtifactStore::open_existing(store_folder);
    return run_task(store, assign, body, say);
  } catch (...) {
    wire::Envelope envelope;
    *envelope.mutable_failed() = caught_failure(nullptr);
    return envelope;
  }
}

}  // namespace tetfarm
