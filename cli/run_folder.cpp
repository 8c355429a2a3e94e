#include "cli/run_folder.h"

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/list/known_formats.h"
#include "store/artifact_store.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// The files of any task that reads the spacing.
wire::Explanation task_with_spacing(FarmView& view, const std::string& job) {
  std::uint64_t task = 0;
  wire::Query query;
  query.set_subject(wire::Query::TASKS);
  query.set_job(job);
  view.ask(query, [&](const wire::QueryReply& page) {
    for (const wire::TaskLine& line : page.tasks()) {
      if (line.kind() == "mesh") task = line.task();
    }
  });
  wire::Explanation explanation;
  if (task == 0) return explanation;
  wire::Query explain;
  explain.set_subject(wire::Query::EXPLAIN);
  explain.set_task(task);
  view.ask(explain, [&](const wire::QueryReply& reply) { explanation = reply.explanation(); });
  return explanation;
}

/// file.lb8.ugrid, file.vtkhdf: "file".
std::string name_of_job(const fs::path& mesh) {
  std::string name = mesh.filename().string();
  for (const KnownFormat& format : known_formats()) {
    const std::string_view ending = format.written_ending();
    if (format.is_of_tasks && name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  return name;
}

}  // namespace

std::optional<fs::path> store_of(const fs::path& folder) {
  for (const fs::path& store : {folder / ".tetfarm", folder}) {
    if (size_of_file(store / "store_id")) return store;
  }
  return std::nullopt;
}

fs::path require_store_of(const fs::path& folder) {
  if (std::optional<fs::path> store = store_of(folder)) return *std::move(store);
  throw Error(ExitCode::not_found,
              folder.string() + (fs::exists(folder) ? ": not a store or the output folder of a run"
                                                    : ": no such folder"));
}

std::string last_done_job(FarmView& view, const std::string& name) {
  std::string last;
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  view.ask(query, [&](const wire::QueryReply& page) {
    for (const wire::JobStatus& job : page.jobs()) {
      if (job.state() == "done" && (name.empty() || job.name() == name)) last = job.job();
    }
  });
  return last;
}

std::optional<SpacingField> spacing_of_job(FarmView& view, const fs::path& store,
                                           const std::string& job) {
  const wire::Explanation explanation = task_with_spacing(view, job);
  for (const wire::InputLine& input : explanation.inputs()) {
    if (input.name() != "spacing" || !input.is_there()) continue;
    const ArtifactStore files = ArtifactStore::open_existing(store);
    return SpacingField::from_bytes(files.read(input.hash(), input.size()), "spacing");
  }
  return std::nullopt;
}

std::optional<SpacingField> spacing_beside(const fs::path& mesh) {
  const fs::path folder = fs::absolute(mesh).parent_path();
  if (!size_of_file(folder / ".tetfarm" / "store_id")) return std::nullopt;
  ViewOptions options;
  options.store = folder.string();
  options.is_quiet = true;
  try {
    FarmView view(options);
    const std::string job = last_done_job(view, name_of_job(mesh));
    if (job.empty()) return std::nullopt;
    return spacing_of_job(view, folder / ".tetfarm", job);
  } catch (const Error& error) {
    // The mesh stands for itself; its run may have lost its database.
    if (error.code() != ExitCode::not_found) throw;
    return std::nullopt;
  }
}

}  // namespace tetfarm
