/// What an adaptation loop starts from: its job file, its first mesh, and the files that its solver
/// brings along.
#pragma once

#include <functional>
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
  std::vector<std::string> splines;  ///< the bytes of spline_files() of its curves
};

/// @param path that of the job file. @throws UsageError, InvalidInput, IoError: also where the mesh
/// is none, or files of the solver are missing.
LoopInput read_loop(const std::string& path);

/// Brings bytes, named as people know them, to where the coordinator finds them.
using BringFile = std::function<StoredArtifact(const std::string& name, const std::string& bytes)>;

BringFile published_in(const ArtifactStore& store);

/// The message that submits it, when what it starts from has been brought. The same input has the
/// same key. @throws what `bring` throws.
wire::Submit submission_of_loop(const LoopInput& input, const BringFile& bring);

/// Whether a path is that of a loop's job file. @throws UsageError, IoError: it is a job file that
/// cannot be read.
bool is_loop_file(const std::string& path);

}  // namespace tetfarm
