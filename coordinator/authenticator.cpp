#include "coordinator/authenticator.h"

#include <sys/stat.h>

#include <array>
#include <cstring>
#include <iterator>
#include <utility>
#include <zmq_addon.hpp>

#include "base/check.h"
#include "base/error.h"
#include "proto/wire.h"

namespace tetfarm {
namespace {

constexpr const char* handshake_address = "inproc://zeromq.zap.01";
constexpr const char* event_address = "inproc://connections";
constexpr const char* domain = "tetfarm";
constexpr std::size_t request_frames = 6;  // of a plain connection; an encrypted one adds its key
constexpr std::int64_t ns_per_s = 1'000'000'000;

// A message above max_message_size is counted and answered while it is no more than this; above,
// ZeroMQ closes the connection before the message is there.
constexpr std::int64_t largest_frame = static_cast<std::int64_t>(max_message_size) + (1 << 20);
// Messages that wait for us, and answers that wait for a peer, for each connection.
constexpr int waiting_in = 128;
constexpr int waiting_out = 256;

}  // namespace

Authenticator::Authenticator(zmq::context_t& context, const AuthenticatorOptions& options,
                             Refusals& refusals)
    : options_(options),
      refusals_(refusals),
      context_(context),
      handshakes_(context, zmq::socket_type::rep),
      events_(context, zmq::socket_type::pair) {
  if (!options_.keys_folder.empty()) {
    own_ = read_secret_key(secret_key_path(options_.keys_folder, "coordinator"));
    list_path_ = authorized_keys_path(options_.keys_folder);
    list_mark_ = mark_of_list();
    list_ = read_authorized_keys(list_path_);
  }
  handshakes_.set(zmq::sockopt::linger, 0);
  handshakes_.bind(handshake_address);
}

void Authenticator::guard(zmq::socket_t& router) {
  router.set(zmq::sockopt::maxmsgsize, largest_frame);
  router.set(zmq::sockopt::rcvhwm, waiting_in);
  router.set(zmq::sockopt::sndhwm, waiting_out);
  router.set(zmq::sockopt::handshake_ivl, options_.handshake_ms);
  router.set(zmq::sockopt::zap_domain, domain);
  zmq_socket_monitor(router.handle(), event_address,
                     ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED |
                         ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL |
                         ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL);
  events_.set(zmq::sockopt::linger, 0);
  // Whoever tells of an event must never have to wait for us: it holds a lock of the socket.
  events_.set(zmq::sockopt::rcvhwm, 0);
  events_.connect(event_address);
}

void Authenticator::make_next_listener(zmq::socket_t& router, bool encrypted) const {
  router.set(zmq::sockopt::curve_server, encrypted);
  if (!encrypted) return;
  TF_CHECK(own_.has_value());
  const std::string& secret = own_->secret_bytes;
  if (zmq_setsockopt(router.handle(), ZMQ_CURVE_SECRETKEY, secret.data(), secret.size()) != 0) {
    throw Error(ExitCode::failed, "this libzmq was built without CURVE: keys cannot be used");
  }
}

std::vector<zmq::pollitem_t> Authenticator::poll_items() {
  return {{handshakes_.handle(), 0, ZMQ_POLLIN, 0}, {events_.handle(), 0, ZMQ_POLLIN, 0}};
}

void Authenticator::serve(std::int64_t now_ms) {
  // Connections first: a handshake shall see how many there are.
  note_connections(now_ms);
  answer_handshakes(now_ms);
}

void Authenticator::answer_handshakes(std::int64_t now_ms) {
  while (true) {
    std::vector<zmq::message_t> request;
    if (!zmq::recv_multipart(handshakes_, std::back_inserter(request), zmq::recv_flags::dontwait)) {
      return;
    }
    refresh();
    const std::string status = verdict(request, now_ms);
    // The key becomes the name under which ZeroMQ marks each message of the connection.
    const bool has_key = status == "200" && request.size() > request_frames;
    const std::string user = has_key ? request[request_frames].to_string() : "";
    const std::string id = request.size() > 1 ? request[1].to_string() : "";
    const std::array<std::string, 6> reply = {
        "1.0", id, status, "", user.empty() ? "" : hex_of({user}), ""};
    for (std::size_t i = 0; i < reply.size(); ++i) {
      handshakes_.send(zmq::buffer(reply.at(i)),
                       i + 1 < reply.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
    }
  }
}

/// The status of RFC 27: 200 come in, 300 try later, 400 never.
std::string Authenticator::verdict(const std::vector<zmq::message_t>& request,
                                   std::int64_t now_ms) {
  if (request.size() < request_frames) return "500";
  const std::string address = request[3].to_string();
  if (open_.size() > options_.max_connections) {
    refusals_.count(
        Refusal::too_many_connections,
        address + ": there are already " + std::to_string(open_.size()) + " connections", now_ms);
    return "300";
  }
  const std::string_view mechanism = request[5].to_string_view();
  if (mechanism == "NULL") return "200";  // a plain listener takes no other
  if (mechanism != "CURVE" || request.size() != request_frames + 1) return "400";
  const PublicKey key{request[request_frames].to_string()};
  if (list_.find(key) != nullptr) return "200";
  refusals_.count(Refusal::unknown_key, address + " with key " + hex_of(key), now_ms);
  return "400";
}

void Authenticator::note_connections(std::int64_t now_ms) {
  zmq::message_t event;
  while (events_.recv(event, zmq::recv_flags::dontwait)) {
    if (!event.more() || event.size() != 6) continue;  // the other frame is an address
    std::uint16_t kind = 0;
    std::uint32_t value = 0;
    std::memcpy(&kind, event.data(), sizeof kind);
    std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof kind, sizeof value);
    if (kind == ZMQ_EVENT_ACCEPTED) {
      open_.insert(value);
    } else if (kind == ZMQ_EVENT_DISCONNECTED) {
      open_.erase(value);
    } else {
      refusals_.count(Refusal::broken_handshake,
                      kind == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL
                          ? "plain text to an encrypted address, forged, or not ZeroMQ"
                          : "closed before it was complete",
                      now_ms);
    }
  }
}

Authenticator::Mark Authenticator::mark_of_list() const {
  struct stat about {};
  if (::stat(list_path_.c_str(), &about) != 0) return {};
  return {about.st_ino, about.st_size,
          static_cast<std::int64_t>(about.st_ctim.tv_sec) * ns_per_s + about.st_ctim.tv_nsec};
}

void Authenticator::refresh() {
  if (!has_keys()) return;
  const Mark mark = mark_of_list();
  if (mark == list_mark_) return;
  list_mark_ = mark;
  read_list();
  is_list_new_ = true;
}

bool Authenticator::has_new_list() {
  refresh();
  return std::exchange(is_list_new_, false);
}

/// A list that cannot be read lets nobody in.
void Authenticator::read_list() {
  TF_CHECK(has_keys());
  try {
    list_ = read_authorized_keys(list_path_);
    complaints_.push_back("authorised keys: " + std::to_string(list_.peers.size()));
    for (const std::string& line : list_.bad_lines) {
      complaints_.push_back("authorised keys: " + line + "; this line is ignored");
    }
  } catch (const Error& error) {
    list_ = {};
    complaints_.push_back(std::string("nobody is authorised: ") + error.what());
  }
}

Sender Authenticator::sender_of(const zmq::message_t& message, std::string connection) const {
  Sender sender;
  sender.connection = std::move(connection);
  // cppzmq throws when there is no such property, which is the case of each plain message.
  const char* key = zmq_msg_gets(message.handle(), "User-Id");
  if (key == nullptr || *key == '\0') return sender;
  sender.key = key;
  if (const AuthorizedPeer* peer = list_.find(public_key_of_hex(sender.key, "User-Id"))) {
    sender.role = peer->role;
    sender.name = peer->name;
  }
  return sender;
}

bool Authenticator::admits_worker(const std::string& key) const {
  if (key.empty()) return true;
  const AuthorizedPeer* peer = list_.find(public_key_of_hex(key, "User-Id"));
  return peer != nullptr && peer->role == Role::worker;
}

std::vector<std::string> Authenticator::take_complaints() { return std::exchange(complaints_, {}); }

}  // namespace tetfarm
