#include "proto/address_family.h"

#include <netdb.h>
#include <sys/socket.h>

#include <string_view>

namespace tetfarm {
namespace {

constexpr std::string_view tcp = "tcp://";

bool has_address(const std::string& host, int family) {
  addrinfo hints{};
  hints.ai_family = family;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return false;
  ::freeaddrinfo(found);
  return true;
}

}  // namespace

bool needs_ipv6(const std::string& endpoint, EndpointUse use) {
  if (!endpoint.starts_with(tcp)) return false;
  const std::string address = endpoint.substr(tcp.size());
  if (address.starts_with("[")) return true;
  if (use == EndpointUse::bind) return false;
  const std::string host = address.substr(0, address.rfind(':'));
  return !has_address(host, AF_INET) && has_address(host, AF_INET6);
}

void set_address_family(zmq::socket_t& socket, const std::string& endpoint, EndpointUse use) {
  socket.set(zmq::sockopt::ipv6, needs_ipv6(endpoint, use));
}

}  // namespace tetfarm
