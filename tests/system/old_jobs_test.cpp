// Jobs that ended long ago go, with their files, whatever becomes of the coordinator.
#include <filesystem>

#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using test::Ended;
using ::testing::HasSubstr;

class OldJobs : public test::Daemon {
 protected:
  std::size_t files() const {
    std::size_t count = 0;
    const std::filesystem::path folder = folder_.path() / "store" / "artifacts";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) ++count;
    }
    return count;
  }
  void restart(const std::vector<std::string>& more) {
    coordinator_->signal(SIGKILL);
    coordinator_->wait();
    more_ = more;
    coordinator_ = start_coordinator(endpoint_);
  }
};

TEST_F(OldJobs, go_with_their_files_and_leave_the_rest) {
  auto worker = start_worker();
  const std::string old = submit(test::sphere_in_box(folder_.path(), 4, 1), 2);
  EXPECT_EQ(wait_for(old).code, 0);
  worker.reset();
  ASSERT_GT(files(), 0U);
  const std::string waits = submit(test::sphere_in_box(folder_.path(), 5, 1), 2);
  // A ten-thousandth of a day.
  pause_ms(9'000);
  restart({"--keep-days", "0.0001"});
  for (int i = 0; i < 600 && ask({"status", old}).code != 5; ++i) pause_ms(50);
  EXPECT_EQ(ask({"status", old}).code, 5);
  EXPECT_THAT(ask({"events", "--all"}).out, HasSubstr("removed"));
  for (int i = 0; i < 200 && files() > 2; ++i) pause_ms(50);
  EXPECT_EQ(files(), 2U) << "surface and job file of the other";
  EXPECT_EQ(ask({"status", waits}).code, 0);
  restart({});
  worker = start_worker();
  EXPECT_EQ(wait_for(waits).code, 0);
  const std::string again = submit(test::sphere_in_box(folder_.path(), 4, 1), 2);
  EXPECT_NE(again, old);
  EXPECT_EQ(wait_for(again).code, 0);
  EXPECT_EQ(test::run_program({"check", "--store", "store"}, folder_.path()).code, 0);
}

}  // namespace
}  // namespace tetfarm
