/// What an adaptation loop starts from: its job file, its first mesh, and the files that its solver
/// brings along.
#pragma once

#include <string>
#include <vector>

#include "mesh/job_file/loop_job.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"

namespace tetfarm {

struct SolverFile {
  std::string name;  ///< below the solver's folder
  bool is_program = false;
  std::string bytes;
};

struct LoopInput {
  LoopJob job;       ///< its mesh is a plain file name: the bytes travel apart
  std::string mesh;  ///< as Medit's text
  std::vector<SolverFile> files;
};

/// @param path that of the job file. @throws UsageError, InvalidInput, IoError: also where the mesh
/// is none, or files of the solver are missing.
LoopInput read_loop(const std::string& path);

/// Puts what it starts from into the store. The same input has the same key.
wire::Submit publish_loop(const ArtifactStore& store, const LoopInput& input);

}  // namespace tetfarm
