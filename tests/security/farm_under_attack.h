/// A farm with keys to be attacked: the built program as coordinator on loopback, one authorised
/// key of each role, and what every test asks after its attack.
///
/// After each test the coordinator must be the same process, answer an honest client, have no more
/// memory and descriptors than before (within bounds), and have told nobody a secret.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proto/authorized_keys.h"
#include "tests/security/attacker.h"
#include "tests/support/program.h"

namespace tetfarm::test {

/// Beneath a folder of its own:
///   surfaces/   jobs may name surfaces in it; ball.off is there
///   state/      database
///   keys/       the coordinator's key and the list of those authorised
///   store/      artifacts and log
///   *.key       of anna (submitter), bert (another), node and spare (workers), vera (viewer)
///   token       that HTTP asks for
class Farm {
 public:
  enum class Roots { surfaces, none };   ///< folders that jobs may name
  enum class Token { asked_for, none };  ///< of HTTP
  /// `words` are added to the coordinator's command line.
  explicit Farm(const std::vector<std::string>& words = {}, Roots roots = Roots::surfaces,
                Token token = Token::asked_for);

  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path store() const { return folder() / "store"; }
  std::filesystem::path keys_folder() const { return folder() / "keys"; }
  const std::string& endpoint() const { return endpoint_; }
  int port() const { return port_of(endpoint_); }
  int http_port() const { return port_of(http_); }

  /// The keys of somebody in the table above.
  PeerKeys keys_of(const std::string& name) const;
  /// A key that nobody has authorised.
  PeerKeys stranger() const;
  /// A new key with that role.
  PeerKeys newcomer(const std::string& name, Role role) const;

  /// The built program as a client with the key of `name`.
  Ended ask(std::vector<std::string> words, const std::string& name) const;
  /// What `tetfarm status --json` begins with, asked with the viewer's key; null when that fails.
  nlohmann::json line() const;
  /// What a viewer is answered, over a connection of its own.
  wire::StatusReply status() const;
  std::uint64_t refused(const std::string& kind) const;
  std::string log() const { return contents(store() / "coordinator.log"); }
  /// Everything that must stay secret.
  std::vector<std::string> secrets() const;

  Program& coordinator() { return *coordinator_; }
  std::uint64_t resident_bytes() const;
  std::size_t descriptors() const;

 private:
  TemporaryFolder folder_;
  PublicKey coordinator_key_;
  std::unique_ptr<Program> coordinator_;
  std::string endpoint_;
  std::string http_;
};

/// A job file that is right.
std::string good_job(const std::string& name = "honest");
wire::Envelope status_request();
wire::Envelope hello_of(const std::string& nonce);
wire::Envelope ready_message();
/// Of the surface that is there, under that submission key.
wire::Envelope submission(const Farm& farm, const std::string& key);

class FarmUnderAttack : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { farm_ = std::make_unique<Farm>(); }
  static void TearDownTestSuite() { farm_.reset(); }
  void SetUp() override;
  void TearDown() override;

  static Farm& farm() { return *farm_; }
  static RawPeer peer(const std::string& name) { return {farm().endpoint(), farm().keys_of(name)}; }
  /// Waits until so many more of that kind are counted than before the test.
  void expect_counted(const std::string& kind, std::uint64_t count) const;
  std::uint64_t counted(const std::string& kind) const;
  /// For a test whose attack needs more for a while.
  void allow_growth(std::uint64_t bytes) { growth_bytes_ = bytes; }

  static std::unique_ptr<Farm> farm_;

 private:
  wire::StatusReply before_;
  std::uint64_t resident_before_ = 0;
  std::size_t descriptors_before_ = 0;
  std::uint64_t growth_bytes_ = std::uint64_t{64} << 20U;
};

}  // namespace tetfarm::test
