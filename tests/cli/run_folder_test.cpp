#include "cli/run_folder.h"

#include <gtest/gtest.h>

#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"

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

}  // namespace
}  // namespace tetfarm
