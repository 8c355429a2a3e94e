/// Who gives way when more connect to the HTTP port than it has places: whoever holds places
/// without using them, so that holding them keeps nobody out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct sockaddr_storage;

namespace tetfarm {

struct HttpPlace {
  enum class Stage {
    over,    ///< answered; only the other side's end is waited for
    asks,    ///< its request is not complete
    listens  ///< its answer is on the way
  };
  int fd = -1;
  std::string peer;  ///< of peer_of
  Stage stage = Stage::asks;
  /// When it came, or of one that listens when it last took a part of its answer.
  std::int64_t since_ms = 0;
};

/// The one to end in favour of another: of the peer that holds most places, one that is over, else
/// the oldest that still asks, else one that has not taken anything of its answer for 2 s. Nothing
/// when all are being served. Cost: O(places).
std::optional<int> who_gives_way(const std::vector<HttpPlace>& places, std::int64_t now_ms);

/// Those of one peer.
std::vector<HttpPlace> places_of(const std::string& peer, const std::vector<HttpPlace>& places);

/// Whose connection it is, as far as an address says: an IPv4 address, the 64 bits of a network of
/// IPv6, or "" for this host, where a proxy may speak for many.
std::string peer_of(const sockaddr_storage& address);

}  // namespace tetfarm
