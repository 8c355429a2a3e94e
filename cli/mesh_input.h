/// The mesh that a command line names: a file, the folder of a run, or a job.
///
/// A job's mesh is read in the store where one is named. Otherwise it comes over the connection
/// into a file without a name, which is gone with the process, however that ends.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/passing_file.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/spacing/spacing_field.h"
#include "proto/messages.pb.h"

namespace tetfarm {

struct MeshInput {
  std::filesystem::path file;   ///< where it lies
  std::string name;             ///< for people; its ending tells the format
  std::string job;              ///< "": it is no job's
  std::filesystem::path store;  ///< of a job that was found in one; else ""
  PassingFile fetched = {};     ///< keeps a file that came
};

/// A file of a job, where it can be read.
struct JobFileHere {
  std::filesystem::path file;
  PassingFile fetched = {};  ///< keeps a file that came
};

/// One of a job's results: in the store, or fetched into `scratch_folder` where none is named.
/// @throws Error (out_of_resources) when there is no room; CorruptFile when it is damaged.
JobFileHere bring_file_of_job(const wire::JobStatus& status, const wire::Artifact& file,
                              const ViewOptions& view, const std::filesystem::path& scratch_folder);

/// A path when there is such a thing; else the job of that name, which must be done. What comes
/// over the connection lies in `scratch_folder`.
/// @throws Error (not_found) when there is no such path or job, it has no mesh (yet), or nobody
/// answers; (out_of_resources) when there is no room; UsageError for a job when neither a
/// coordinator nor a store is named; CorruptFile when its file is damaged.
MeshInput find_mesh(const std::string& subject, const ViewOptions& view,
                    const std::filesystem::path& scratch_folder);
/// The same of a job whose status is known.
MeshInput mesh_of_job(const wire::JobStatus& status, const ViewOptions& view,
                      const std::filesystem::path& scratch_folder);

/// In the format that its name tells; text formats are kept in `scratch_folder`.
std::unique_ptr<MeshSource> open_mesh(const MeshInput& input,
                                      const std::filesystem::path& scratch_folder);

/// The spacing that made it, as far as the store or the folder of the run still has it.
std::optional<SpacingField> spacing_of(const MeshInput& input, const ViewOptions& view);

}  // namespace tetfarm
