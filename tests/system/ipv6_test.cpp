// A farm on an IPv6 address: with keys and without, worker, client, pool and HTTP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "tests/support/program.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Ipv6Farm : public testing::Test {
 protected:
  std::string start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"coordinator", "--store", "store", "--listen",
                                      "tcp://[::1]:*"};
    words.insert(words.end(), more.begin(), more.end());
    coordinator_.emplace(words, folder_.path());
    return test::endpoint_of(*coordinator_);
  }
  Ended run(const std::vector<std::string>& words) const {
    return run_program(words, folder_.path());
  }
  Ended ask(std::vector<std::string> words, const std::string& endpoint,
            const std::vector<std::string>& keys = {}) const {
    words.insert(words.end(), {"--connect", endpoint, "--timeout", "10"});
    words.insert(words.end(), keys.begin(), keys.end());
    return run(words);
  }

  TemporaryFolder folder_;
  std::optional<Program> coordinator_;
};

TEST_F(Ipv6Farm, meshes_over_loopback_without_keys) {
  const std::string endpoint = start();
  ASSERT_THAT(endpoint, StartsWith("tcp://[::1]:"));
  const std::string input = test::sphere_in_box(folder_.path(), 4, 1);
  const Program worker({"worker", "--connect", endpoint, "--store", "store"}, folder_.path());
  const Ended submitted = ask({"submit", input, "--subdomains", "3", "--store", "store"}, endpoint);
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  const std::string job = submitted.out.substr(0, submitted.out.find('\n'));
  const Ended done = ask({"wait", job, "--json", "--progress", "none"}, endpoint);
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(test::digest_of(done), test::digest_of(run(test::run_words(input, "local", 1, 3))));
}

TEST_F(Ipv6Farm, takes_keys_like_any_other) {
  for (const char* name : {"coordinator", "anna"}) {
    ASSERT_EQ(run({"keys", "new", name, "--keys", "keys"}).code, 0);
  }
  ASSERT_EQ(run({"keys", "authorize", "keys/anna.pub", "--role", "viewer", "--keys", "keys"}).code,
            0);
  const std::string endpoint = start({"--keys", "keys"});
  EXPECT_THAT(ask({"status"}, endpoint).err, HasSubstr("this coordinator requires a key: --key"));
  const Ended ended = ask({"status", "--json"}, endpoint,
                          {"--key", "keys/anna.key", "--coordinator-key", "keys/coordinator.pub"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json farm = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(farm.is_object()) << ended.out;
  EXPECT_EQ(farm["security"], "keys");
}

TEST_F(Ipv6Farm, other_hosts_are_let_in_only_with_keys) {
  const Ended refused = run({"coordinator", "--store", "store", "--listen", "tcp://[::]:*"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("tcp://[::]:*"), HasSubstr("keys new coordinator")));
}

TEST_F(Ipv6Farm, shows_its_pages_there_too) {
  start({"--http", "[::1]:0"});
  EXPECT_THAT(coordinator_->out_so_far() + test::contents(folder_.path() / "store/endpoints"),
              HasSubstr("tcp://[::1]:"));
  for (int i = 0; i < 1000 && coordinator_->out_so_far().find("http://") == std::string::npos;
       ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_THAT(coordinator_->out_so_far(), HasSubstr("status page on http://[::1]:"));
}

TEST_F(Ipv6Farm, has_pools_whose_workers_are_told_its_address) {
  const std::string endpoint = start();
  const Ended ended = run(
      {"pool", "slurm", "--coordinator", endpoint, "--store", "store", "--max", "1", "--dry-run"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  // In quotes: the shell that runs the script would take [::1] for a pattern.
  EXPECT_THAT(ended.out, HasSubstr("--connect '" + endpoint + "'"));
}

}  // namespace
}  // namespace tetfarm
