// Whatever dies and whenever: the same command ends in the same mesh.
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

void pause_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

class Failures : public ::testing::Test {
 protected:
  Failures() : input_(test::sphere_in_box(folder_.path(), 10, 2)) {}

  /// A run of the fixture's surface; groups 0: not assimilated.
  std::vector<std::string> words(const std::string& output, int workers) const {
    std::vector<std::string> all = test::run_words(input_, output, workers, subdomains_);
    if (groups_ > 0) all.insert(all.end(), {"--groups", std::to_string(groups_)});
    return all;
  }

  /// The digest of an undisturbed run.
  std::string reference() {
    const Ended ended = run_program(words("reference", 2), folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return test::digest_of(ended);
  }

  void kill_at_random(int wanted_kills) {
    const unsigned seed = std::random_device()();
    std::printf("seed %u\n", seed);
    std::mt19937 random(seed);
    const std::string digest = reference();
    int kills = 0;
    for (int round = 0; kills < wanted_kills; ++round) {
      const std::string output = "out" + std::to_string(round);
      int code = -1;
      while (code != 0) {
        Program run(words(output, 1 + static_cast<int>(random() % 4)), folder_.path());
        for (int i = 0; i < 8 && kills < wanted_kills; ++i) {
          pause_ms(20 + static_cast<int>(random() % 300));
          if (!run.is_running()) break;
          std::vector<pid_t> victims = test::descendants(run.process());
          victims.push_back(run.process());
          ::kill(victims[random() % victims.size()], SIGKILL);
          ++kills;
        }
        const Ended ended = run.wait();
        code = ended.code;
        ASSERT_TRUE(code == 0 || code == 128 + SIGKILL) << code << "\n" << ended.err;
        if (code == 0) {
          ASSERT_EQ(test::digest_of(ended), digest) << "seed " << seed;
        }
      }
    }
  }

  int subdomains_ = 4;
  int groups_ = 0;
  TemporaryFolder folder_;
  std::string input_;
};

TEST_F(Failures, the_mesh_is_the_same_for_every_number_of_workers) {
  const std::string digest = reference();
  EXPECT_EQ(digest.size(), 32U);
  for (const int workers : {1, 4}) {
    const std::string output = "out" + std::to_string(workers);
    const Ended ended = run_program(test::run_words(input_, output, workers), folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(test::digest_of(ended), digest) << workers << " workers";
  }
}

TEST_F(Failures, a_real_surface_gives_the_same_mesh_too) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const std::string surface = std::string(data) + "/cube_sphere/cube_sphere.stl";
  const Ended one = run_program(test::run_words(surface, "one", 1), folder_.path());
  EXPECT_EQ(one.code, 0) << one.err;
  const Ended three = run_program(test::run_words(surface, "three", 3), folder_.path());
  EXPECT_EQ(test::digest_of(one), test::digest_of(three));
  EXPECT_EQ(test::digest_of(one).size(), 32U);
}

TEST_F(Failures, the_files_do_not_depend_on_where_the_surface_lies) {
  const std::string digest = reference();
  std::filesystem::create_directory(folder_.path() / "elsewhere");
  std::filesystem::rename(folder_.path() / input_, folder_.path() / "elsewhere" / input_);
  const Ended ended = run_program(test::run_words("elsewhere/" + input_, "out", 2), folder_.path());
  EXPECT_EQ(test::digest_of(ended), digest);
}

TEST_F(Failures, twenty_random_kills_of_any_process_change_nothing) { kill_at_random(24); }

TEST_F(Failures, random_kills_change_nothing_of_an_assimilated_mesh) {
  subdomains_ = 12;
  groups_ = 3;
  kill_at_random(16);
}

TEST_F(Failures, stopped_half_way_it_goes_on_with_other_workers) {
  test::sphere_in_box(folder_.path(), 24, 4);  // in place of the small one: it has to last
  const std::string digest = reference();
  int stops = 0;
  for (int after_ms = 120;; after_ms += 50 + after_ms / 4) {
    Program run(test::run_words(input_, "out", 1 + stops % 3), folder_.path());
    pause_ms(after_ms);
    run.signal(stops % 2 == 0 ? SIGTERM : SIGINT);
    const Ended ended = run.wait();
    if (ended.code == 0) {
      EXPECT_EQ(test::digest_of(ended), digest);
      break;
    }
    // Before it listens to signals it just ends.
    if (ended.code == 128 + SIGTERM || ended.code == 128 + SIGINT) continue;
    ASSERT_EQ(ended.code, 75) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("stopped at a checkpoint"));
    ++stops;
  }
  EXPECT_GT(stops, 0);
}

TEST_F(Failures, nothing_is_left_running_when_the_run_is_killed) {
  Program run(test::run_words(input_, "out", 3), folder_.path());
  std::vector<pid_t> farm;
  while (farm.size() < 5 && run.is_running()) {
    pause_ms(5);
    farm = test::descendants(run.process());
  }
  ASSERT_GE(farm.size(), 5U) << "it has ended before";
  run.signal(SIGKILL);
  run.wait();
  for (const pid_t process : farm) {
    for (int i = 0; i < 500 && ::kill(process, 0) == 0; ++i) pause_ms(10);
    EXPECT_NE(::kill(process, 0), 0) << process;
  }
}

TEST_F(Failures, a_full_disk_ends_with_6_and_goes_on_when_there_is_room) {
  const std::filesystem::path disk = folder_.path() / "disk";
  std::filesystem::create_directory(disk);
  if (::unshare(CLONE_NEWNS) != 0 ||
      ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
      ::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1m") != 0) {
    GTEST_SKIP() << "a small disk cannot be mounted here: " << std::strerror(errno);
  }
  const std::string digest = reference();
  const Ended full = run_program(test::run_words(input_, "disk/out", 2), folder_.path());
  EXPECT_EQ(full.code, 6) << full.err;
  EXPECT_THAT(full.err, HasSubstr("error: "));
  ASSERT_EQ(::mount("tmpfs", disk.c_str(), "tmpfs", MS_REMOUNT, "size=512m"), 0);
  const Ended roomy = run_program(test::run_words(input_, "disk/out", 2), folder_.path());
  EXPECT_EQ(roomy.code, 0) << roomy.err;
  EXPECT_EQ(test::digest_of(roomy), digest);
  ::umount2(disk.c_str(), MNT_DETACH);
}

}  // namespace
}  // namespace tetfarm
