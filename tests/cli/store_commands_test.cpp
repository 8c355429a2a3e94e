// The commands over a store at rest, called as main calls them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "cli/commands.h"
#include "store/artifact_store.h"
#include "store/folder_lock.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The result of one job, and a file that no job needs.
class StoreCommands : public ::testing::Test {
 protected:
  StoreCommands() {
    ChangeSet changes;
    JobRow job;
    job.id = JobId{1};
    job.phase = JobPhase::done;
    TaskRow task;
    task.id = TaskId{1};
    task.job = job.id;
    task.kind = TaskKind::assemble;
    task.state = TaskState::done;
    task.attempt = AttemptId{1};
    task.outputs = {{"mesh", result_.hash, result_.size}};
    changes.jobs = {job};
    changes.tasks = {task};
    JobDatabase(folder_.path() / "tetfarm.db").apply(changes);
  }
  std::string gc(bool dry_run) const {
    GcCommand command;
    command.store = folder_.path();
    command.dry_run = dry_run;
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(gc_command(command), ExitCode::ok);
    return ::testing::internal::GetCapturedStdout();
  }
  ExitCode check() const {
    CheckOptions options;
    options.store = folder_.path();
    ::testing::internal::CaptureStdout();
    try {
      const ExitCode code = check_store_command(options);
      ::testing::internal::GetCapturedStdout();
      return code;
    } catch (const Error&) {
      ::testing::internal::GetCapturedStdout();
      throw;
    }
  }
  bool is_there(const StoredArtifact& file) const {
    return std::filesystem::exists(store_.path_of(file.hash));
  }

  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  StoredArtifact result_ = store_.publish("a mesh");
  StoredArtifact garbage_ = store_.publish("of nobody");
};

TEST_F(StoreCommands, nothing_is_removed_from_a_store_that_a_coordinator_has) {
  // Locks are of open files: one of this process keeps out the command as another's would.
  const FolderLock lock = FolderLock::of_store(folder_.path());
  GcCommand command;
  command.store = folder_.path();
  EXPECT_THROW(gc_command(command), UsageError);
  EXPECT_TRUE(is_there(garbage_));
}

TEST_F(StoreCommands, what_would_be_removed_is_told_and_stays) {
  const std::string said = gc(true);
  EXPECT_THAT(said, HasSubstr(garbage_.hash));
  EXPECT_THAT(said, HasSubstr("1 file, 9 bytes would be removed"));
  EXPECT_TRUE(is_there(garbage_));
  EXPECT_TRUE(is_there(result_));
}

TEST_F(StoreCommands, what_nobody_needs_is_removed_and_results_stay) {
  EXPECT_THAT(gc(false), HasSubstr("1 file, 9 bytes removed"));
  EXPECT_FALSE(is_there(garbage_));
  EXPECT_TRUE(is_there(result_));
}

TEST_F(StoreCommands, a_sound_store_ends_well_and_a_damaged_one_with_an_error) {
  EXPECT_EQ(check(), ExitCode::ok);
  std::filesystem::remove(store_.path_of(result_.hash));
  EXPECT_THAT([&] { check(); }, ThrowsMessage<Error>(HasSubstr("1 file is damaged or missing")));
}

TEST_F(StoreCommands, what_gc_did_is_told_to_programs) {
  GcCommand command;
  command.store = folder_.path();
  command.json = true;
  command.dry_run = true;
  EXPECT_EQ(said_by([&] { return gc_command(command); }).out,
            "{\"type\":\"gc\",\"dry_run\":true,\"files\":1,\"bytes\":9,"
            "\"perhaps_being_written\":0}\n");
  EXPECT_TRUE(is_there(garbage_));
  command.dry_run = false;
  EXPECT_EQ(said_by([&] { return gc_command(command); }).out,
            "{\"type\":\"gc\",\"dry_run\":false,\"files\":1,\"bytes\":9,"
            "\"perhaps_being_written\":0}\n");
  EXPECT_FALSE(is_there(garbage_));
  EXPECT_EQ(gc(false), "0 files, 0 bytes removed\n");
}

TEST_F(StoreCommands, a_check_tells_of_each_file_that_is_damaged_and_what_runs_again) {
  CheckOptions options;
  options.store = folder_.path();
  const auto checked = [&options] { return said_by([&] { return check_store_command(options); }); };
  EXPECT_EQ(checked().out, "files           1, 0 damaged\n");
  options.json = true;
  EXPECT_EQ(checked().out,
            "{\"type\":\"store_check\",\"files\":1,\"removed\":0,\"sound\":true,\"damaged\":[],"
            "\"redo\":[],"
            "\"hopeless\":[]}\n");
  std::filesystem::remove(store_.path_of(result_.hash));
  const nlohmann::json told = nlohmann::json::parse(checked().out);
  EXPECT_EQ(told["sound"], false);
  ASSERT_EQ(told["damaged"].size(), 1U);
  EXPECT_EQ(told["damaged"][0]["hash"], result_.hash);
  EXPECT_EQ(told["damaged"][0]["name"], "mesh");
  EXPECT_EQ(told["damaged"][0]["size"], 6);
  EXPECT_EQ(told["damaged"][0]["state"], "missing");
  EXPECT_EQ(told["damaged"][0]["made_by"], nlohmann::json({1}));
  options.json = false;
  const Said said = checked();
  EXPECT_EQ(said.code, ExitCode::failed);
  EXPECT_THAT(said.out, HasSubstr(result_.hash + "  'mesh': missing"));
  EXPECT_THAT(said.error,
              ::testing::StartsWith(folder_.path().string() + ": 1 file is damaged or missing; "));
}

}  // namespace
}  // namespace tetfarm
