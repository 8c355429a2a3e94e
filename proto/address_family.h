/// IPv4 or IPv6: ZeroMQ speaks IPv4 alone unless it is told, and when told to speak IPv6 it turns
/// to the IPv6 address of a name that has both. So it is told for those endpoints only that need
/// it.
#pragma once

#include <string>
#include <zmq.hpp>

namespace tetfarm {

/// What an endpoint's address means: here, or at the other end of a connection, where names are
/// looked up.
enum class EndpointUse { bind, connect };

/// Whether the endpoint is an IPv6 address in brackets, "tcp://[::1]:5555", or is to be connected
/// to and names a host that has no IPv4 address. Cost: may ask a name server.
bool needs_ipv6(const std::string& endpoint, EndpointUse use);

/// Makes the socket's next bind or connect speak what the endpoint needs.
void set_address_family(zmq::socket_t& socket, const std::string& endpoint, EndpointUse use);

}  // namespace tetfarm
