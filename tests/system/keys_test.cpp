// A farm with keys over TCP: the same mesh as from one machine, and nobody else gets in.
#include <gmock/gmock.h>
#include <zlib.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

void pack(const std::filesystem::path& file) {
  const std::string bytes = test::contents(file);
  gzFile packed = ::gzopen((file.string() + ".gz").c_str(), "wb");
  ::gzwrite(packed, bytes.data(), static_cast<unsigned>(bytes.size()));
  ::gzclose(packed);
}

/// The standard one: programs that tests start have FOLDER/.config for $XDG_CONFIG_HOME.
const std::string keys_folder = ".config/tetfarm/keys";

class KeyedFarm : public ::testing::Test {
 protected:
  KeyedFarm() {
    run({"keys", "new", "coordinator"});
    for (const auto& [name, role] :
         {std::pair{"node-1", "worker"}, {"anna", "submitter"}, {"eve", "viewer"}}) {
      run({"keys", "new", name});
      run({"keys", "authorize", std::string(name) + ".pub", "--role", role});
    }
    run({"keys", "new", "stranger"});
    std::filesystem::create_directory(folder_.path() / "surfaces");
  }

  Ended run(const std::vector<std::string>& words) const {
    Ended ended = run_program(words, folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }
  static std::vector<std::string> coordinator_words() {
    return {"coordinator",  "--store",  "store",    "--database",       "state",
            "--allow-root", "surfaces", "--listen", "tcp://127.0.0.1:*"};
  }
  void start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = coordinator_words();
    words.insert(words.end(), more.begin(), more.end());
    coordinator_.emplace(words, folder_.path());
    if (endpoint_.empty()) endpoint_ = test::endpoint_of(*coordinator_);
  }
  /// With the key of `name`; without one when that is "".
  Ended ask(std::vector<std::string> words, const std::string& name) const {
    words.insert(words.end(), {"--connect", endpoint_, "--timeout", "5"});
    if (!name.empty()) {
      words.insert(words.end(),
                   {"--key", name + ".key", "--coordinator-key", keys_folder + "/coordinator.pub"});
    }
    return run_program(words, folder_.path());
  }
  std::vector<std::string> worker_words(const std::string& name) const {
    return {"worker", "--connect", endpoint_, "--store", "store", "--key", name + ".key"};
  }

  TemporaryFolder folder_;
  std::string endpoint_;
  std::optional<Program> coordinator_;
};

TEST_F(KeyedFarm, gives_the_mesh_that_a_local_run_gives) {
  start();
  const std::string input = test::sphere_in_box(folder_.path() / "surfaces", 4, 1);
  pack(folder_.path() / "surfaces" / input);
  const Program worker(worker_words("node-1"), folder_.path());
  const Ended submitted = ask(
      {"submit", "surfaces/" + input + ".gz", "--subdomains", "3", "--coordinator-reads"}, "anna");
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string job = submitted.out.substr(0, submitted.out.find('\n'));
  const Ended remote =
      ask({"wait", job, "-o", "out", "--store", "store", "--json", "--progress", "none"}, "anna");
  ASSERT_EQ(remote.code, 0) << remote.err;
  const Ended local =
      run_program(test::run_words("surfaces/" + input, "local", 2, 3), folder_.path());
  EXPECT_EQ(test::digest_of(remote).size(), 32U);
  EXPECT_EQ(test::digest_of(remote), test::digest_of(local));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "state/tetfarm.db"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "store/tetfarm.db"));
}

TEST_F(KeyedFarm, tells_each_who_is_turned_away_why) {
  start();
  EXPECT_THAT(ask({"status"}, "").err, HasSubstr("this coordinator requires a key: --key"));
  EXPECT_THAT(ask({"status"}, "stranger").err, HasSubstr("not authorised"));
  EXPECT_THAT(ask({"cancel", "job-1"}, "eve").err, HasSubstr("viewer eve may not send cancel"));
  const Ended worker = run_program(worker_words("stranger"), folder_.path());
  EXPECT_EQ(worker.code, 1);
  EXPECT_THAT(worker.err, HasSubstr("not authorised"));
  test::write_contents(folder_.path() / "outside.off", "OFF");
  EXPECT_THAT(ask({"submit", "outside.off", "--coordinator-reads", "--no-check"}, "anna").err,
              AllOf(HasSubstr("outside.off: is not in a folder where jobs may name surfaces"),
                    HasSubstr((folder_.path() / "surfaces").string())));
  const Ended status = ask({"status", "--json"}, "eve");
  const nlohmann::json farm = nlohmann::json::parse(status.out, nullptr, false);
  ASSERT_TRUE(farm.is_object()) << status.out;
  EXPECT_EQ(farm["security"], "keys");
  EXPECT_GE(farm["refused"]["unknown_key"], 2);
  EXPECT_GE(farm["refused"]["broken_handshake"], 1);
  EXPECT_EQ(farm["refused"]["wrong_role"], 1);
  EXPECT_EQ(farm["refused"]["outside_roots"], 1);
}

TEST_F(KeyedFarm, a_revoked_worker_ends_and_a_revoked_client_is_shut_out) {
  start();
  Program worker(worker_words("node-1"), folder_.path());
  nlohmann::json farm;
  do {
    farm = nlohmann::json::parse(ask({"status", "--json"}, "eve").out, nullptr, false);
    ASSERT_TRUE(farm.is_object());
  } while (farm["workers"] != 1);
  run({"keys", "revoke", "node-1"});
  const Ended ended = worker.wait(20);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("no longer authorised"));
  run({"keys", "revoke", "eve"});
  EXPECT_NE(ask({"status"}, "eve").code, 0);
  EXPECT_EQ(ask({"status"}, "anna").code, 0);
  EXPECT_THAT(run({"keys", "list"}).out,
              AllOf(HasSubstr("submitter anna"), testing::Not(HasSubstr("eve"))));
}

TEST_F(KeyedFarm, other_hosts_are_let_in_only_with_keys_or_when_asked_for) {
  std::filesystem::remove_all(folder_.path() / keys_folder);
  const Ended refused = run_program(
      {"coordinator", "--store", "bare", "--listen", "tcp://0.0.0.0:*"}, folder_.path());
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("keys new coordinator"), HasSubstr("--insecure")));
}

TEST_F(KeyedFarm, the_coordinators_files_cannot_be_submitted_as_a_surface) {
  start({"--allow-root", "."});  // in which all of them lie
  std::filesystem::create_hard_link(folder_.path() / keys_folder / "coordinator.key",
                                    folder_.path() / "wing.stl");
  std::filesystem::create_symlink(folder_.path() / "state/tetfarm.db",
                                  folder_.path() / "database.stl");
  for (const char* path : {"wing.stl", "database.stl"}) {
    const Ended ended = ask({"submit", path, "--coordinator-reads", "--no-check"}, "anna");
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr("no job may name"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "store/artifacts"));
}

TEST_F(KeyedFarm, keys_lie_outside_the_store_and_the_log_says_where) {
  start();
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / keys_folder / "coordinator.key"));
  EXPECT_THAT(test::contents(folder_.path() / "store/coordinator.log"),
              HasSubstr("keys of " + (folder_.path() / keys_folder).string()));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "store/keys"));
  EXPECT_THAT(run({"keys", "new", "late", "--keys", "store/mine"}).err,
              HasSubstr("keep keys elsewhere"));
}

TEST_F(KeyedFarm, keys_of_earlier_versions_beside_the_database_are_found_and_warned_of) {
  std::filesystem::create_directories(folder_.path() / "state");
  std::filesystem::rename(folder_.path() / keys_folder, folder_.path() / "state/keys");
  start();
  EXPECT_THAT(test::contents(folder_.path() / "store/coordinator.log"),
              AllOf(HasSubstr("warning"), HasSubstr("the keys are in state/keys"),
                    HasSubstr((folder_.path() / keys_folder).string())));
  coordinator_.reset();
  run({"keys", "new", "coordinator"});
  const Ended both = run_program(coordinator_words(), folder_.path());
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, AllOf(HasSubstr("state/keys"), HasSubstr("--keys")));
}

TEST_F(KeyedFarm, a_coordinator_without_keys_says_where_it_looked) {
  std::filesystem::remove_all(folder_.path() / keys_folder);
  start();
  EXPECT_THAT(test::contents(folder_.path() / "store/coordinator.log"),
              AllOf(HasSubstr("plain text"), HasSubstr((folder_.path() / keys_folder).string()),
                    HasSubstr("state/keys")));
}

std::filesystem::perms mode_of(const std::filesystem::path& path) {
  return std::filesystem::status(path).permissions();
}

/// Starts the program with that umask.
std::vector<std::string> with_umask(const std::string& mask) {
  return {"/bin/sh", "-c", "umask " + mask + "; exec \"$0\" \"$@\"", test::built_program()};
}

class Modes : public KeyedFarm,
              public ::testing::WithParamInterface<std::pair<const char*, int>> {};

TEST_P(Modes, of_artifacts_and_database_are_those_that_the_services_umask_leaves_to_a_group) {
  const auto [mask, mode] = GetParam();
  coordinator_.emplace(coordinator_words(), folder_.path(), with_umask(mask));
  endpoint_ = test::endpoint_of(*coordinator_);
  const std::string input = test::sphere_in_box(folder_.path() / "surfaces", 4, 1);
  const Program worker(worker_words("node-1"), folder_.path(), with_umask(mask));
  const std::string job = ask({"submit", "surfaces/" + input}, "anna").out;
  ASSERT_EQ(ask({"wait", job.substr(0, job.find('\n')), "--progress", "none"}, "anna").code, 0);
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(folder_.path() / "store/artifacts")) {
    const bool is_file = entry.is_regular_file();
    files += is_file ? 1 : 0;
    const int expected = is_file ? mode : mode | (mode & 0440) >> 2;
    EXPECT_EQ(static_cast<int>(mode_of(entry)), expected) << entry;
  }
  EXPECT_GT(files, 5);
  EXPECT_EQ(static_cast<int>(mode_of(folder_.path() / "state/tetfarm.db")), 0600);
  EXPECT_EQ(static_cast<int>(mode_of(folder_.path() / "store/coordinator.log")), mode);
}

INSTANTIATE_TEST_SUITE_P(OfAService, Modes,
                         ::testing::Values(std::pair{"022", 0640}, std::pair{"077", 0600}));

TEST(ModesOfARun, are_those_of_its_users_umask) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 4, 1);
  Program run(test::run_words(input, "out", 1, 1), folder.path(), with_umask("022"));
  ASSERT_EQ(run.wait().code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out")) {
    if (entry.path().extension() == ".vtkhdf") {
      EXPECT_EQ(static_cast<int>(mode_of(entry)), 0644) << entry;
    }
  }
}

TEST_F(KeyedFarm, a_key_that_others_may_read_is_refused_by_every_command) {
  start();
  std::filesystem::permissions(folder_.path() / "anna.key",
                               static_cast<std::filesystem::perms>(0640));
  const Ended ended = ask({"status"}, "anna");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("other users may read this secret key"));
  std::filesystem::rename(folder_.path() / "anna.key", folder_.path() / "node-1.key");
  EXPECT_THAT(run_program(worker_words("node-1"), folder_.path()).err,
              HasSubstr("other users may read this secret key"));
}

}  // namespace
}  // namespace tetfarm
