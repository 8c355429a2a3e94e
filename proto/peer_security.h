/// How a worker or a client shows its key to the coordinator, and how it learns that it was turned
/// away: ZeroMQ itself only tries again, silently.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <zmq.hpp>

#include "proto/key_file.h"

namespace tetfarm {

/// The keys of one side of an encrypted connection.
struct PeerKeys {
  KeyPair own;
  PublicKey coordinator;
};

/// What the command line says of keys; empty: not given.
struct KeyFiles {
  std::string own;          ///< a secret key file
  std::string coordinator;  ///< the coordinator's public key file
};

/// Where a coordinator with keys leaves its public key for those who see the store.
std::filesystem::path published_key_path(const std::filesystem::path& store);

/// Reads the files; the coordinator's key is taken from the store when no file is named. Nothing
/// when no key is given: the connection is to be plain.
/// @param store may be empty.
/// @throws UsageError when the coordinator's key cannot be known, or a file is wrong; IoError.
std::optional<PeerKeys> read_peer_keys(const KeyFiles& files, const std::filesystem::path& store);

/// To be called before the socket connects; without keys it stays plain.
void secure(zmq::socket_t& socket, const std::optional<PeerKeys>& keys);

/// Listens to what becomes of the handshakes of a socket. One thread uses both.
class HandshakeWatch {
 public:
  /// To be made before the socket connects, and to be destroyed before it.
  HandshakeWatch(zmq::context_t& context, zmq::socket_t& socket);
  ~HandshakeWatch();
  HandshakeWatch(const HandshakeWatch&) = delete;
  HandshakeWatch& operator=(const HandshakeWatch&) = delete;

  enum class Outcome {
    none,         ///< nothing new
    broken,       ///< cut off without a word: a wrong key of the coordinator, or none where it
                  ///< wants one, or it just died
    turned_away,  ///< the coordinator does not know this key
    other_kind,   ///< one side is plain, the other encrypted
  };
  /// The worst outcome since the last call.
  Outcome take();
  /// What to tell a person; "" for none.
  std::string explanation_of(Outcome outcome) const;

 private:
  struct Ears;
  std::unique_ptr<Ears> ears_;
};

}  // namespace tetfarm
