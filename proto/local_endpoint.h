/// Which addresses only processes of this host can reach.
#pragma once

#include <string>

namespace tetfarm {

/// Only processes of this host can reach it, and its folder's permissions say which.
bool is_ipc(const std::string& endpoint);

/// Only processes of this host can reach it: ipc and loopback addresses.
bool is_local(const std::string& endpoint);

}  // namespace tetfarm
