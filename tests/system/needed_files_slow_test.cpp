// A job that keeps only the files that its tasks still need: the store ends with little more than
// the result, and the mesh is that of a job that keeps all, whatever is killed on the way.
#include <gmock/gmock.h>

#include <csignal>
#include <thread>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;

class NeededFiles : public ::testing::Test {
 protected:
  void write_job(const std::string& name, const std::string& keep) const {
    test::write_contents(folder_.path() / name, "[geometry]\nsurface = \"" + input_ +
                                                    "\"\n[output]\nkeep = \"" + keep + "\"\n");
  }
  std::vector<std::string> words(const std::string& job, const std::string& output) const {
    return test::run_words(job, output, 2, 6);
  }
  std::string run(const std::string& job, const std::string& output) const {
    const Ended ended = run_program(words(job, output), folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return test::digest_of(ended);
  }
  std::uintmax_t bytes_in_store(const std::string& output) const {
    std::uintmax_t bytes = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(folder_.path() / output / ".tetfarm" / "artifacts")) {
      if (entry.is_regular_file()) bytes += entry.file_size();
    }
    return bytes;
  }

  TemporaryFolder folder_;
  std::string input_ = test::sphere_in_box(folder_.path(), 8, 2);
};

TEST_F(NeededFiles, alone_are_kept_and_the_mesh_is_that_of_a_job_that_keeps_all) {
  write_job("all.toml", "all");
  write_job("needed.toml", "needed");
  EXPECT_EQ(run("needed.toml", "needed"), run("all.toml", "all"));
  EXPECT_LT(bytes_in_store("needed"), bytes_in_store("all") * 7 / 10);
  EXPECT_EQ(run_program({"check", "--store", "needed"}, folder_.path()).code, 0);
}

TEST_F(NeededFiles, suffice_after_any_kill_of_the_coordinator_and_its_workers) {
  write_job("all.toml", "all");
  write_job("needed.toml", "needed");
  const std::string expected = run("all.toml", "all");
  for (int killed = 1; killed <= 12; ++killed) {
    Program program(words("needed.toml", "needed"), folder_.path());
    std::this_thread::sleep_for(std::chrono::milliseconds(100 * killed));
    program.signal(SIGKILL);
    program.wait();
  }
  EXPECT_EQ(run("needed.toml", "needed"), expected);
  EXPECT_LT(bytes_in_store("needed"), bytes_in_store("all") * 7 / 10);
}

}  // namespace
}  // namespace tetfarm
