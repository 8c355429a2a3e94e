/// Are the files that the rows name there and whole, and what would be done again if not?
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "store/artifact_store.h"
#include "store/rows.h"

namespace tetfarm {

enum class FileState { sound, missing, wrong_size, wrong_bytes };

/// A file that is not as its row says.
struct DamagedFile {
  ArtifactRef file;  ///< with the name that its maker, or else who reads it, has for it
  FileState state = FileState::missing;
  std::vector<TaskId> makers;
  bool is_needed = false;  ///< by a task that is still to run, or as the result of a job
};

struct StoreReport {
  std::size_t files = 0;  ///< that rows name
  std::size_t gone = 0;   ///< of these: made and not there, and all that read them is done
  std::vector<DamagedFile> damaged;
  std::vector<TaskId> redone;   ///< tasks that would run again, by id
  std::vector<JobId> hopeless;  ///< jobs whose own input is gone: to be submitted again
};

/// What a look at a file finds. @throws IoError when the disk cannot be read.
using LookAtFile = std::function<FileState(const ArtifactRef&)>;

/// Looks at the size and, with `checksums`, at every byte.
LookAtFile look_into(const ArtifactStore& store, bool checksums);

/// Whether a job keeps all files between its tasks; without it all do.
using KeepsAll = std::function<bool(const JobRow&)>;

/// Every file of every job is looked at once. A damaged file that is needed is made again by the
/// task that made it, and so are that task's own inputs where they are damaged. Files of jobs that
/// were cancelled are not needed. A file that is not there and that nobody has to read any more is
/// not damaged where its makers' jobs do not keep all (coordinator/decisions/file_needs.h).
StoreReport check_store(const DurableState& state, const LookAtFile& look,
                        const KeepsAll& keeps_all = {});

const char* name_of(FileState state);

}  // namespace tetfarm
