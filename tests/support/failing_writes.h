// SQLite's writes fail as a disk would make them fail that has become read-only or broken.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <new>

namespace tetfarm::test {

/// While it lives, in this process and those that it forks, all that SQLite writes fails while an
/// error is set; setting it in one sets it in all.
class FailingWrites {
 public:
  explicit FailingWrites(int error_number = 0) {
    void* shared = ::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    EXPECT_NE(shared, MAP_FAILED);
    error() = new (shared) std::atomic<int>(error_number);
    replace_writes(true);
  }
  ~FailingWrites() {
    replace_writes(false);
    ::munmap(error(), sizeof(std::atomic<int>));
  }
  FailingWrites(const FailingWrites&) = delete;
  FailingWrites& operator=(const FailingWrites&) = delete;

  /// 0: writes go through.
  void fail_with(int error_number) const { error()->store(error_number); }

 private:
  static std::atomic<int>*& error() {
    static std::atomic<int>* number = nullptr;
    return number;
  }
  static ssize_t pwrite_or_fail(int file, const void* bytes, size_t count, off_t place) {
    errno = error()->load();
    return errno == 0 ? ::pwrite(file, bytes, count, place) : -1;
  }
  static ssize_t write_or_fail(int file, const void* bytes, size_t count) {
    errno = error()->load();
    return errno == 0 ? ::write(file, bytes, count) : -1;
  }
  /// Whichever of them this SQLite was built to use; nullptr: the system's own.
  static void replace_writes(bool may_fail) {
    const auto pwrite = reinterpret_cast<sqlite3_syscall_ptr>(pwrite_or_fail);
    const auto write = reinterpret_cast<sqlite3_syscall_ptr>(write_or_fail);
    sqlite3_vfs* vfs = sqlite3_vfs_find("unix");
    for (const char* name : {"pwrite", "pwrite64"}) {
      vfs->xSetSystemCall(vfs, name, may_fail ? pwrite : nullptr);
    }
    vfs->xSetSystemCall(vfs, "write", may_fail ? write : nullptr);
  }
};

}  // namespace tetfarm::test
