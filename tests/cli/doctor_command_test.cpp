// `tetfarm doctor`, the program itself, in surroundings that are sound and in some that are not.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "proto/key_file.h"
#include "tests/cli/parsed.h"
#include "tests/cli/plain_listener.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using test::write_contents;
using ::testing::AllOf;
using ::testing::HasSubstr;

using DoctorOptions = PlainEnvironment;

TEST_F(DoctorOptions, arrive_where_they_belong) {
  const auto least = parsed_as<DoctorCommand>({"doctor"});
  EXPECT_EQ(least.store + least.database + least.keys + least.pool + least.client.endpoint, "");
  EXPECT_EQ(least.folder, ".");
  EXPECT_TRUE(least.endpoints.empty());
  EXPECT_EQ(least.memory_bytes, 0U);
  EXPECT_FALSE(least.client.json);
  const auto all = parsed_as<DoctorCommand>(
      {"doctor",    "--store", "s",     "--database", "d",   "--listen", "tcp://*:1", "--listen",
       "tcp://*:2", "--keys",  "k",     "--memory",   "2GB", "--pool",   "slurm",     "--connect",
       "tcp://h:1", "--key",   "a.key", "--timeout",  "3",   "--json"});
  EXPECT_EQ(all.store, "s");
  EXPECT_EQ(all.database, "d");
  EXPECT_EQ(all.endpoints, (std::vector<std::string>{"tcp://*:1", "tcp://*:2"}));
  EXPECT_EQ(all.keys, "k");
  EXPECT_EQ(all.memory_bytes, std::uint64_t{2} << 30U);
  EXPECT_EQ(all.pool, "slurm");
  EXPECT_EQ(all.client.endpoint, "tcp://h:1");
  EXPECT_EQ(all.client.keys.own, "a.key");
  EXPECT_EQ(all.client.timeout_s, 3);
  EXPECT_TRUE(all.client.json);
  EXPECT_EQ(parsed_as<DoctorCommand>({"doctor", "--folder", "f"}).folder, "f");
  EXPECT_THAT(refusal_of({"doctor", "--folder", "f", "--store", "s"}), HasSubstr("--store"));
  EXPECT_THAT(refusal_of({"doctor", "--pool", "pbs"}), HasSubstr("pbs"));
}

/// What the program finds, by what it looked at.
class Doctor : public ::testing::Test {
 protected:
  /// Without the batch systems of this machine, which need not be in order.
  Doctor() : path_(std::getenv("PATH")) {
    ::setenv("PATH", (folder_.path() / "no_programs").c_str(), 1);
  }
  ~Doctor() override { ::setenv("PATH", path_.c_str(), 1); }

  /// As "VERDICT FOUND", joined where there are several.
  std::map<std::string, std::string> found(std::vector<std::string> words, int code) {
    words.insert(words.begin(), "doctor");
    words.insert(words.end(), {"--json", "--timeout", "2"});
    if (std::find(words.begin(), words.end(), "--keys") == words.end()) {
      ::setenv("XDG_CONFIG_HOME", (folder_.path() / "config").c_str(), 1);
    }
    const Ended ended = run_program(words, folder_.path());
    EXPECT_EQ(ended.code, code) << ended.out << ended.err;
    std::map<std::string, std::string> check2found;
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) {
      const json object = json::parse(line);
      if (object["type"] != "finding") continue;
      const std::string verdict = object["verdict"];
      EXPECT_EQ(verdict == "ok", object["remedy"] == "") << line;
      check2found[object["check"]] += verdict + " " + object["found"].get<std::string>() + "\n";
    }
    return check2found;
  }

  TemporaryFolder folder_;

 private:
  std::string path_;
};

TEST_F(Doctor, finds_a_sound_folder_sound_and_says_so_for_people_too) {
  const auto sound = found({}, 0);
  for (const char* check : {"program", "memory", "open files", "disk", "files", "database", "clock",
                            "keys", "batch system"}) {
    EXPECT_TRUE(sound.contains(check)) << check;
  }
  EXPECT_FALSE(sound.contains("coordinator"));
  const Ended people = run_program({"doctor"}, folder_.path());
  EXPECT_EQ(people.code, 0) << people.out;
  EXPECT_THAT(people.out, AllOf(HasSubstr("ok       files         "), HasSubstr("\n0 problems, ")));
}

TEST_F(Doctor, finds_a_file_in_place_of_a_folder) {
  write_contents(folder_.path() / "file", "x");
  const auto wrong = found({"--folder", "file"}, 1);
  EXPECT_THAT(wrong.at("files"),
              HasSubstr("problem " + (folder_.path() / "file").string() + ": is not a folder"));
  EXPECT_THAT(found({"--store", "nowhere"}, 1).at("files"), HasSubstr("nowhere: is not there"));
}

TEST_F(Doctor, finds_a_key_that_others_may_read) {
  write_new_key(folder_.path() / "keys", "coordinator");
  ::chmod((folder_.path() / "keys" / "coordinator.key").c_str(), 0644);
  EXPECT_THAT(found({"--keys", "keys"}, 1).at("keys"),
              HasSubstr("problem keys/coordinator.key: other users may read this secret key"));
}

TEST_F(Doctor, finds_a_port_that_another_program_uses) {
  const test::PlainListener listener;
  EXPECT_THAT(found({"--listen", listener.endpoint()}, 1).at("address"),
              HasSubstr("problem " + listener.endpoint() + ": in use (process "));
  EXPECT_THAT(found({"--connect", listener.endpoint()}, 1).at("coordinator"),
              HasSubstr("no coordinator answers"));
}

TEST_F(Doctor, misses_a_batch_system_and_memory_that_have_to_be_there) {
  EXPECT_THAT(found({"--pool", "lsf"}, 1).at("batch system"),
              HasSubstr("problem lsf: bsub is not on the PATH"));
  EXPECT_THAT(found({"--memory", "100TB"}, 1).at("memory"), HasSubstr("problem "));
}

TEST_F(Doctor, asks_the_coordinator_that_uses_the_store) {
  test::Program coordinator({"coordinator", "--store", "farm", "--listen",
                             "ipc://" + (folder_.path() / "socket").string(), "--insecure"},
                            folder_.path());
  for (int i = 0; i < 200 && !std::filesystem::exists(folder_.path() / "farm" / "endpoints"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const auto farm = found({"--store", "farm"}, 0);
  EXPECT_THAT(farm.at("coordinator"), HasSubstr("0 workers"));
  EXPECT_THAT(farm.at("version"), HasSubstr("ok the coordinator is this program"));
  EXPECT_THAT(farm.at("clock"), HasSubstr("the clock of the coordinator: as that of this machine"));
  coordinator.signal(SIGTERM);
  coordinator.wait();
  EXPECT_THAT(found({"--store", "farm"}, 0).at("coordinator"), HasSubstr("ok none is using"));
}

}  // namespace
}  // namespace tetfarm
