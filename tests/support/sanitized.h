/// Whether this build runs under a sanitizer, whose shadow and quarantine count as the memory of
/// every process: how much memory the program itself takes cannot be told there.
#pragma once

namespace tetfarm::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace tetfarm::test
