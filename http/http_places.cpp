#include "http/http_places.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <map>
#include <tuple>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int64_t patience_ms = 2'000;
constexpr std::size_t network_bytes = 8;
constexpr std::size_t mapped_bytes = 12;

bool is_in_use(const HttpPlace& place, std::int64_t now_ms) {
  return place.stage == HttpPlace::Stage::listens && now_ms - place.since_ms < patience_ms;
}

std::string text_of(int family, const void* address) {
  TF_CHECK(family == AF_INET || family == AF_INET6);
  std::array<char, INET6_ADDRSTRLEN> text{};
  ::inet_ntop(family, address, text.data(), text.size());
  return text.data();
}

std::string peer_of_4(in_addr address) {
  constexpr std::uint32_t loopback_network = 127;
  if (ntohl(address.s_addr) >> 24U == loopback_network) return "";
  return text_of(AF_INET, &address);
}

std::string peer_of_6(in6_addr address) {
  if (IN6_IS_ADDR_LOOPBACK(&address)) return "";
  if (IN6_IS_ADDR_V4MAPPED(&address)) {
    in_addr mapped{};
    std::memcpy(&mapped, address.s6_addr + mapped_bytes, sizeof mapped);
    return peer_of_4(mapped);
  }
  std::memset(address.s6_addr + network_bytes, 0, sizeof address.s6_addr - network_bytes);
  return text_of(AF_INET6, &address);
}

}  // namespace

std::optional<int> who_gives_way(const std::vector<HttpPlace>& places, std::int64_t now_ms) {
  std::map<std::string, std::int64_t> count;
  for (const HttpPlace& place : places) ++count[place.peer];
  const auto before = [&](const HttpPlace& a, const HttpPlace& b) {
    return std::tuple(-count[a.peer], a.stage, a.since_ms, a.fd) <
           std::tuple(-count[b.peer], b.stage, b.since_ms, b.fd);
  };
  const HttpPlace* first = nullptr;
  for (const HttpPlace& place : places) {
    if (is_in_use(place, now_ms)) continue;
    if (first == nullptr || before(place, *first)) first = &place;
  }
  return first == nullptr ? std::nullopt : std::optional(first->fd);
}

std::vector<HttpPlace> places_of(const std::string& peer, const std::vector<HttpPlace>& places) {
  std::vector<HttpPlace> own;
  for (const HttpPlace& place : places) {
    if (place.peer == peer) own.push_back(place);
  }
  return own;
}

std::string peer_of(const sockaddr_storage& address) {
  if (address.ss_family == AF_INET) {
    return peer_of_4(reinterpret_cast<const sockaddr_in&>(address).sin_addr);
  }
  TF_CHECK(address.ss_family == AF_INET6);
  return peer_of_6(reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
}

}  // namespace tetfarm
