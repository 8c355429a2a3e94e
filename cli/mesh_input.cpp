#include "cli/mesh_input.h"

#include <utility>

#include "base/error.h"
#include "base/ids.h"
#include "cli/commands.h"
#include "cli/coordinator_connection.h"
#include "cli/farm_view.h"
#include "cli/fetch_files.h"
#include "cli/run_folder.h"
#include "mesh/formats/list/known_formats.h"
#include "mesh/formats/registry/open_mesh.h"
#include "store/artifact_store.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// Of the job's results the one that is read best: .vtkhdf knows the sub-domains.
const wire::Artifact& mesh_among(const wire::JobStatus& status) {
  std::string known;
  for (const KnownFormat& format : known_formats()) {
    if (!format.is_of_tasks) continue;
    for (const wire::Artifact& file : status.files()) {
      if (file.name().ends_with(format.written_ending())) return file;
    }
    known += (known.empty() ? "" : " or ") + std::string(format.written_ending());
  }
  throw Error(ExitCode::not_found, status.job() + " has no mesh that can be read (" + known + ")");
}

void expect_done(const wire::JobStatus& status) {
  const std::string& state = status.state();
  if (state == "done") return;
  if (state == "failed" || state == "cancelled") {
    throw Error(ExitCode::not_found, status.job() + " has no mesh: it " +
                                         (state == "failed" ? "failed: " : "was cancelled") +
                                         (state == "failed" ? status.message() : ""));
  }
  throw Error(ExitCode::not_found, status.job() + " is not finished (" + state + ", stage " +
                                       status.stage() + "); wait for it: `tetfarm wait " +
                                       status.job() + "`");
}

wire::JobStatus status_of(const std::string& job, ViewOptions options) {
  options.client.job = job;
  options.is_quiet = true;
  FarmView view(options);
  const wire::StatusReply reply = view.status();
  if (reply.jobs_size() == 0) {
    const std::string& endpoint = options.client.endpoint;
    throw Error(ExitCode::not_found,
                "no job " + job + (endpoint.empty() ? " in " + options.store : " at " + endpoint));
  }
  return reply.jobs(0);
}

FetchOptions fetch_options(const ClientOptions& client) {
  return {.timeout_ms = static_cast<std::int64_t>(client.timeout_s * 1000),
          .progress = client.progress};
}

}  // namespace

JobFileHere bring_file_of_job(const wire::JobStatus& status, const wire::Artifact& file,
                              const ViewOptions& view, const fs::path& scratch_folder) {
  if (view.store.empty()) {
    CoordinatorConnection connection(view.client.endpoint, read_peer_keys(view.client.keys, ""));
    PassingFile fetched =
        fetch_for_a_while(connection, status, file, scratch_folder, fetch_options(view.client));
    const fs::path path = fetched.path();
    return {path, std::move(fetched)};
  }
  const ArtifactStore files = ArtifactStore::open_existing(require_store_of(view.store));
  files.verify(file.hash(), file.size());
  return {files.path_of(file.hash()), {}};
}

MeshInput mesh_of_job(const wire::JobStatus& status, const ViewOptions& view,
                      const fs::path& scratch_folder) {
  expect_done(status);
  const wire::Artifact& file = mesh_among(status);
  MeshInput input{.file = {},
                  .name = status.job() + "/" + fs::path(file.name()).filename().string(),
                  .job = status.job(),
                  .store = {}};
  JobFileHere here = bring_file_of_job(status, file, view, scratch_folder);
  input.file = std::move(here.file);
  input.fetched = std::move(here.fetched);
  if (!view.store.empty()) input.store = require_store_of(view.store);
  return input;
}

MeshInput find_mesh(const std::string& subject, const ViewOptions& view,
                    const fs::path& scratch_folder) {
  if (fs::exists(subject) || !parse_job_name(subject)) {
    if (!fs::exists(subject)) throw Error(ExitCode::not_found, subject + ": no such file");
    const fs::path file = mesh_file(subject);
    return {.file = file, .name = file.string(), .job = {}, .store = {}};
  }
  if (view.store.empty() && view.client.endpoint.empty()) {
    throw UsageError(
        "no such file; for the mesh of a job, say where the job is with --connect or --store",
        subject);
  }
  return mesh_of_job(status_of(subject, view), view, scratch_folder);
}

std::unique_ptr<MeshSource> open_mesh(const MeshInput& input, const fs::path& scratch_folder) {
  if (input.job.empty()) return open_mesh(input.file, scratch_folder);
  return open_mesh_as(input.file, input.name, scratch_folder);
}

std::optional<SpacingField> spacing_of(const MeshInput& input, const ViewOptions& view) {
  if (input.job.empty()) return spacing_beside(input.file);
  if (input.store.empty()) return std::nullopt;
  ViewOptions options = view;
  options.is_quiet = true;
  FarmView rows(options);
  return spacing_of_job(rows, input.store, input.job);
}

}  // namespace tetfarm
