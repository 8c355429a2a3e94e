/// How many fields a message has, counted before it is read: in memory a field of two bytes may
/// become a hundred.
#pragma once

#include <cstddef>
#include <string_view>

namespace tetfarm {

/// The most fields that a message to the coordinator may have; those of its parts count too.
inline constexpr std::size_t max_fields = 100'000;

/// Whether an Envelope of these bytes would have more fields than that. Bytes that are no message
/// have those that come before what cannot be read. Cost: one pass at most, no memory.
bool has_too_many_fields(std::string_view bytes);

}  // namespace tetfarm
