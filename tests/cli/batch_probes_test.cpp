#include "cli/batch_probes.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <optional>

#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;

/// Programs that stand in for those of Slurm, first on the PATH of this process.
class BatchProbes : public ::testing::Test {
 protected:
  BatchProbes() : path_(std::getenv("PATH")) {
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~BatchProbes() override { ::setenv("PATH", path_.c_str(), 1); }
  void put(const std::string& name, const std::string& script) const {
    write_contents(folder_.path() / name, "#!/bin/sh\n" + script + "\n");
    ::chmod((folder_.path() / name).c_str(), 0755);
  }
  Finding found(const std::string& wanted, std::int64_t timeout_ms = 5'000) const {
    const Findings findings = look_at_batch_systems(folder_.path(), wanted, timeout_ms);
    EXPECT_EQ(findings.size(), 1U);
    return findings.front();
  }

  TemporaryFolder folder_;
  std::string path_;
};

TEST_F(BatchProbes, find_nothing_wrong_where_no_batch_system_need_be) {
  EXPECT_EQ(found("").verdict, Verdict::ok);
  EXPECT_THAT(found("").found, HasSubstr("sbatch, condor_submit, bsub and qsub are not on"));
}

TEST_F(BatchProbes, miss_the_command_of_one_that_has_to_be_there) {
  const Finding missing = found("slurm");
  EXPECT_EQ(missing.verdict, Verdict::problem);
  EXPECT_EQ(missing.found, "slurm: sbatch is not on the PATH");
  write_contents(folder_.path() / "sbatch", "no program");
  EXPECT_EQ(found("slurm").found, missing.found) << "it cannot be run";
}

TEST_F(BatchProbes, ask_one_that_is_there) {
  put("sbatch", "");
  put("squeue", "echo \"$@\" > " + (folder_.path() / "asked").string());
  EXPECT_EQ(found("").verdict, Verdict::ok);
  EXPECT_THAT(found("").found, HasSubstr("slurm answers"));
  EXPECT_NE(test::contents(folder_.path() / "asked"), "");
}

TEST_F(BatchProbes, say_how_one_fails_to_answer) {
  put("sbatch", "");
  put("squeue", "echo 'Unable to contact slurm controller' >&2; exit 1");
  const Finding refused = found("");
  EXPECT_EQ(refused.verdict, Verdict::problem);
  EXPECT_EQ(refused.found, "slurm: squeue does not answer: Unable to contact slurm controller");
  put("squeue", "exec sleep 100");
  EXPECT_THAT(found("", 200).found, HasSubstr("did not answer in time"));
}

}  // namespace
}  // namespace tetfarm
