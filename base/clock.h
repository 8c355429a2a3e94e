/// Time as the service sees it: a steady clock for leases and back-off, and the wall clock for
/// people.
///
/// Only the shells (server, worker client) read a clock; decisions get the time as a number, so
/// that tests can let days pass in a loop. Units: milliseconds.
#pragma once

#include <cstdint>

namespace tetfarm {

/// Milliseconds of a clock that never goes back while the machine is up. Its zero means nothing and
/// differs between machines and reboots: never store it.
std::int64_t steady_ms();

/// Milliseconds since 1970-01-01 UTC. May jump; for logs and tables only.
std::int64_t wall_ms();

}  // namespace tetfarm
