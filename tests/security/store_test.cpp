// Whoever may touch the files of a farm, or only fill its disk: the farm notices, promises nothing
// that it cannot keep, and gives nobody more rights than it has to.
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Farm;
using test::Program;
using test::RawPeer;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int exit_usage = 2;
constexpr uid_t nobody = 65534;

int readyz_of(const Farm& farm) {
  const test::RawConnection connection(farm.http_port());
  connection.send("GET /readyz HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " +
                  test::contents(farm.folder() / "token") + "\r\n\r\n");
  const std::string answer = connection.hear();
  return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
}

/// Waits until that is what /readyz answers.
bool becomes(const Farm& farm, int status) {
  for (int waited = 0; waited < test::patience_ms; waited += 50) {
    if (readyz_of(farm) == status) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

/// It may be refused, or not be answered while nothing can be kept; it must not be accepted.
bool is_submitted(const Farm& farm, const std::string& key) {
  RawPeer anna(farm.endpoint(), farm.keys_of("anna"));
  anna.send(test::submission(farm, key));
  const auto answer = anna.hear(2000);
  return answer && answer->has_submitted();
}

std::unique_ptr<Program> start_worker(const Farm& farm) {
  return std::make_unique<Program>(
      std::vector<std::string>{"worker", "--connect", farm.endpoint(), "--store", "store", "--key",
                               "node.key", "--coordinator-key", "keys/coordinator.pub"},
      farm.folder());
}

std::string submit(const Farm& farm) {
  RawPeer anna(farm.endpoint(), farm.keys_of("anna"));
  return anna.ask(test::submission(farm, "the job")).submitted().job();
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

mode_t mode_of(const fs::path& path) {
  struct stat about {};
  EXPECT_EQ(::stat(path.c_str(), &about), 0) << path;
  return about.st_mode & 0777U;
}

/// Starts a coordinator once more beside the farm's files; its end.
Ended started_again(const Farm& farm, const std::vector<std::string>& words) {
  std::vector<std::string> all = {"coordinator", "--listen", "tcp://127.0.0.1:*"};
  all.insert(all.end(), words.begin(), words.end());
  return test::run_program(all, farm.folder(), 20);
}

TEST(Database, that_is_removed_is_missed_before_anything_is_promised) {
  Farm farm;
  EXPECT_TRUE(is_submitted(farm, "before"));
  EXPECT_EQ(readyz_of(farm), 200);
  fs::remove(farm.folder() / "state/tetfarm.db");
  EXPECT_FALSE(is_submitted(farm, "after"));
  EXPECT_TRUE(becomes(farm, 503));
  EXPECT_EQ(farm.ask({"status"}, "vera").code, 0) << "whoever looks is still answered";
}

TEST(Database, that_is_replaced_by_another_is_not_written_to) {
  Farm farm;
  EXPECT_TRUE(is_submitted(farm, "before"));
  const fs::path database = farm.folder() / "state/tetfarm.db";
  fs::rename(database, farm.folder() / "state/aside.db");
  test::write_contents(database, "planted");
  EXPECT_FALSE(is_submitted(farm, "after"));
  EXPECT_TRUE(becomes(farm, 503));
  EXPECT_EQ(test::contents(database), "planted");
  fs::rename(farm.folder() / "state/aside.db", database);
  EXPECT_TRUE(becomes(farm, 200)) << "it is back";
  EXPECT_TRUE(is_submitted(farm, "after"));
}

TEST(Database, that_can_only_be_read_is_told_at_the_start) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "state");
  const std::vector<std::string> words = {
      "coordinator", "--store", "store", "--database", "state", "--listen", "tcp://127.0.0.1:*"};
  {
    Program first(words, folder.path());
    for (int i = 0; i < 2000 && first.out_so_far().empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    first.signal(SIGTERM);
    EXPECT_EQ(first.wait().code, 0);
  }
  for (const char* name : {"state/tetfarm.db", "state"}) {
    ASSERT_EQ(::chmod((folder.path() / name).c_str(), 0555), 0);
  }
  // Permissions do not bind root: for it the folder is mounted so that nobody may write.
  std::vector<std::string> launcher;
  if (::geteuid() == 0) {
    launcher = {"/usr/bin/unshare",
                "-m",
                "/bin/sh",
                "-c",
                "mount --bind state state && mount -o remount,ro,bind state && exec \"$0\" \"$@\"",
                test::built_program().string()};
  }
  Program second(words, folder.path(), launcher);
  const Ended ended = second.wait(20);
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, Not(HasSubstr("listening")));
  EXPECT_THAT(ended.err, HasSubstr("tetfarm.db"));
}

TEST(Database, on_a_disk_that_was_filled_takes_nothing_until_there_is_room) {
  Farm farm;
  EXPECT_TRUE(is_submitted(farm, "before"));
  const rlimit full{1, RLIM_INFINITY};
  ASSERT_EQ(::prlimit(farm.coordinator().process(), RLIMIT_FSIZE, &full, nullptr), 0);
  EXPECT_FALSE(is_submitted(farm, "meanwhile"));
  EXPECT_EQ(farm.ask({"status"}, "vera").code, 0);
  const rlimit room{RLIM_INFINITY, RLIM_INFINITY};
  ASSERT_EQ(::prlimit(farm.coordinator().process(), RLIMIT_FSIZE, &room, nullptr), 0);
  EXPECT_TRUE(becomes(farm, 200));
  EXPECT_TRUE(is_submitted(farm, "after"));
  EXPECT_TRUE(farm.coordinator().is_running());
}

TEST(Database, of_another_store_is_refused) {
  Farm farm;
  const Ended ended = started_again(farm, {"--store", "other", "--database", "state"});
  EXPECT_EQ(ended.code, exit_usage);
  EXPECT_THAT(ended.err, HasSubstr("another store"));
}

TEST(Store, has_one_coordinator) {
  Farm farm;
  const Ended ended = started_again(farm, {"--store", "store", "--database", "state"});
  EXPECT_NE(ended.code, 0);
  EXPECT_NE(ended.code, -1) << "it ran on";
  EXPECT_EQ(farm.ask({"status"}, "vera").code, 0);
}

TEST(Store, with_an_input_replaced_by_other_bytes_makes_no_mesh_of_them) {
  Farm farm;
  const std::string job = submit(farm);
  bool is_planted = false;
  for (const fs::path& file : files_below(farm.store() / "artifacts")) {
    std::string bytes = test::contents(file);
    if (!bytes.starts_with("OFF")) continue;
    bytes[bytes.find("0 0 -1")] = '9';
    fs::remove(file);
    test::write_contents(file, bytes);
    is_planted = true;
  }
  ASSERT_TRUE(is_planted);
  const auto worker = start_worker(farm);
  const Ended waited = farm.ask({"wait", job, "--progress", "none"}, "anna");
  EXPECT_NE(waited.code, 0);
  EXPECT_TRUE(farm.coordinator().is_running());
}

TEST(Store, with_links_in_the_way_of_a_result_changes_nothing_behind_them) {
  Farm farm;
  const std::string job = submit(farm);
  const auto worker = start_worker(farm);
  test::write_contents(farm.folder() / "victim", "untouched");
  fs::create_directory(farm.folder() / "out");
  for (const char* name : {"honest.vtkhdf", "honest.json", "job.toml", "honest.toml"}) {
    fs::create_symlink("../victim", farm.folder() / "out" / name);
  }
  const Ended waited =
      farm.ask({"wait", job, "-o", "out", "--store", "store", "--progress", "none"}, "anna");
  EXPECT_EQ(waited.code, 0) << waited.err;
  EXPECT_EQ(test::contents(farm.folder() / "victim"), "untouched");
}

TEST(Store, gives_others_neither_artifacts_nor_the_database) {
  const mode_t before = ::umask(0);
  Farm farm;
  ::umask(before);
  EXPECT_TRUE(is_submitted(farm, "of which something is stored"));
  for (const fs::path& file : files_below(farm.folder() / "state")) {
    EXPECT_EQ(mode_of(file) & 0007U, 0U) << file;
  }
  const std::vector<fs::path> artifacts = files_below(farm.store() / "artifacts");
  EXPECT_GE(artifacts.size(), 2U);
  for (const fs::path& file : artifacts) EXPECT_EQ(mode_of(file) & 0007U, 0U) << file;
  EXPECT_EQ(mode_of(farm.keys_folder() / "coordinator.key"), 0600U);
}

TEST(Store, keeps_no_probe_of_a_worker_that_was_killed) {
  Farm farm({"--lease-ms", "300", "--heartbeat-ms", "100"});
  const auto worker = start_worker(farm);
  const auto probes = [&] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(farm.store() / "scratch")) {
      if (entry.path().filename().string().starts_with("probe-")) ++count;
    }
    return count;
  };
  // Before the coordinator has heard of the worker it knows of no probe either.
  for (int i = 0; i < 1000 && farm.status().workers() == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ASSERT_EQ(probes(), 1);
  worker->signal(SIGKILL);
  for (int i = 0; i < 1000 && probes() > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(probes(), 0);
}

/// A key file, and what a coordinator that is to use it says.
class KeyFileRights : public ::testing::Test {
 protected:
  KeyFileRights() {
    write_new_key(folder_.path() / "keys", "coordinator");
    authorize(list(), {make_key_pair().public_key, Role::viewer, "vera"});
  }
  fs::path key() const { return folder_.path() / "keys/coordinator.key"; }
  fs::path list() const { return authorized_keys_path(folder_.path() / "keys"); }
  Ended start() const {
    return test::run_program(
        {"coordinator", "--store", "store", "--keys", "keys", "--listen", "tcp://127.0.0.1:*"},
        folder_.path(), 20);
  }
  test::TemporaryFolder folder_;
};

TEST_F(KeyFileRights, that_let_others_read_the_key_are_refused) {
  for (const mode_t mode : {0644U, 0640U, 0604U, 0660U, 0777U}) {
    ASSERT_EQ(::chmod(key().c_str(), mode), 0);
    const Ended ended = start();
    EXPECT_EQ(ended.code, exit_usage) << std::oct << mode;
    EXPECT_THAT(ended.err, HasSubstr("coordinator.key"));
  }
}

TEST_F(KeyFileRights, that_let_others_write_the_list_are_refused) {
  for (const mode_t mode : {0666U, 0620U, 0602U}) {
    ASSERT_EQ(::chmod(list().c_str(), mode), 0);
    EXPECT_EQ(start().code, exit_usage) << std::oct << mode;
  }
}

TEST_F(KeyFileRights, of_another_user_are_refused) {
  // Only root can give a file away; for others a file of root's stands in.
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(key().c_str(), nobody, nobody), 0);
  } else {
    fs::remove(key());
    fs::create_symlink("/etc/passwd", key());
  }
  EXPECT_EQ(start().code, exit_usage);
}

TEST_F(KeyFileRights, do_not_make_a_key_of_what_is_none) {
  for (const std::string& text :
       {std::string(), std::string("tetfarm secret key "), std::string("tetfarm secret key 00\n"),
        "tetfarm public key " + std::string(64, 'a') + "\n", std::string(1'000'000, 'a')}) {
    test::write_contents(key(), text);
    EXPECT_EQ(start().code, exit_usage) << text.substr(0, 40);
  }
  fs::remove(key());
  fs::create_directory(key());
  EXPECT_NE(start().code, 0);
}

}  // namespace
}  // namespace tetfarm
