#include "worker/store_probe.h"

#include <spdlog/spdlog.h>

#include <system_error>

#include "base/error.h"
#include "base/file_system.h"
#include "base/ids.h"

namespace tetfarm {
namespace {

constexpr std::size_t random_bytes = 16;

}  // namespace

bool StoreProbe::put_into(wire::Hello& hello, std::int64_t now_ms) {
  if (folder_.empty()) return true;
  try {
    const ArtifactStore store = ArtifactStore::open_existing(folder_);
    if (file_.empty() || !size_of_file(file_)) make(store);
    hello.set_store_probe(store.probe());
    hello.set_probe_file(name_);
    hello.set_probe_text(text_);
    missed_since_ms_.reset();
    return true;
  } catch (const IoError& error) {
    if (!missed_since_ms_) {
      spdlog::warn("waiting for the store: {}", error.what());
      missed_since_ms_ = now_ms;
    }
    return now_ms - *missed_since_ms_ >= patience_ms;
  }
}

bool StoreProbe::is_lost() const noexcept {
  std::error_code error;
  return !file_.empty() && !std::filesystem::exists(file_, error) && !error;
}

void StoreProbe::make(const ArtifactStore& store) {
  name_ = random_hex(random_bytes);
  text_ = random_hex(random_bytes);
  write_file_atomically(probe_path(store, name_), text_);
  file_ = probe_path(store, name_);
}

void StoreProbe::remove() noexcept {
  if (file_.empty()) return;
  try {
    remove_file(file_);
  } catch (const IoError& error) {
    spdlog::warn("{}", error.what());
  }
}

}  // namespace tetfarm
