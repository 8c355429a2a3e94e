/// What was refused, counted by kind; told to the log now and then.
///
/// A flood must not fill the log: of each kind the 1st, 2nd, 4th, 8th … is told, and one after each
/// quiet minute.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tetfarm {

enum class Refusal {
  unknown_key,       ///< a handshake with a key that is not authorised
  revoked_key,       ///< a message over a connection whose key is authorised no longer
  wrong_role,        ///< a message that the sender's role may not send
  broken_handshake,  ///< no ZeroMQ, plain to encrypted, a forged or replayed handshake, too slow
  too_many_connections,  ///< handshakes above the limit
  too_many_workers,      ///< Hello above the limit
  foreign_connection,    ///< a connection's name used with another key
  garbage,               ///< no message of the protocol
  too_large,             ///< more bytes than a message, or a text in it, may have
  wrong_version,         ///< of the protocol
  senseless,             ///< readable, but not for the coordinator to get
  stale,                 ///< of an attempt that is over: late, or replayed
  outside_roots,         ///< a surface outside the folders that jobs may name
  no_result,             ///< a file asked for that is no result of the job named
};

inline constexpr std::size_t refusal_kinds = 14;

const char* name_of(Refusal kind);

class Refusals {
 public:
  /// `told` is what the log shall say of it; `now_ms` of a steady clock.
  void count(Refusal kind, const std::string& told, std::int64_t now_ms);

  std::uint64_t of(Refusal kind) const { return counts_.at(static_cast<std::size_t>(kind)); }
  std::uint64_t total() const;

  /// Lines for the log since the last call.
  std::vector<std::string> take_complaints();

 private:
  std::array<std::uint64_t, refusal_kinds> counts_{};
  std::array<std::int64_t, refusal_kinds> told_ms_{};
  std::vector<std::string> complaints_;
};

}  // namespace tetfarm
