/// A job on this machine alone: a coordinator and workers for as long as it runs, in the store of
/// an output folder. Stopped by a signal it ends at a checkpoint, and the same command goes on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/command_line.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "store/folder_lock.h"

namespace tetfarm {

/// How a job ended, or what was under way when the run was told to stop.
struct LocalOutcome {
  std::optional<wire::JobStatus> end;
  std::string job;
  std::vector<std::uint64_t> under_way;
};

/// From now on SIGINT, SIGTERM and SIGHUP end the run at a checkpoint.
void listen_to_signals();
/// What comes after the job is done again by the same command: the signals end it.
void stop_listening();

/// One run at a time in a folder. @throws Error, with the process that has it.
FolderLock lock_of_run(const std::filesystem::path& store, const std::string& output);

/// Runs the job to its end; once more where its results turn out to be damaged. Says when there are
/// more workers than cores. @throws Error.
LocalOutcome run_locally(const RunOptions& options, const std::filesystem::path& store,
                         wire::Submit submit);

/// What is kept and what is lost, and how to go on.
ExitCode report_stop(const RunOptions& options, const std::filesystem::path& store,
                     const LocalOutcome& outcome);

}  // namespace tetfarm
