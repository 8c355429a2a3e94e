/// Which sanitizer the program was built with: GCC tells by macros, Clang by features.
#pragma once

namespace tetfarm {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TETFARM_ADDRESS_SANITIZER 1
#endif
#if __has_feature(thread_sanitizer)
#define TETFARM_THREAD_SANITIZER 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define TETFARM_ADDRESS_SANITIZER 1
#endif
#if defined(__SANITIZE_THREAD__)
#define TETFARM_THREAD_SANITIZER 1
#endif

#if defined(TETFARM_ADDRESS_SANITIZER)
inline constexpr bool has_address_sanitizer = true;
#else
inline constexpr bool has_address_sanitizer = false;
#endif
#if defined(TETFARM_THREAD_SANITIZER)
inline constexpr bool has_thread_sanitizer = true;
#else
inline constexpr bool has_thread_sanitizer = false;
#endif

/// Shadow and quarantine then count as the memory of every process.
inline constexpr bool is_sanitized = has_address_sanitizer || has_thread_sanitizer;

}  // namespace tetfarm
