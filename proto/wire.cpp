#include "proto/wire.h"

#include <google/protobuf/stubs/logging.h>

#include <utility>

#include "base/error.h"

namespace tetfarm {

std::string encode(wire::Envelope envelope) {
  envelope.set_version(protocol_version);
  const std::size_t size = envelope.ByteSizeLong();
  if (size > max_message_size) {
    throw Error(ExitCode::failed, "a message of " + std::to_string(size) +
                                      " bytes exceeds the limit of " +
                                      std::to_string(max_message_size));
  }
  return envelope.SerializeAsString();
}

Decoded decode(std::string_view bytes) noexcept {
  // What a stranger sends must not fill our stderr with protobuf's opinion of it.
  [[maybe_unused]] static const auto talkative = google::protobuf::SetLogHandler(nullptr);
  Decoded decoded;
  if (bytes.size() > max_message_size) {
    decoded.state = WireState::too_large;
    return decoded;
  }
  // protobuf throws only when memory runs out while it copies strings out of a bounded buffer.
  try {
    if (!decoded.envelope.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
      decoded.envelope.Clear();
      return decoded;
    }
  } catch (...) {
    decoded.envelope.Clear();
    return decoded;
  }
  if (decoded.envelope.version() != protocol_version) {
    decoded.state = WireState::wrong_version;
  } else if (decoded.envelope.body_case() == wire::Envelope::BODY_NOT_SET) {
    decoded.state = WireState::no_body;
  } else {
    decoded.state = WireState::good;
  }
  return decoded;
}

const char* name_of(WireState state) {
  switch (state) {
    case WireState::good:
      return "good";
    case WireState::wrong_version:
      return "wrong version";
    case WireState::no_body:
      return "no body";
    case WireState::too_large:
      return "too large";
    case WireState::garbage:
      return "garbage";
  }
  return "unknown";
}

}  // namespace tetfarm
