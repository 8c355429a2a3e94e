// Disks that are full: the farm says so, waits, and goes on when there is room.
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <unistd.h>

#include <sched.h>
#include <cstring>
#include <thread>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class Space : public ::testing::Test {
 protected:
  Space() : input_(test::sphere_in_box(folder_.path(), 6, 2)) {}
  ~Space() override {
    coordinator_.reset();
    for (const fs::path& disk : disks_) ::umount2(disk.c_str(), MNT_DETACH);
  }

  /// A disk of a private mount namespace, with a file that leaves `free_bytes`.
  void make_disk(const std::string& name, std::size_t free_bytes) {
    const fs::path disk = folder_.path() / name;
    fs::create_directory(disk);
    if (disks_.empty()) {
      ASSERT_EQ(::unshare(CLONE_NEWNS), 0) << "this test wants root: " << std::strerror(errno);
      ASSERT_EQ(::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr), 0);
    }
    ASSERT_EQ(::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=40m"), 0)
        << "this test wants root: " << std::strerror(errno);
    disks_.push_back(disk);
    test::write_contents(disk / "filler", std::string((std::size_t{40} << 20U) - free_bytes, 'x'));
  }
  void start_coordinator(const std::string& store) {
    store_ = store;
    coordinator_ = std::make_unique<Program>(
        std::vector<std::string>{"coordinator", "--store", store, "--database", "database",
                                 "--listen", "tcp://127.0.0.1:*"},
        folder_.path());
    if (endpoint_.empty()) endpoint_ = test::endpoint_of(*coordinator_);
  }
  std::unique_ptr<Program> start_worker(const std::string& option, const std::string& folder) {
    return std::make_unique<Program>(
        std::vector<std::string>{"worker", "--connect", endpoint_, option, folder}, folder_.path());
  }
  Ended ask(std::vector<std::string> words) const {
    words.insert(words.end(), {"--connect", endpoint_});
    return run_program(words, folder_.path());
  }
  std::string submit() const {
    const Ended ended = ask({"submit", input_, "--subdomains", "4", "--store", store_});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find('\n'));
  }
  void expect_the_local_mesh(const std::string& job) const {
    const Ended ended =
        ask({"wait", job, "-o", "out", "--store", store_, "--json", "--progress", "none"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Ended local = run_program(test::run_words(input_, "local", 2), folder_.path());
    EXPECT_EQ(test::digest_of(ended), test::digest_of(local));
    EXPECT_EQ(test::digest_of(local).size(), 32U);
  }

  TemporaryFolder folder_;
  std::string input_;
  std::string store_;
  std::string endpoint_;
  std::unique_ptr<Program> coordinator_;
  std::vector<fs::path> disks_;
};

TEST_F(Space, of_the_store_is_watched_before_it_is_gone) {
  make_disk("disk", std::size_t{1} << 20U);
  if (HasFatalFailure()) return;
  start_coordinator("disk/store");
  const auto worker = start_worker("--store", "disk/store");
  const std::string job = submit();
  std::string said;
  for (int i = 0; i < 100 && said.find("MiB free") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    said = ask({"status", job, "--json"}).out;
  }
  EXPECT_THAT(said, HasSubstr("\"state\":\"stuck\""));
  EXPECT_THAT(said, HasSubstr("MiB free"));
  fs::remove(folder_.path() / "disk/filler");
  expect_the_local_mesh(job);
}

TEST_F(Space, that_a_job_cannot_have_is_said_before_it_is_meshed) {
  make_disk("disk", std::size_t{30} << 20U);
  if (HasFatalFailure()) return;
  start_coordinator("disk/store");
  const auto worker = start_worker("--store", "disk/store");
  const auto wait_for = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"submit", input_, "--store", store_};
    words.insert(words.end(), options.begin(), options.end());
    const Ended submitted = ask(words);
    EXPECT_EQ(submitted.code, 0) << submitted.err;
    return ask({"wait", submitted.out.substr(0, submitted.out.find('\n')), "--progress", "none"});
  };
  const Ended refused = wait_for({"--size", "0.06"});
  EXPECT_EQ(refused.code, 6);
  EXPECT_THAT(refused.err, HasSubstr("of disk, of which"));
  EXPECT_THAT(refused.err, HasSubstr("would give about"));
  EXPECT_EQ(wait_for({}).code, 0) << "others have room";
}

TEST_F(Space, of_one_worker_is_its_own_matter) {
  make_disk("disk", std::size_t{1} << 20U);
  if (HasFatalFailure()) return;
  start_coordinator("store");
  const auto full = start_worker("--cache", "disk/cache");
  const std::string job = submit();
  std::this_thread::sleep_for(std::chrono::seconds(2));
  EXPECT_THAT(ask({"status", job, "--json"}).out, HasSubstr("\"state\":\"running\""));
  const auto roomy = start_worker("--cache", "cache");
  expect_the_local_mesh(job);
  EXPECT_TRUE(full->is_running());
}

}  // namespace
}  // namespace tetfarm
