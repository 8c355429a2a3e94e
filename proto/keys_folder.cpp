#include "proto/keys_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <system_error>

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const fs::path below = "tetfarm/keys";

bool is_home(const fs::path& home) {
  std::error_code ignored;
  return home.is_absolute() && home != home.root_path() && fs::is_directory(home, ignored);
}

bool is_store(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "store_id", ignored) &&
         fs::is_directory(folder / "artifacts", ignored);
}

}  // namespace

OwnAccount own_account() {
  const auto environment = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  return {environment, ::geteuid() == 0};
}

fs::path default_keys_folder(const OwnAccount& account) {
  const fs::path config = account.environment("XDG_CONFIG_HOME");
  if (config.is_absolute()) return config / below;  // a relative one means nothing
  const fs::path home = account.environment("HOME");
  if (account.is_root || !is_home(home)) return "/etc" / below;
  return home / ".config" / below;
}

fs::path store_round(const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) return {};
  for (fs::path above = real;; above = above.parent_path()) {
    if (is_store(above)) return above;
    if (above == above.parent_path()) return {};
  }
}

}  // namespace tetfarm
