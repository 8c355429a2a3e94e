// What `tetfarm run` makes of an output folder that was used before.
#include <gmock/gmock.h>

#include "store/job_database.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

TEST(RunCommand, takes_the_place_of_a_job_of_its_folder_that_never_ended) {
  const test::TemporaryFolder folder;
  test::write_contents(folder.path() / "tet.off",
                       "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
                       "3 0 3 2\n");
  const std::filesystem::path store = folder.path() / "out" / ".tetfarm";
  std::filesystem::create_directories(store);
  {
    ChangeSet changes;
    changes.jobs = {{JobId{1}, "key", "earlier", "toml", JobPhase::running, 0, "", 5, 0}};
    JobDatabase(store / "tetfarm.db").apply(changes);
  }
  const test::Ended ended =
      test::run_program({"run", "tet.off", "-o", "out", "-j", "1"}, folder.path(), 60);
  EXPECT_EQ(ended.code, 0) << ended.err;
  const DurableState rows = JobDatabase::open_to_read(store / "tetfarm.db").load();
  ASSERT_EQ(rows.jobs.size(), 2U);
  EXPECT_EQ(rows.jobs.at(JobId{1}).phase, JobPhase::cancelled);
  EXPECT_EQ(rows.jobs.at(JobId{2}).phase, JobPhase::done);
}

}  // namespace
}  // namespace tetfarm
