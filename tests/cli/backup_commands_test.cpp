// Copies of a store's database, made and put back as main does it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "store/artifact_store.h"
#include "store/folder_lock.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::StartsWith;

class CopiedDatabase : public ::testing::Test {
 protected:
  void add_job(std::uint64_t id, const std::filesystem::path& folder) const {
    ChangeSet changes;
    JobRow job;
    job.id = JobId{id};
    job.key = std::to_string(id);
    changes.jobs = {job};
    JobDatabase(folder / "tetfarm.db").apply(changes);
  }
  std::size_t jobs_in(const std::filesystem::path& file) const {
    return JobDatabase::open_to_read(file).load().jobs.size();
  }
  BackupCommand command() const {
    BackupCommand command;
    command.store = store_.folder();
    command.file = folder_.path() / "farm.backup";
    return command;
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path() / "farm"};
};

TEST_F(CopiedDatabase, is_written_and_put_back) {
  add_job(1, store_.folder());
  const Said backup = said_by([&] { return backup_command(command()); });
  EXPECT_EQ(backup.out + backup.err + backup.error, "");
  EXPECT_EQ(jobs_in(command().file), 1U);
  add_job(2, store_.folder());
  const Said restored = said_by([&] { return restore_command({command()}); });
  EXPECT_EQ(restored.code, ExitCode::ok);
  EXPECT_EQ(restored.out, "");
  EXPECT_THAT(restored.err, StartsWith("the database that was there: "));
  EXPECT_EQ(jobs_in(store_.folder() / "tetfarm.db"), 1U);
}

TEST_F(CopiedDatabase, is_told_to_programs) {
  add_job(1, store_.folder());
  BackupCommand as_json = command();
  as_json.json = true;
  EXPECT_EQ(json::parse(said_by([&] { return backup_command(as_json); }).out),
            json({{"type", "backup"}, {"file", as_json.file}}));
  const json restored = json::parse(said_by([&] { return restore_command({as_json}); }).out);
  EXPECT_EQ(restored["type"], "restored");
  EXPECT_EQ(jobs_in(restored["file"].get<std::string>()), 1U) << "the one that was there";
}

TEST_F(CopiedDatabase, may_lie_apart_from_its_store) {
  const std::filesystem::path apart = folder_.path() / "apart";
  std::filesystem::create_directory(apart);
  add_job(1, apart);
  BackupCommand command_apart = command();
  command_apart.database = apart.string();
  EXPECT_EQ(said_by([&] { return backup_command(command_apart); }).error, "");
  EXPECT_EQ(jobs_in(command_apart.file), 1U);
}

TEST_F(CopiedDatabase, is_not_put_back_under_a_coordinator_nor_into_what_is_no_store) {
  add_job(1, store_.folder());
  said_by([&] { return backup_command(command()); });
  {
    const FolderLock lock = FolderLock::of_store(store_.folder());
    EXPECT_EQ(said_by([&] { return restore_command({command()}); }).code, ExitCode::usage);
  }
  BackupCommand elsewhere = command();
  elsewhere.store = folder_.path().string();
  EXPECT_EQ(said_by([&] { return restore_command({elsewhere}); }).code, ExitCode::not_found);
  EXPECT_EQ(said_by([&] { return backup_command(elsewhere); }).code, ExitCode::not_found);
}

}  // namespace
}  // namespace tetfarm
