/// Messages to bytes and back: the protocol's version, the size limit, and reading that survives
/// garbage.
///
/// One ZeroMQ message part is one Envelope of messages.proto. Who may send what when is in
/// protocol.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "proto/messages.pb.h"

namespace tetfarm {

/// Rises with every change that an older program would misunderstand. A coordinator refuses others.
inline constexpr std::uint32_t protocol_version = 2;

/// The largest message in bytes (16 MiB); set it as ZMQ_MAXMSGSIZE on every socket too.
inline constexpr std::size_t max_message_size = std::size_t{16} << 20U;

/// Bytes of `envelope`, its version set to protocol_version.
/// @throws Error when the message is larger than max_message_size.
std::string encode(wire::Envelope envelope);

/// What became of received bytes.
enum class WireState {
  good,
  wrong_version,  ///< readable, but of another version: `envelope` is filled as far as it is known
  no_body,        ///< nothing, or a kind of message this program does not know
  too_large,
  garbage,  ///< no protobuf message
};

struct Decoded {
  WireState state = WireState::garbage;
  wire::Envelope envelope;
};

/// Reads a message. Never throws on any bytes.
Decoded decode(std::string_view bytes) noexcept;

/// The word for a state in logs and counters.
const char* name_of(WireState state);

}  // namespace tetfarm
