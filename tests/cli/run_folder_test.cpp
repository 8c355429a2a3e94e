#include "cli/run_folder.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

JobRow job_of(std::uint64_t id, const std::string& name, JobPhase phase) {
  JobRow job;
  job.id = JobId{id};
  job.key = name + std::to_string(id);
  job.name = name;
  job.phase = phase;
  return job;
}

/// A store with jobs of two names, some of which came to nothing.
class RunFolder : public ::testing::Test {
 protected:
  RunFolder() {
    ChangeSet changes;
    changes.jobs = {job_of(1, "wing", JobPhase::done), job_of(2, "wing", JobPhase::done),
                    job_of(3, "duct", JobPhase::done), job_of(4, "wing", JobPhase::failed),
                    job_of(5, "duct", JobPhase::cancelled)};
    JobDatabase(folder_.path() / "tetfarm.db").apply(changes);
  }
  std::string last(const std::string& name = "") const {
    ViewOptions options;
    options.store = folder_.path().string();
    options.is_quiet = true;
    FarmView view(options);
    return last_done_job(view, name);
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path()};
};

TEST_F(RunFolder, knows_the_last_job_that_is_done_and_the_last_of_a_name) {
  EXPECT_EQ(last(), "job-3");
  EXPECT_EQ(last("wing"), "job-2");
  EXPECT_EQ(last("duct"), "job-3");
  EXPECT_EQ(last("wheel"), "");
}

TEST_F(RunFolder, is_a_store_or_the_folder_that_holds_one) {
  EXPECT_EQ(store_of(folder_.path()), folder_.path());
  const std::filesystem::path out = folder_.path() / "out";
  EXPECT_EQ(store_of(out), std::nullopt);
  const ArtifactStore within(out / ".tetfarm");
  EXPECT_EQ(store_of(out), out / ".tetfarm");
}

TEST_F(RunFolder, is_to_be_one_where_the_user_says_so) {
  const auto trouble = [](const std::filesystem::path& folder) -> std::string {
    try {
      return require_store_of(folder).string();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::not_found);
      return error.what();
    }
  };
  EXPECT_EQ(trouble(folder_.path()), folder_.path().string());
  const std::filesystem::path nowhere = folder_.path() / "nowhere";
  EXPECT_EQ(trouble(nowhere), nowhere.string() + ": no such folder");
  std::filesystem::create_directory(nowhere);
  EXPECT_EQ(trouble(nowhere), nowhere.string() + ": not a store or the output folder of a run");
}

/// The folder of a run that made "wing", with the spacing that its tasks read.
class RunWithSpacing : public ::testing::Test {
 protected:
  RunWithSpacing() {
    ChangeSet changes;
    changes.jobs = {job_of(1, "wing", JobPhase::done), job_of(2, "duct", JobPhase::done)};
    TaskRow task;
    task.id = TaskId{1};
    task.job = JobId{1};
    task.kind = TaskKind::mesh;
    task.path = 1;
    task.state = TaskState::done;
    task.attempt = AttemptId{1};
    task.inputs = {{"subdomain", spacing_.hash, spacing_.size},
                   {"spacing", spacing_.hash, spacing_.size}};
    changes.tasks = {task};
    SubdomainRow root;
    root.job = JobId{1};
    root.hash = std::string(32, 'a');
    root.state = SubdomainState::leaf;
    changes.subdomains = {root};
    JobDatabase(store_.folder() / "tetfarm.db").apply(changes);
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path() / ".tetfarm"};
  const SpacingField field_ = make_spacing_field(
      shapes::unit_cube(),
      {.background = 0.25, .inherit_surface = false, .sources = {}, .triangles = {}});
  StoredArtifact spacing_ = store_.publish(field_.to_bytes());
};

TEST_F(RunWithSpacing, knows_it_by_the_name_of_a_mesh) {
  for (const char* mesh : {"wing.vtkhdf", "wing.lb8.ugrid"}) {
    const auto spacing = spacing_beside(folder_.path() / mesh);
    ASSERT_TRUE(spacing) << mesh;
    EXPECT_EQ(spacing->at({0.5, 0.5, 0.5}), field_.at({0.5, 0.5, 0.5}));
  }
  EXPECT_FALSE(spacing_beside(folder_.path() / "wheel.vtkhdf")) << "no job of that name";
  EXPECT_FALSE(spacing_beside(folder_.path() / "duct.vtkhdf")) << "a job without such a task";
  const TempFolder elsewhere;
  EXPECT_FALSE(spacing_beside(elsewhere.path() / "wing.vtkhdf"));
}

TEST_F(RunWithSpacing, knows_none_when_its_file_or_its_database_is_gone) {
  std::filesystem::remove(store_.path_of(spacing_.hash));
  EXPECT_FALSE(spacing_beside(folder_.path() / "wing.vtkhdf"));
  for (const char* file : {"tetfarm.db", "tetfarm.db-wal", "tetfarm.db-shm"}) {
    std::filesystem::remove(store_.folder() / file);
  }
  EXPECT_FALSE(spacing_beside(folder_.path() / "wing.vtkhdf"));
}

}  // namespace
}  // namespace tetfarm
