#include <cstdio>

#include "base/clock.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "json/job_json.h"
#include "store/artifact_store.h"
#include "store/database_backup.h"
#include "store/folder_lock.h"

namespace tetfarm {
namespace {

std::filesystem::path database_of(const BackupCommand& command) {
  ArtifactStore::open_existing(command.store);
  const std::filesystem::path folder = command.database.empty() ? command.store : command.database;
  return folder / "tetfarm.db";
}

}  // namespace

ExitCode backup_command(const BackupCommand& command) {
  back_up_database(database_of(command), command.file);
  if (command.json) std::printf("%s\n", copy_json("backup", command.file).c_str());
  return ExitCode::ok;
}

ExitCode restore_command(const RestoreCommand& command) {
  const std::filesystem::path database = database_of(command.from);
  const FolderLock lock = FolderLock::of_store(command.from.store);
  const std::filesystem::path kept = restore_database(command.from.file, database, wall_ms());
  if (command.from.json) std::printf("%s\n", copy_json("restored", kept.string()).c_str());
  if (!kept.empty()) std::fprintf(stderr, "the database that was there: %s\n", kept.c_str());
  return ExitCode::ok;
}

}  // namespace tetfarm
