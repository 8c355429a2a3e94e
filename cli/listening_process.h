/// Which process of this machine listens at a port, as /proc tells.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace tetfarm {

struct ListeningProcess {
  pid_t process = 0;
  std::string command;  ///< its command line, with blanks between the words
};

/// Nothing when nobody listens there, or when it is somebody else's and this user may not see it.
/// Cost: O(open files of all processes that this user may look at).
std::optional<ListeningProcess> process_that_listens(std::uint16_t port);

}  // namespace tetfarm
