#include "tests/security/farm_under_attack.h"

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/sanitizers.h"

namespace tetfarm::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* token = "nobody may guess this token";
constexpr int look_ms = 20;

const char* const ball =
    "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n"
    "3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";

/// The word behind `mark` in what the coordinator has said so far.
std::string said_after(const Program& program, const std::string& mark) {
  const std::string said = program.out_so_far();
  const std::size_t at = said.find(mark);
  const std::size_t end = said.find_first_of("/ \n", at + mark.size());
  if (at == std::string::npos || end == std::string::npos) return {};
  return said.substr(at + mark.size(), end - at - mark.size());
}

std::string wait_for_word(Program& program, const std::string& mark) {
  for (int waited = 0; waited < patience_ms && program.is_running(); waited += look_ms / 4) {
    std::this_thread::sleep_for(std::chrono::milliseconds(look_ms / 4));
    const std::string word = said_after(program, mark);
    if (!word.empty()) return word;
  }
  ADD_FAILURE() << "the coordinator does not listen: " << program.wait(0).err;
  return ":0";
}

}  // namespace

Farm::Farm(const std::vector<std::string>& words, Roots roots, Token http_token) {
  coordinator_key_ = write_new_key(keys_folder(), "coordinator").public_key;
  for (const auto& [name, role] : {std::pair{"anna", Role::submitter},
                                   {"bert", Role::submitter},
                                   {"node", Role::worker},
                                   {"spare", Role::worker},
                                   {"vera", Role::viewer}}) {
    newcomer(name, role);
  }
  fs::create_directory(folder() / "surfaces");
  write_contents(folder() / "surfaces/ball.off", ball);
  write_contents(folder() / "token", token);
  fs::permissions(folder() / "token", static_cast<fs::perms>(0600));
  std::vector<std::string> all = {
      "coordinator", "--store",           "store",  "--database", "state", "--keys", "keys",
      "--listen",    "tcp://127.0.0.1:*", "--http", "127.0.0.1:0"};
  if (http_token == Token::asked_for) all.insert(all.end(), {"--http-token", "token"});
  if (roots == Roots::surfaces) all.insert(all.end(), {"--allow-root", "surfaces"});
  all.insert(all.end(), words.begin(), words.end());
  coordinator_ = std::make_unique<Program>(all, folder());
  endpoint_ = "tcp://" + wait_for_word(*coordinator_, "tcp://");
  http_ = wait_for_word(*coordinator_, "http://");
}

PeerKeys Farm::keys_of(const std::string& name) const {
  return {read_secret_key(secret_key_path(folder(), name)), coordinator_key_};
}

PeerKeys Farm::stranger() const { return {make_key_pair(), coordinator_key_}; }

PeerKeys Farm::newcomer(const std::string& name, Role role) const {
  const KeyPair own = write_new_key(folder(), name);
  authorize(authorized_keys_path(keys_folder()), {own.public_key, role, name});
  return {own, coordinator_key_};
}

Ended Farm::ask(std::vector<std::string> words, const std::string& name) const {
  words.insert(words.end(), {"--connect", endpoint_, "--key", name + ".key", "--coordinator-key",
                             "keys/coordinator.pub"});
  return run_program(words, folder());
}

nlohmann::json Farm::line() const {
  const Ended ended = ask({"status", "--json"}, "vera");
  EXPECT_EQ(ended.code, 0) << ended.err;
  return nlohmann::json::parse(ended.out.substr(0, ended.out.find('\n')), nullptr, false);
}

wire::StatusReply Farm::status() const {
  RawPeer viewer(endpoint_, keys_of("vera"));
  return viewer.ask(status_request()).status_reply();
}

std::uint64_t Farm::refused(const std::string& kind) const {
  const wire::StatusReply reply = status();
  const auto found = reply.refused().find(kind);
  return found == reply.refused().end() ? 0 : found->second;
}

std::vector<std::string> Farm::secrets() const {
  const std::string line = contents(secret_key_path(keys_folder(), "coordinator"));
  const KeyPair pair = read_secret_key(secret_key_path(keys_folder(), "coordinator"));
  return {line.substr(line.rfind(' ') + 1, 64), pair.secret_bytes, token, "SQLite format 3"};
}

std::uint64_t Farm::resident_bytes() const {
  std::istringstream lines(
      contents("/proc/" + std::to_string(coordinator_->process()) + "/status"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("VmRSS:")) return std::stoull(line.substr(6)) << 10U;
  }
  return 0;
}

std::size_t Farm::descriptors() const {
  std::error_code error;
  std::size_t count = 0;
  const fs::path folder = "/proc/" + std::to_string(coordinator_->process()) + "/fd";
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    ++count;
  }
  return count;
}

std::string good_job(const std::string& name) {
  return "version = 1\nname = \"" + name + "\"\n\n[geometry]\nsurface = \"input.off\"\n";
}

wire::Envelope status_request() {
  wire::Envelope envelope;
  envelope.mutable_status_request();
  return envelope;
}

wire::Envelope hello_of(const std::string& nonce) {
  wire::Envelope envelope;
  envelope.mutable_hello()->set_host("attacker");
  envelope.mutable_hello()->set_nonce(nonce);
  return envelope;
}

wire::Envelope ready_message() {
  wire::Envelope envelope;
  envelope.mutable_ready();
  return envelope;
}

wire::Envelope submission(const Farm& farm, const std::string& key) {
  wire::Envelope envelope;
  wire::Submit& submit = *envelope.mutable_submit();
  submit.set_job_toml(good_job());
  submit.set_name("honest");
  submit.set_key(key);
  submit.set_surface_path((farm.folder() / "surfaces/ball.off").string());
  return envelope;
}

std::unique_ptr<Farm> FarmUnderAttack::farm_;

void FarmUnderAttack::SetUp() {
  heard_bytes().clear();
  before_ = farm().status();
  resident_before_ = farm().resident_bytes();
  descriptors_before_ = farm().descriptors();
}

void FarmUnderAttack::TearDown() {
  ASSERT_TRUE(farm().coordinator().is_running()) << "the coordinator has ended";
  const nlohmann::json line = farm().line();
  ASSERT_TRUE(line.is_object()) << "an honest client is not answered";
  EXPECT_EQ(line["security"], "keys");
  if (!is_sanitized) {
    EXPECT_LE(farm().resident_bytes(), resident_before_ + growth_bytes_);
  }
  constexpr std::size_t slack = 4;
  for (int waited = 0; waited < patience_ms && farm().descriptors() > descriptors_before_ + slack;
       waited += look_ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(look_ms));
  }
  EXPECT_LE(farm().descriptors(), descriptors_before_ + slack);
  for (const std::string& secret : farm().secrets()) {
    EXPECT_EQ(heard_bytes().find(secret), std::string::npos) << "a secret was told";
    for (const auto& file : fs::recursive_directory_iterator(farm().store() / "artifacts")) {
      if (!file.is_regular_file()) continue;
      EXPECT_EQ(contents(file.path()).find(secret), std::string::npos) << file.path();
    }
  }
}

std::uint64_t FarmUnderAttack::counted(const std::string& kind) const {
  const auto before = before_.refused().find(kind);
  return farm().refused(kind) - (before == before_.refused().end() ? 0 : before->second);
}

void FarmUnderAttack::expect_counted(const std::string& kind, std::uint64_t count) const {
  std::uint64_t more = counted(kind);
  for (int waited = 0; waited < patience_ms && more < count; waited += look_ms) {
    std::this_thread::sleep_for(std::chrono::milliseconds(look_ms));
    more = counted(kind);
  }
  EXPECT_GE(more, count) << kind;
}

}  // namespace tetfarm::test
