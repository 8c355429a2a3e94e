/// Where the keys of a coordinator lie when nobody says so: outside the store, which the farm's
/// workers and users share.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace tetfarm {

/// What a process knows of itself, so that it can be tried out.
struct OwnAccount {
  std::function<std::string(const char*)> environment;  ///< a variable, "": not set
  bool is_root = false;
};
/// This process.
OwnAccount own_account();

/// $XDG_CONFIG_HOME/tetfarm/keys where that is set; else /etc/tetfarm/keys for root and for a
/// service whose user has no home, ~/.config/tetfarm/keys for everybody else. It need not be there.
std::filesystem::path default_keys_folder(const OwnAccount& account = own_account());

/// The store that the folder lies in, or is; "" when it lies in none. It need not be there.
std::filesystem::path store_round(const std::filesystem::path& folder);

}  // namespace tetfarm
