// A file system in memory for SQLite, whose host can lose power and whose disk can be full, broken
// or locked by somebody: real transactions, real recovery, and no disk.
//
// What is written and not synced is lost one write at a time, each by its own lot, as a disk that
// reorders would. One connection; while it lives it is SQLite's default file system.
#pragma once

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/coordinator/simulation_random.h"

namespace tetfarm::simulation {

class MemoryVfs {
 public:
  MemoryVfs() {
    vfs_.iVersion = 1;
    vfs_.szOsFile = sizeof(OpenFile);
    vfs_.mxPathname = 200;
    vfs_.zName = "tetfarm-memory";
    vfs_.pAppData = this;
    vfs_.xOpen = open;
    vfs_.xDelete = remove;
    vfs_.xAccess = access;
    vfs_.xFullPathname = full_path;
    vfs_.xRandomness = randomness;
    vfs_.xSleep = [](sqlite3_vfs*, int microseconds) { return microseconds; };
    vfs_.xCurrentTime = [](sqlite3_vfs*, double* days) {
      *days = 2460000;
      return SQLITE_OK;
    };
    vfs_.xGetLastError = [](sqlite3_vfs*, int, char*) { return 0; };
    sqlite3_vfs_register(&vfs_, 1);
  }
  ~MemoryVfs() {
    sqlite3_vfs_unregister(&vfs_);
    sqlite3_vfs_register(sqlite3_vfs_find("unix"), 1);
  }
  MemoryVfs(const MemoryVfs&) = delete;
  MemoryVfs& operator=(const MemoryVfs&) = delete;

  using Files = std::map<std::string, std::string>;
  /// The bytes of every file, and a disk of such files. @pre none is open
  Files contents() const {
    Files bytes;
    for (const auto& [name, file] : files_) bytes[name] = file->bytes;
    return bytes;
  }
  void restore(const Files& contents) {
    files_.clear();
    for (const auto& [name, bytes] : contents) {
      files_[name] = std::make_unique<File>();
      files_[name]->bytes = bytes;
    }
    heal();
  }

  /// After `writes` more writes or syncs each further one fails with `code` (SQLITE_FULL,
  /// SQLITE_IOERR_WRITE).
  void fail_after(std::int64_t writes, int code) {
    writes_left_ = writes;
    failure_ = code;
  }
  /// The database is locked by another process.
  void lock_out() { is_locked_ = true; }
  void heal() {
    failure_ = SQLITE_OK;
    is_locked_ = false;
  }
  /// The process is killed: nothing is written any more until heal(), whatever SQLite tries.
  void kill() { fail_after(0, SQLITE_IOERR_WRITE); }
  /// The host loses power: each write that is not synced is lost, or not.
  void lose_power(Random& random) {
    for (auto& [name, file] : files_) {
      std::size_t kept_size = 0;
      for (auto write = file->unsynced.rbegin(); write != file->unsynced.rend(); ++write) {
        if (random.chance(0.5)) {
          undo(*write, file->bytes, kept_size);
        } else {
          kept_size = std::max(kept_size, write->offset + write->size);
        }
      }
      file->unsynced.clear();
    }
  }

 private:
  struct Write {
    std::size_t offset = 0;
    std::size_t size = 0;
    std::size_t size_before = 0;  // of the file
    std::string bytes_before;
  };
  struct File {
    std::string bytes;
    std::vector<Write> unsynced;
    std::vector<std::unique_ptr<std::vector<char>>> shared;  // the index of the log
  };
  struct OpenFile : sqlite3_file {
    MemoryVfs* disk;
    File* file;
    bool is_temporary;
  };

  /// What was there before comes back; a file that the write made longer is as short again, unless
  /// a write after it was kept.
  static void undo(const Write& write, std::string& bytes, std::size_t kept_size) {
    const std::size_t end = write.offset + write.bytes_before.size();
    bytes.resize(std::max(bytes.size(), end));
    bytes.replace(write.offset, write.bytes_before.size(), write.bytes_before);
    bytes.resize(std::max({write.size_before, end, kept_size}));
  }

  int next_write() {
    if (failure_ == SQLITE_OK) return SQLITE_OK;
    return writes_left_-- > 0 ? SQLITE_OK : failure_;
  }

  static MemoryVfs& self(sqlite3_vfs* vfs) { return *static_cast<MemoryVfs*>(vfs->pAppData); }
  static OpenFile& self(sqlite3_file* file) { return *static_cast<OpenFile*>(file); }

  static int open(sqlite3_vfs* vfs, const char* name, sqlite3_file* place, int flags, int* out) {
    MemoryVfs& disk = self(vfs);
    OpenFile& file = self(place);
    file.pMethods = nullptr;
    const std::string key = name == nullptr ? "" : name;
    auto found = disk.files_.find(key);
    if (found == disk.files_.end()) {
      if ((flags & SQLITE_OPEN_CREATE) == 0) return SQLITE_CANTOPEN;
      found = disk.files_.emplace(key, std::make_unique<File>()).first;
    }
    file.disk = &disk;
    file.file = found->second.get();
    file.is_temporary = name == nullptr;
    file.pMethods = &methods();
    if (out != nullptr) *out = flags;
    return SQLITE_OK;
  }

  static int remove(sqlite3_vfs* vfs, const char* name, int) {
    if (const int code = self(vfs).next_write()) return code;
    self(vfs).files_.erase(name);
    return SQLITE_OK;
  }

  static int access(sqlite3_vfs* vfs, const char* name, int, int* result) {
    *result = self(vfs).files_.contains(name) ? 1 : 0;
    return SQLITE_OK;
  }

  static int full_path(sqlite3_vfs*, const char* name, int size, char* out) {
    std::strncpy(out, name, static_cast<std::size_t>(size));
    return SQLITE_OK;
  }

  static int randomness(sqlite3_vfs*, int size, char* out) {
    std::memset(out, 42, static_cast<std::size_t>(size));
    return size;
  }

  static int read(sqlite3_file* place, void* out, int size, sqlite3_int64 offset) {
    const std::string& bytes = self(place).file->bytes;
    const auto from = static_cast<std::size_t>(offset);
    const auto wanted = static_cast<std::size_t>(size);
    const std::size_t there = from < bytes.size() ? std::min(wanted, bytes.size() - from) : 0;
    std::memcpy(out, bytes.data() + std::min(from, bytes.size()), there);
    std::memset(static_cast<char*>(out) + there, 0, wanted - there);
    return there == wanted ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
  }

  static int write(sqlite3_file* place, const void* from, int size, sqlite3_int64 offset) {
    OpenFile& open_file = self(place);
    if (const int code = open_file.disk->next_write()) return code;
    File& file = *open_file.file;
    const auto begin = static_cast<std::size_t>(offset);
    const auto length = static_cast<std::size_t>(size);
    Write undone{begin, length, file.bytes.size(), ""};
    if (begin < file.bytes.size()) undone.bytes_before = file.bytes.substr(begin, length);
    file.unsynced.push_back(std::move(undone));
    if (file.bytes.size() < begin + length) file.bytes.resize(begin + length);
    std::memcpy(file.bytes.data() + begin, from, length);
    return SQLITE_OK;
  }

  static int truncate(sqlite3_file* place, sqlite3_int64 size) {
    OpenFile& open_file = self(place);
    if (const int code = open_file.disk->next_write()) return code;
    std::string& bytes = open_file.file->bytes;
    const auto left = static_cast<std::size_t>(size);
    if (left >= bytes.size()) return SQLITE_OK;
    open_file.file->unsynced.push_back({left, 0, bytes.size(), bytes.substr(left)});
    bytes.resize(left);
    return SQLITE_OK;
  }

  static int sync(sqlite3_file* place, int) {
    OpenFile& open_file = self(place);
    if (const int code = open_file.disk->next_write()) return code;
    open_file.file->unsynced.clear();
    return SQLITE_OK;
  }

  static int close(sqlite3_file* place) {
    OpenFile& open_file = self(place);
    if (open_file.is_temporary) open_file.disk->files_.erase("");
    return SQLITE_OK;
  }

  static int map_shared(sqlite3_file* place, int page, int size, int, void volatile** out) {
    auto& shared = self(place).file->shared;
    while (shared.size() <= static_cast<std::size_t>(page)) {
      shared.push_back(std::make_unique<std::vector<char>>(static_cast<std::size_t>(size)));
    }
    *out = shared[static_cast<std::size_t>(page)]->data();
    return SQLITE_OK;
  }

  static int lock_shared(sqlite3_file* place, int, int, int flags) {
    const bool wants_all = (flags & SQLITE_SHM_LOCK) != 0 && (flags & SQLITE_SHM_EXCLUSIVE) != 0;
    return wants_all && self(place).disk->is_locked_ ? SQLITE_BUSY : SQLITE_OK;
  }

  static int unmap_shared(sqlite3_file* place, int) {
    self(place).file->shared.clear();
    return SQLITE_OK;
  }

  static const sqlite3_io_methods& methods() {
    static const sqlite3_io_methods all = [] {
      sqlite3_io_methods io{};
      io.iVersion = 2;
      io.xClose = close;
      io.xRead = read;
      io.xWrite = write;
      io.xTruncate = truncate;
      io.xSync = sync;
      io.xFileSize = [](sqlite3_file* place, sqlite3_int64* size) {
        *size = static_cast<sqlite3_int64>(self(place).file->bytes.size());
        return SQLITE_OK;
      };
      io.xLock = [](sqlite3_file*, int) { return SQLITE_OK; };
      io.xUnlock = [](sqlite3_file*, int) { return SQLITE_OK; };
      io.xCheckReservedLock = [](sqlite3_file*, int* result) { return *result = 0; };
      io.xFileControl = [](sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; };
      io.xSectorSize = [](sqlite3_file*) { return 4096; };
      io.xDeviceCharacteristics = [](sqlite3_file*) { return 0; };
      io.xShmMap = map_shared;
      io.xShmLock = lock_shared;
      io.xShmBarrier = [](sqlite3_file*) {};
      io.xShmUnmap = unmap_shared;
      return io;
    }();
    return all;
  }

  sqlite3_vfs vfs_{};
  std::map<std::string, std::unique_ptr<File>> files_;
  std::int64_t writes_left_ = 0;
  int failure_ = SQLITE_OK;
  bool is_locked_ = false;
};

}  // namespace tetfarm::simulation
