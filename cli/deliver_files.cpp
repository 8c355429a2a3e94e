#include "cli/deliver_files.h"

#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {

std::vector<std::filesystem::path> deliver_files(const wire::JobStatus& status,
                                                 const std::filesystem::path& store_folder,
                                                 const std::filesystem::path& folder) {
  const ArtifactStore store = ArtifactStore::open_existing(store_folder);
  make_folders(folder);
  std::vector<std::filesystem::path> files;
  for (const wire::Artifact& artifact : status.files()) {
    const std::filesystem::path name = std::filesystem::path(artifact.name()).filename();
    if (name.empty() || name == "." || name == "..") continue;
    store.verify(artifact.hash(), artifact.size());
    link_or_copy_file(store.path_of(artifact.hash()), folder / name);
    files.push_back(folder / name);
  }
  return files;
}

bool set_damaged_aside(const wire::JobStatus& status, const ArtifactStore& store) {
  bool is_damaged = false;
  for (const wire::Artifact& file : status.files()) {
    try {
      store.verify(file.hash(), file.size());
    } catch (const CorruptFile&) {
      store.set_aside(file.hash());
      is_damaged = true;
    }
  }
  return is_damaged;
}

}  // namespace tetfarm
