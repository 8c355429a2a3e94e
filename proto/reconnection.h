/// How soon a worker or a client tries again to connect to a coordinator that was not there.
#pragma once

#include <string>
#include <zmq.hpp>

namespace tetfarm {

/// To be called before the socket connects. Over a network the pauses double, from a tenth of a
/// second to two seconds, so that many peers do not burden a coordinator that comes up. To an ipc
/// address it is tried every few milliseconds, as whoever starts a run waits for it: while there is
/// no coordinator that takes 2 % of a core.
void set_reconnection(zmq::socket_t& socket, const std::string& endpoint);

}  // namespace tetfarm
