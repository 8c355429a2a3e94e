/// Who may connect to the coordinator, and as what.
///
/// It answers the handshakes of encrypted connections (ZeroMQ's authentication protocol, RFC 27)
/// from the list of authorised keys, bounds the number of connections, and says of each message
/// whose it is, by the list as it is at that moment: a revoked key is worth nothing from the next
/// message on. Used by the thread of the ROUTER socket only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "coordinator/views/refusals.h"
#include "proto/authorized_keys.h"
#include "proto/key_file.h"

namespace tetfarm {

struct AuthenticatorOptions {
  std::filesystem::path keys_folder;  ///< "": all listeners are plain
  std::size_t max_connections = 16384;
  int handshake_ms = 10'000;  ///< a connection that takes longer is closed
};

/// Who sent a message.
struct Sender {
  std::string connection;    ///< ZeroMQ's routing id
  std::string key;           ///< of an encrypted connection; "" of a plain one, which may do all
  std::optional<Role> role;  ///< of the key; nothing when it is not authorised (any longer)
  std::string name;          ///< of the key

  bool is_plain() const { return key.empty(); }
  bool may_send(const wire::Envelope& envelope) const {
    return is_plain() ? is_for_the_coordinator(envelope.body_case())
                      : role && tetfarm::may_send(*role, envelope);
  }
};

class Authenticator {
 public:
  /// Reads the coordinator's key and the list. To be made before, and destroyed after, the socket
  /// that it guards. @throws UsageError, IoError.
  Authenticator(zmq::context_t& context, const AuthenticatorOptions& options, Refusals& refusals);

  /// Sets the socket's limits and begins to watch it; before it listens.
  void guard(zmq::socket_t& router);
  /// The next endpoint that the socket binds is encrypted, or plain.
  void make_next_listener(zmq::socket_t& router, bool encrypted) const;

  /// What to wait for besides messages.
  std::vector<zmq::pollitem_t> poll_items();
  /// Answers waiting handshakes and takes note of connections; never waits.
  void serve(std::int64_t now_ms);

  /// Reads the list again when its file has changed. @return whether it has since the last call.
  bool has_new_list();
  Sender sender_of(const zmq::message_t& message, std::string connection) const;
  /// Whether the key (as in Sender) may do a worker's work now.
  bool admits_worker(const std::string& key) const;

  bool has_keys() const { return own_.has_value(); }
  const PublicKey& public_key() const { return own_->public_key; }
  std::size_t connections() const { return open_.size(); }
  std::size_t authorized() const { return list_.peers.size(); }
  /// Troubles with the list since the last call, for the log.
  std::vector<std::string> take_complaints();

 private:
  /// Of a file, to see that it is another one now.
  struct Mark {
    std::uint64_t inode = 0;
    std::int64_t size = -1;
    std::int64_t changed_ns = 0;
    friend bool operator==(const Mark&, const Mark&) = default;
  };
  Mark mark_of_list() const;
  void refresh();
  void read_list();
  void answer_handshakes(std::int64_t now_ms);
  std::string verdict(const std::vector<zmq::message_t>& request, std::int64_t now_ms);
  void note_connections(std::int64_t now_ms);

  AuthenticatorOptions options_;
  Refusals& refusals_;
  std::optional<KeyPair> own_;
  AuthorizedKeys list_;
  std::filesystem::path list_path_;  ///< looked at before each message
  Mark list_mark_;
  bool is_list_new_ = false;
  std::vector<std::string> complaints_;
  zmq::context_t& context_;
  zmq::socket_t handshakes_;
  zmq::socket_t events_;
  std::set<std::uint32_t> open_;  ///< connections, by their file descriptors
};

}  // namespace tetfarm
