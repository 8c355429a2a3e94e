// Clients that share nothing with the farm: surfaces go and results come over the encrypted
// connection, whatever is cut or killed meanwhile.
#include <gmock/gmock.h>

#include <csignal>
#include <functional>
#include <map>
#include <thread>

#include "base/hash.h"
#include "store/artifact_store.h"
#include "tests/system/farm_cases.h"
#include "tests/system/tcp_relay.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

using test::Ended;
using test::Program;
using test::run_program;
using test::TcpRelay;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr std::int64_t chunk_bytes = std::int64_t{256} << 10U;

void pause_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

std::vector<fs::path> files_in(const fs::path& folder, const std::string& part) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().find(part) != std::string::npos) {
      files.push_back(entry.path());
    }
  }
  return files;
}

std::uintmax_t size_of(const std::vector<fs::path>& files) {
  std::error_code error;
  const std::uintmax_t size = files.empty() ? 0 : fs::file_size(files.front(), error);
  return error ? 0 : size;
}

bool comes_true(const std::function<bool()>& wish) {
  for (int i = 0; i < 4'000; ++i) {
    if (wish()) return true;
    pause_ms(5);
  }
  return false;
}

/// A farm in one folder, and in another a client that has its key and the coordinator's public one.
class RemoteResults : public ::testing::Test {
 protected:
  RemoteResults() {
    run({"keys", "new", "coordinator", "--keys", "state/keys"});
    for (const auto& [name, role] : std::vector<std::pair<std::string, std::string>>{
             {"node", "worker"}, {"anna", "submitter"}, {"eve", "viewer"}}) {
      run({"keys", "new", name});
      run({"keys", "authorize", name + ".pub", "--role", role, "--keys", "state/keys"});
    }
    coordinator_ = start_coordinator("tcp://127.0.0.1:*");
    endpoint_ = test::endpoint_of(*coordinator_);
    fs::create_directory(laptop());
    input_ = test::sphere_in_box(laptop(), 14, 3);
  }

  fs::path laptop() const { return folder_.path() / "laptop"; }
  void run(const std::vector<std::string>& words) const {
    const Ended ended = run_program(words, folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
  }
  std::unique_ptr<Program> start_coordinator(const std::string& endpoint) const {
    return std::make_unique<Program>(
        std::vector<std::string>{"coordinator", "--store", "store", "--database", "state",
                                 "--listen", endpoint},
        folder_.path());
  }
  std::vector<std::string> at(const std::string& endpoint, std::vector<std::string> words,
                              const std::string& name = "anna") const {
    words.insert(words.end(), {"--connect", endpoint, "--key", "../" + name + ".key",
                               "--coordinator-key", "../state/keys/coordinator.pub"});
    return words;
  }
  Ended ask(const std::vector<std::string>& words, const std::string& name = "anna") const {
    return run_program(at(endpoint_, words, name), laptop());
  }
  /// Three result files, made by a worker that sees the store.
  std::string finished_job() {
    worker_ =
        std::make_unique<Program>(std::vector<std::string>{"worker", "--connect", endpoint_,
                                                           "--store", "store", "--key", "node.key"},
                                  folder_.path());
    const Ended submitted =
        ask({"submit", input_, "--subdomains", "1", "--format", "vtkhdf,lb8.ugrid"});
    EXPECT_EQ(submitted.code, 0) << submitted.err;
    const std::string job = submitted.out.substr(0, submitted.out.find('\n'));
    const Ended waited = ask({"wait", job, "--json", "--progress", "none"});
    EXPECT_EQ(waited.code, 0) << waited.err;
    digest_ = test::digest_of(waited);
    return job;
  }
  /// Bytes in the folder of results, whole files and parts.
  std::uintmax_t arrived() const {
    std::uintmax_t all = 0;
    std::error_code error;
    for (const fs::path& file : files_in(laptop() / "out", "")) {
      const std::uintmax_t size = fs::file_size(file, error);
      if (!error) all += size;
    }
    return all;
  }
  void expect_the_mesh(const Ended& ended) const {
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(digest_.size(), 32U);
    EXPECT_EQ(test::digest_of(ended), digest_);
    EXPECT_THAT(files_in(laptop() / "out", ".part"), IsEmpty());
    const nlohmann::json result = test::result_of(ended);
    ASSERT_THAT(result["files"], SizeIs(3));
    for (const auto& file : result["files"]) {
      const std::string hash = hash128(test::contents(laptop() / file.get<std::string>())).hex();
      EXPECT_TRUE(fs::exists(ArtifactStore::open_existing(folder_.path() / "store").path_of(hash)));
    }
  }

  TemporaryFolder folder_;
  std::string endpoint_;
  std::unique_ptr<Program> coordinator_;
  std::unique_ptr<Program> worker_;
  std::string input_;
  std::string digest_;
  const std::vector<std::string> wait_words_ = {"wait",   "job-1",      "-o",  "out",
                                                "--json", "--progress", "none"};
};

TEST_F(RemoteResults, submit_and_wait_with_nothing_shared_bring_the_mesh_of_a_local_run) {
  finished_job();
  expect_the_mesh(ask(wait_words_));
  const Ended local = run_program(test::run_words(input_, "local", 1, 1), laptop());
  EXPECT_EQ(test::digest_of(local), digest_);
  // What is there already does not come again.
  TcpRelay relay(endpoint_);
  expect_the_mesh(run_program(at(relay.endpoint(), wait_words_), laptop()));
  EXPECT_LT(relay.to_clients(), 50'000);
  EXPECT_EQ(ask({"wait", "job-9", "-o", "out"}).code, 5);
}

TEST_F(RemoteResults, a_client_killed_in_the_middle_goes_on_behind_the_last_chunk) {
  finished_job();
  TcpRelay relay(endpoint_);
  relay.stop_after(5 * chunk_bytes);
  {
    Program client(at(relay.endpoint(), wait_words_), laptop());
    ASSERT_TRUE(comes_true([&] { return arrived() >= 3 * chunk_bytes; }));
    client.signal(SIGKILL);
    client.wait();
  }
  const std::uintmax_t there = arrived();
  EXPECT_THAT(files_in(laptop() / "out", ".part"), SizeIs(1));
  TcpRelay rest(endpoint_);
  const Ended ended = run_program(at(rest.endpoint(), wait_words_), laptop());
  expect_the_mesh(ended);
  EXPECT_LT(rest.to_clients(), static_cast<std::int64_t>(arrived() - there) + 100'000);
}

TEST_F(RemoteResults, goes_on_when_the_coordinator_is_killed_and_when_the_connection_is_cut) {
  finished_job();
  TcpRelay relay(endpoint_);
  relay.stop_after(3 * chunk_bytes);
  Program client(at(relay.endpoint(), wait_words_), laptop());
  std::map<fs::path, std::uintmax_t> most;
  // What has come of a file is never thrown away.
  const auto arrives = [&](std::uintmax_t wanted) {
    for (const fs::path& file : files_in(laptop() / "out", ".part")) {
      std::error_code error;
      const std::uintmax_t size = fs::file_size(file, error);
      if (error) continue;
      EXPECT_GE(size, most[file]);
      most[file] = size;
    }
    return arrived() >= wanted;
  };
  ASSERT_TRUE(comes_true([&] { return arrives(chunk_bytes); }));
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  coordinator_ = start_coordinator(endpoint_);
  ASSERT_EQ(test::endpoint_of(*coordinator_), endpoint_);
  const std::uintmax_t before = arrived();
  // Given again every two seconds: what was left of the old connection may use it up.
  int looks = 0;
  ASSERT_TRUE(comes_true([&] {
    if (looks++ % 400 == 0) relay.stop_after(2 * chunk_bytes);
    return arrives(before + 1);
  }));
  relay.cut();
  relay.let_through();
  ASSERT_TRUE(comes_true([&] { return arrives(0) && !client.is_running(); }));
  expect_the_mesh(client.wait());
}

TEST_F(RemoteResults, a_surface_goes_on_where_it_was_when_the_client_is_killed) {
  const std::string large = test::contents(laptop() / input_) + std::string(2'000'000, ' ');
  test::write_contents(laptop() / "large.off", large);
  const std::vector<std::string> words = {"submit", "large.off", "--progress", "none"};
  const fs::path scratch = folder_.path() / "store/scratch";
  TcpRelay relay(endpoint_);
  relay.stop_after(1'000'000, 5 * chunk_bytes);
  {
    Program client(at(relay.endpoint(), words), laptop());
    ASSERT_TRUE(
        comes_true([&] { return size_of(files_in(scratch, "surface-")) >= 3 * chunk_bytes; }));
    client.signal(SIGKILL);
    client.wait();
  }
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  coordinator_ = start_coordinator(endpoint_);
  const std::uintmax_t there = size_of(files_in(scratch, "surface-"));
  EXPECT_GE(there, 3 * chunk_bytes);
  TcpRelay rest(endpoint_);
  const Ended ended = run_program(at(rest.endpoint(), words), laptop());
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "job-1\n");
  EXPECT_LT(rest.to_coordinator(), static_cast<std::int64_t>(large.size() - there) + 50'000);
  const ArtifactStore store = ArtifactStore::open_existing(folder_.path() / "store");
  EXPECT_EQ(store.read(hash128(large).hex(), large.size()), large);
  EXPECT_THAT(files_in(scratch, "surface-"), IsEmpty());
  // The same again is the same job, and its surface is not sent again.
  TcpRelay again(endpoint_);
  EXPECT_EQ(run_program(at(again.endpoint(), words), laptop()).out, "job-1\n");
  EXPECT_LT(again.to_coordinator(), 50'000);
}

TEST_F(RemoteResults, who_only_looks_or_works_gets_no_results_and_brings_no_surface) {
  finished_job();
  const Ended looked = ask(wait_words_, "eve");
  EXPECT_EQ(looked.code, 1);
  EXPECT_THAT(looked.err, HasSubstr("viewer eve may not send fetch_file"));
  EXPECT_THAT(files_in(laptop() / "out", "sphere"), IsEmpty());
  EXPECT_THAT(ask({"quality", "job-1"}, "eve").err, HasSubstr("may not send fetch_file"));
  EXPECT_THAT(ask({"submit", input_}, "eve").err, HasSubstr("may not send offer_file"));
  EXPECT_THAT(ask({"submit", input_}, "node").err, HasSubstr("may not send offer_file"));
}

TEST_F(RemoteResults, a_result_damaged_or_gone_in_the_store_is_not_published) {
  finished_job();
  expect_the_mesh(ask(wait_words_));
  const fs::path mesh = files_in(laptop() / "out", ".vtkhdf").at(0);
  const ArtifactStore store = ArtifactStore::open_existing(folder_.path() / "store");
  const fs::path kept = store.path_of(hash128(test::contents(mesh)).hex());
  std::string bytes = test::contents(kept);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  fs::remove(kept);
  test::write_contents(kept, bytes);
  fs::remove_all(laptop() / "out");
  const Ended damaged = ask(wait_words_);
  EXPECT_EQ(damaged.code, 1);
  EXPECT_THAT(damaged.err, HasSubstr(".vtkhdf of job-1: is damaged in the coordinator's store"));
  EXPECT_FALSE(fs::exists(mesh));
  EXPECT_THAT(files_in(laptop() / "out", ".part"), IsEmpty());
  fs::remove(kept);
  const Ended gone = ask(wait_words_);
  EXPECT_EQ(gone.code, 5);
  EXPECT_THAT(gone.err, HasSubstr("is no longer in the coordinator's store"));
}

TEST_F(RemoteResults, commands_about_a_mesh_take_a_job_over_the_connection_and_from_the_store) {
  finished_job();
  const Ended far = ask({"quality", "job-1", "--json"});
  ASSERT_EQ(far.code, 0) << far.err;
  EXPECT_EQ(test::digest_of(far), digest_);
  EXPECT_EQ(test::result_of(far)["file"], "job-1/sphere_in_box.vtkhdf");
  const std::vector<std::string> in_store = {"--store", "../store", "--database", "../state"};
  const auto near = [&](std::vector<std::string> words) {
    words.insert(words.end(), in_store.begin(), in_store.end());
    return ask(words);
  };
  const Ended with_spacing = near({"quality", "job-1", "--json"});
  EXPECT_EQ(test::digest_of(with_spacing), digest_);
  EXPECT_EQ(ask({"export", "job-1", "-o", "far.su2"}).code, 0);
  EXPECT_EQ(near({"export", "job-1", "-o", "near.su2"}).code, 0);
  EXPECT_EQ(test::contents(laptop() / "far.su2"), test::contents(laptop() / "near.su2"));
  EXPECT_EQ(ask({"render", "job-1", "-o", "far.png", "--size", "80x50"}).code, 0);
  EXPECT_EQ(near({"render", "job-1", "-o", "near.png", "--size", "80x50"}).code, 0);
  EXPECT_EQ(test::contents(laptop() / "far.png"), test::contents(laptop() / "near.png"));
  EXPECT_EQ(ask({"report", "job-1", "-o", "far.html"}).code, 0);
  EXPECT_NE(test::contents(laptop() / "far.html").find("What each worker did"), std::string::npos);
  EXPECT_THAT(files_in(laptop(), "tetfarm."), IsEmpty());
}

TEST_F(RemoteResults, a_mesh_that_came_for_a_while_is_gone_also_when_the_command_is_killed) {
  finished_job();
  fs::create_directory(laptop() / "scratch");
  TcpRelay relay(endpoint_);
  relay.stop_after(2 * chunk_bytes);
  const std::vector<std::string> words = {"quality", "job-1", "--scratch", "scratch"};
  Program client(at(relay.endpoint(), words), laptop());
  const auto passing = [this] { return files_in(laptop() / "scratch", "tetfarm."); };
  ASSERT_TRUE(comes_true([&] { return size_of(passing()) > 0; }));
  client.signal(SIGKILL);
  client.wait();
  EXPECT_TRUE(comes_true([&] { return passing().empty(); }));
}

TEST_F(RemoteResults, a_job_that_is_unknown_or_not_finished_is_said_to_be_so) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"quality", "job-7"},
                                             {"export", "job-7", "-o", "x.su2"},
                                             {"render", "job-7", "-o", "x.png"},
                                             {"report", "job-7", "-o", "x.html"}}) {
    const Ended unknown = ask(words);
    EXPECT_EQ(unknown.code, 5) << words.front();
    EXPECT_THAT(unknown.err, HasSubstr("no job job-7")) << words.front();
  }
  ASSERT_EQ(ask({"submit", input_}).code, 0);
  const Ended running = ask({"quality", "job-1"});
  EXPECT_EQ(running.code, 5);
  EXPECT_THAT(running.err, HasSubstr("job-1 is not finished (running, stage inspect)"));
  ASSERT_EQ(ask({"cancel", "job-1"}).code, 0);
  EXPECT_THAT(ask({"quality", "job-1"}).err, HasSubstr("job-1 has no mesh: it was cancelled"));
  const Ended nowhere = run_program({"quality", "job-1"}, laptop());
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--connect or --store"));
}

}  // namespace
}  // namespace tetfarm
