#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/run_folder.h"
#include "coordinator/kept_files.h"
#include "coordinator/start_rules.h"
#include "json/json_line.h"
#include "store/folder_lock.h"
#include "store/garbage.h"
#include "store/job_database.h"
#include "store/store_check.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* database_file = "tetfarm.db";

JobDatabase database_of(const std::filesystem::path& store, const std::string& database) {
  return JobDatabase::open_to_read(database_folder(store, database) / database_file);
}

/// Job after job: all rows at once may be gigabytes.
std::set<std::string> needed_of_all_jobs(const JobDatabase& database, const DurableState& rows,
                                         bool all_finished) {
  std::set<std::string> needed;
  for (const auto& [id, job] : rows.jobs) {
    needed.merge(needed_files(database.load_job(id), all_finished));
  }
  return needed;
}

std::string task_text(const TaskRow& task) {
  const std::string kind = name_of(task.kind);
  return "task " + std::to_string(task.id.value) + " of " + job_name(task.job) + " (" + kind +
         of_task_place(kind, task.path) + ")";
}

Json json_of(const StoreReport& report, const DurableState& rows) {
  Json json = {{"type", "store_check"},    {"files", report.files},
               {"removed", report.gone},   {"sound", report.damaged.empty()},
               {"damaged", Json::array()}, {"redo", Json::array()},
               {"hopeless", Json::array()}};
  for (const DamagedFile& file : report.damaged) {
    Json makers = Json::array();
    for (const TaskId maker : file.makers) makers.push_back(maker.value);
    json["damaged"].push_back({{"hash", file.file.hash},
                               {"name", file.file.name},
                               {"size", file.file.size},
                               {"state", name_of(file.state)},
                               {"needed", file.is_needed},
                               {"made_by", makers}});
  }
  for (const TaskId id : report.redone) {
    const TaskRow& task = rows.tasks.at(id);
    json["redo"].push_back({{"job", job_name(task.job)},
                            {"task", id.value},
                            {"kind", name_of(task.kind)},
                            {"path", task.path}});
  }
  for (const JobId id : report.hopeless) json["hopeless"].push_back(job_name(id));
  return json;
}

void print(const StoreReport& report, const DurableState& rows) {
  std::printf("files           %zu, %zu damaged", report.files, report.damaged.size());
  if (report.gone > 0) std::printf(", %zu removed as no task needs them any more", report.gone);
  std::printf("\n");
  for (const DamagedFile& damaged : report.damaged) {
    std::printf("%s  '%s': %s", damaged.file.hash.c_str(), damaged.file.name.c_str(),
                name_of(damaged.state));
    if (!damaged.is_needed) std::printf("; nothing needs it any more");
    std::printf("\n");
  }
  for (const TaskId id : report.redone) {
    std::printf("would run again  %s\n", task_text(rows.tasks.at(id)).c_str());
  }
  for (const JobId id : report.hopeless) {
    std::printf("%s has lost its own input: submit it again\n", job_name(id).c_str());
  }
}

}  // namespace

ExitCode check_store_command(const CheckOptions& options) {
  const ArtifactStore store = ArtifactStore::open_existing(require_store_of(options.store));
  const DurableState rows = database_of(store.folder(), options.database).load();
  const StoreReport report = check_store(rows, look_into(store, true),
                                         [](const JobRow& job) { return keeps_all_files(job); });
  if (options.json) {
    std::printf("%s\n", json_line(json_of(report, rows)).c_str());
  } else {
    print(report, rows);
  }
  if (report.damaged.empty()) return ExitCode::ok;
  const std::size_t damaged = report.damaged.size();
  throw Error(ExitCode::failed, store.folder().string() + ": " + counted(damaged, "file") +
                                    (damaged == 1 ? " is" : " are") + " damaged or missing; " +
                                    counted(report.redone.size(), "task") +
                                    " would run again when needed");
}

ExitCode gc_command(const GcCommand& command) {
  const ArtifactStore store = ArtifactStore::open_existing(require_store_of(command.store));
  const FolderLock lock = FolderLock::of_store(store.folder());
  const JobDatabase database = database_of(store.folder(), command.database);
  const DurableState rows = database.load_unfinished();
  const Garbage garbage = find_garbage(
      store, needed_of_all_jobs(database, rows, command.all_finished), untouchable_since_ms(rows));
  if (!command.dry_run) remove_garbage(store, garbage);
  if (command.json) {
    const Json json = {{"type", "gc"},
                       {"dry_run", command.dry_run},
                       {"files", garbage.files.size()},
                       {"bytes", garbage.bytes},
                       {"perhaps_being_written", garbage.too_young}};
    std::printf("%s\n", json_line(json).c_str());
    return ExitCode::ok;
  }
  if (command.dry_run) {
    for (const auto& file : garbage.files) std::printf("%s\n", file.c_str());
  }
  std::printf("%s, %llu bytes %s\n", counted(garbage.files.size(), "file").c_str(),
              static_cast<unsigned long long>(garbage.bytes),
              command.dry_run ? "would be removed" : "removed");
  if (garbage.too_young > 0) {
    std::printf("%zu kept: running attempts may be writing them\n", garbage.too_young);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
