/// How long each text of a message may be, and how many of each there may be: one table for all
/// that is said to the coordinator.
///
/// What names something, or what decides, is refused when it is too long: cut, it would name
/// something else. What only tells people something is cut.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "proto/messages.pb.h"

namespace tetfarm {

enum class TooLong { refused, cut, cut_at_front };

struct TextLimit {
  std::string_view field;  ///< "Hello.host"; of a map "Done.texts", its keys "Done.texts.key"
  std::size_t most_bytes;
  TooLong then = TooLong::refused;
};

struct CountLimit {
  std::string_view field;
  int most;
};

/// Of a text that the table does not name.
inline constexpr std::size_t most_bytes_of_text = 255;
/// Of a repeated field or a map that the table does not name.
inline constexpr int most_of_field = 1000;

std::span<const TextLimit> text_limits();
std::span<const CountLimit> count_limits();

/// Cuts what may be cut. @return what is too long or too many, such as "Hello.host has 300 bytes,
/// at most 255"; "" when all is well. Cost: O(texts).
std::string apply_text_limits(wire::Envelope& envelope);

}  // namespace tetfarm
