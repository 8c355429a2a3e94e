// What is put on the disk for good, in which order: fsync and fdatasync of a program that links
// test_seen_syncs, libraries of others included, are noted and then done.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace tetfarm::test {

struct SeenSync {
  std::filesystem::path path;      ///< its name when it was synced
  std::vector<std::string> names;  ///< what was in it, when it is a folder; sorted
};

/// Those of this thread since it was made; one at a time.
class SeenSyncs {
 public:
  SeenSyncs();
  ~SeenSyncs();
  SeenSyncs(const SeenSyncs&) = delete;
  SeenSyncs& operator=(const SeenSyncs&) = delete;

  const std::vector<SeenSync>& all() const { return seen_; }
  bool has(const std::filesystem::path& path) const {
    return std::any_of(seen_.begin(), seen_.end(),
                       [&path](const SeenSync& sync) { return sync.path == path; });
  }
  void note(int descriptor);

 private:
  std::vector<SeenSync> seen_;
};

}  // namespace tetfarm::test
