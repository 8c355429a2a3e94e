#include "cli/deliver_files.h"

#include "base/file_system.h"
#include "store/artifact_store.h"

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

}  // namespace tetfarm
