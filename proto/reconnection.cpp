#include "proto/reconnection.h"

namespace tetfarm {
namespace {

constexpr int local_pause_ms = 3;
constexpr int first_pause_ms = 100;
constexpr int longest_pause_ms = 2000;

}  // namespace

void set_reconnection(zmq::socket_t& socket, const std::string& endpoint) {
  const bool is_local = endpoint.starts_with("ipc://");
  socket.set(zmq::sockopt::reconnect_ivl, is_local ? local_pause_ms : first_pause_ms);
  // 0: the pause stays what it is.
  socket.set(zmq::sockopt::reconnect_ivl_max, is_local ? 0 : longest_pause_ms);
}

}  // namespace tetfarm
