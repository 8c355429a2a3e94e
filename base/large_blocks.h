// Where large vectors lie.
#pragma once

#include <malloc.h>

#include <limits>

namespace tetfarm {

/// Blocks of 4 MiB and more go back to the system when they are freed. The C library raises this
/// limit to 32 MiB as such blocks come and go, and keeps what it got: meshing 5.3 million tets then
/// holds 414 MB at its peak, with this 350 MB, in the same time. To be called once, at the start.
inline void give_back_large_blocks() {
  constexpr int bytes = 4 << 20;
  ::mallopt(M_MMAP_THRESHOLD, bytes);
}

/// The opposite, for a program that reads one part after the other into arrays of about the same
/// size: given back and taken anew each time, their pages cost a third of the time
/// (bench/large_file.py). To be called once, at the start.
inline void keep_freed_memory() {
  ::mallopt(M_MMAP_THRESHOLD, 1 << 30);
  ::mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
}

}  // namespace tetfarm
