// Workers that do not see the store: files come and go over the encrypted connection, and the mesh
// is the same.
#include <gmock/gmock.h>

#include <csignal>
#include <thread>

#include "store/artifact_store.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void pause_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

bool has_name_with(const fs::path& folder, const std::string& part) {
  for (const std::string& name : names_in(folder)) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

class Transfer : public ::testing::Test {
 protected:
  Transfer() {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"keys", "new", "coordinator", "--keys", "state/keys"},
          {"keys", "new", "node"},
          {"keys", "new", "anna"},
          {"keys", "authorize", "node.pub", "--role", "worker", "--keys", "state/keys"},
          {"keys", "authorize", "anna.pub", "--role", "submitter", "--keys", "state/keys"}}) {
      EXPECT_EQ(run_program(words, folder_.path()).code, 0);
    }
    coordinator_ = start_coordinator("tcp://127.0.0.1:*");
    endpoint_ = test::endpoint_of(*coordinator_);
    input_ = test::sphere_in_box(folder_.path(), 8, 2);
  }

  std::unique_ptr<Program> start_coordinator(const std::string& endpoint) const {
    return std::make_unique<Program>(
        std::vector<std::string>{"coordinator", "--store", "store", "--database", "state", "--keys",
                                 "state/keys", "--listen", endpoint, "--heartbeat-ms", "100",
                                 "--lease-ms", "1500"},
        folder_.path());
  }
  std::vector<std::string> with_key(std::vector<std::string> words, const std::string& name) const {
    words.insert(words.end(), {"--connect", endpoint_, "--key", name + ".key", "--coordinator-key",
                               "state/keys/coordinator.pub"});
    return words;
  }
  std::unique_ptr<Program> start_worker(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"worker"};
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<Program>(with_key(words, "node"), folder_.path());
  }
  std::unique_ptr<Program> start_far_worker(const std::string& cache) const {
    return start_worker({"--cache", cache, "--cache-size", "50MB"});
  }
  std::string submit() const {
    const Ended ended =
        run_program(with_key({"submit", input_, "--subdomains", "4", "--store", "store"}, "anna"),
                    folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find('\n'));
  }
  Ended wait_for(const std::string& job) const {
    return run_program(
        with_key({"wait", job, "-o", "out", "--store", "store", "--json", "--progress", "none"},
                 "anna"),
        folder_.path());
  }
  void expect_the_local_mesh(const Ended& ended) const {
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Ended local = run_program(test::run_words(input_, "local", 2), folder_.path());
    EXPECT_EQ(test::digest_of(local).size(), 32U);
    EXPECT_EQ(test::digest_of(ended), test::digest_of(local));
  }
  /// Pauses until a file with that part in its name is in the folder; false when it never is.
  bool wait_for_name(const fs::path& folder, const std::string& part) const {
    for (int i = 0; i < 20'000; ++i) {
      if (has_name_with(folder_.path() / folder, part)) return true;
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return false;
  }

  TemporaryFolder folder_;
  std::string endpoint_;
  std::unique_ptr<Program> coordinator_;
  std::string input_;
};

TEST_F(Transfer, two_workers_without_the_store_make_the_mesh_and_leave_nothing_half_done) {
  const auto one = start_far_worker("one");
  const auto two = start_worker({"--store", "store", "--no-shared-store", "--cache", "two"});
  expect_the_local_mesh(wait_for(submit()));
  EXPECT_FALSE(names_in(folder_.path() / "one/0/artifacts").empty());
  EXPECT_FALSE(names_in(folder_.path() / "two/0/artifacts").empty());
  EXPECT_THAT(names_in(folder_.path() / "store/scratch"), IsEmpty());
  for (const auto& worker : {one.get(), two.get()}) {
    worker->signal(SIGTERM);
    EXPECT_EQ(worker->wait().code, 0);
  }
}

TEST_F(Transfer, one_worker_that_sees_the_store_and_one_that_does_not) {
  const auto near = start_worker({"--store", "store", "--cache", "unused"});
  const auto far = start_far_worker("far");
  expect_the_local_mesh(wait_for(submit()));
  EXPECT_FALSE(fs::exists(folder_.path() / "unused"));
  EXPECT_FALSE(names_in(folder_.path() / "far/0/artifacts").empty());
}

TEST_F(Transfer, a_copy_of_the_store_is_not_taken_for_the_store) {
  fs::copy(folder_.path() / "store", folder_.path() / "copy", fs::copy_options::recursive);
  const auto worker = start_worker({"--store", "copy", "--cache", "far"});
  expect_the_local_mesh(wait_for(submit()));
  EXPECT_FALSE(names_in(folder_.path() / "far/0/artifacts").empty());
}

TEST_F(Transfer, a_worker_killed_while_it_sends_leaves_nothing_and_another_does_its_task) {
  auto one = start_far_worker("one");
  const std::string job = submit();
  int kills = 0;
  for (; kills < 3 && wait_for_name("store/scratch", "upload-"); ++kills) {
    one->signal(SIGKILL);
    one->wait();
    one = start_far_worker("one");
  }
  EXPECT_GT(kills, 0);
  const auto two = start_far_worker("two");
  expect_the_local_mesh(wait_for(job));
  EXPECT_THAT(names_in(folder_.path() / "store/scratch"), IsEmpty());
}

TEST_F(Transfer, goes_on_where_it_was_when_the_coordinator_is_killed) {
  const auto one = start_far_worker("one");
  const auto two = start_far_worker("two");
  const std::string job = submit();
  int kills = 0;
  for (; kills < 3 && wait_for_name("store/scratch", "upload-"); ++kills) {
    coordinator_->signal(SIGKILL);
    coordinator_->wait();
    coordinator_ = start_coordinator(endpoint_);
    pause_ms(300);
  }
  EXPECT_GT(kills, 0);
  expect_the_local_mesh(wait_for(job));
  EXPECT_THAT(names_in(folder_.path() / "store/scratch"), IsEmpty());
  EXPECT_TRUE(one->is_running());
  EXPECT_TRUE(two->is_running());
}

TEST_F(Transfer, a_cache_too_small_for_anything_still_serves) {
  const auto worker = start_worker({"--cache", "tiny", "--cache-size", "1000"});
  expect_the_local_mesh(wait_for(submit()));
  worker->signal(SIGTERM);
  EXPECT_EQ(worker->wait().code, 0);
  std::uintmax_t kept = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "tiny/0/artifacts")) {
    if (entry.is_regular_file()) kept += entry.file_size();
  }
  EXPECT_LE(kept, 1000U);
}

TEST_F(Transfer, a_file_damaged_in_a_cache_is_fetched_again) {
  const auto worker = start_far_worker("far");
  const std::string job = submit();
  ASSERT_TRUE(wait_for_name("far/0", "artifacts"));
  int damaged = 0;
  for (int round = 0; round < 40 && damaged < 3; ++round) {
    pause_ms(20);
    std::error_code error;
    for (const auto& entry :
         fs::recursive_directory_iterator(folder_.path() / "far/0/artifacts", error)) {
      if (!entry.is_regular_file(error) || entry.file_size(error) < 100) continue;
      std::string bytes = test::contents(entry.path());
      bytes[50] = static_cast<char>(bytes[50] ^ 1);
      test::write_contents(entry.path(), bytes);
      ++damaged;
      break;
    }
  }
  EXPECT_GT(damaged, 0);
  expect_the_local_mesh(wait_for(job));
}

}  // namespace
}  // namespace tetfarm
