#include "tests/support/seen_syncs.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <system_error>

namespace tetfarm::test {
namespace {

thread_local SeenSyncs* watcher = nullptr;

int noted(long call, int descriptor) {
  if (watcher != nullptr) watcher->note(descriptor);
  return static_cast<int>(::syscall(call, descriptor));
}

}  // namespace

SeenSyncs::SeenSyncs() { watcher = this; }

SeenSyncs::~SeenSyncs() { watcher = nullptr; }

void SeenSyncs::note(int descriptor) {
  std::error_code ignored;
  SeenSync sync;
  sync.path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), ignored);
  for (const auto& entry : std::filesystem::directory_iterator(sync.path, ignored)) {
    sync.names.push_back(entry.path().filename());
  }
  std::sort(sync.names.begin(), sync.names.end());
  seen_.push_back(sync);
}

}  // namespace tetfarm::test

// In place of those of the C library.
extern "C" int fsync(int descriptor) { return tetfarm::test::noted(SYS_fsync, descriptor); }

extern "C" int fdatasync(int descriptor) { return tetfarm::test::noted(SYS_fdatasync, descriptor); }
