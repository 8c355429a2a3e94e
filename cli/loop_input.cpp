#include "cli/loop_input.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "cli/job_input.h"
#include "mesh/formats/plane/plane_files.h"
#include "tasks/solve_contract.h"
#include "worker/curve_option.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31U;

bool is_program(const fs::path& path) {
  return (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

/// The files that an entry of `files` stands for: itself, or all below it; in the order of names.
std::vector<fs::path> files_of(const fs::path& entry, const std::string& typed) {
  if (fs::is_regular_file(entry)) return {entry};
  if (!fs::is_directory(entry)) {
    throw Error(ExitCode::not_found, entry.string() + ": no such file or folder; `files` names " +
                                         typed + ", beside the job file");
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& found : fs::recursive_directory_iterator(entry)) {
    if (found.is_regular_file()) files.push_back(found.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Its place below the solver's folder: as below the job file's.
std::string inner_name(const fs::path& file, const fs::path& folder) {
  const fs::path inner = file.lexically_normal().lexically_relative(folder.lexically_normal());
  const bool leads_out = inner.empty() || *inner.begin() == "..";
  std::string name = leads_out ? file.filename().string() : inner.string();
  if (name.find('\n') != std::string::npos) {
    throw UsageError("a file with an end of line in its name cannot be taken along", name);
  }
  return name;
}

std::vector<SolverFile> solver_files(const LoopJob& job, const fs::path& folder) {
  std::vector<SolverFile> all;
  std::uint64_t bytes = 0;
  for (const std::string& typed : job.solver.files) {
    const fs::path entry = (folder / typed).lexically_normal();
    for (const fs::path& file : files_of(entry, typed)) {
      bytes += size_of_file(file).value_or(0);
      if (all.size() == most_solver_files || bytes > most_bytes) {
        throw UsageError(
            "`files` of the solver are more than 10,000 files or 2 GiB: name those "
            "that it needs",
            typed);
      }
      all.push_back({inner_name(file, folder.empty() ? fs::path(".") : folder), is_program(file),
                     read_file(file)});
    }
  }
  const auto by_name = [](const SolverFile& a, const SolverFile& b) { return a.name < b.name; };
  std::stable_sort(all.begin(), all.end(), by_name);
  const auto same = [](const SolverFile& a, const SolverFile& b) { return a.name == b.name; };
  const auto twice = std::adjacent_find(all.begin(), all.end(), same);
  if (twice != all.end()) {
    throw UsageError("`files` of the solver has this name twice", twice->name);
  }
  return all;
}

std::string numbered(const std::string& prefix, std::size_t place) {
  return prefix + std::to_string(place + 1);
}

std::string names_of(const std::vector<SolverFile>& files) {
  std::string lines;
  for (const SolverFile& file : files) lines += (file.is_program ? "x " : "- ") + file.name + "\n";
  return lines;
}

/// Of files beside the job file; the mesh must lie on them.
std::vector<std::string> bytes_of_splines(const LoopAdaptation& job, const PlaneMesh& mesh,
                                          const fs::path& folder) {
  const auto place = [&folder](const std::string& typed) { return folder / typed; };
  check_curve_options(job.curves);
  curves_of_options(job.curves, mesh, job.corner_angle_deg, place);
  std::vector<std::string> all;
  for (const std::string& typed : spline_files(job.curves)) all.push_back(read_file(place(typed)));
  return all;
}

}  // namespace

LoopInput read_loop(const std::string& path) {
  LoopInput input;
  input.job = parse_loop_job(text_of_job_file(path), path);
  require_plane_input_name(input.job.mesh);
  require_plane_output_name(input.job.solver.mesh);
  const PlaneMesh mesh = read_plane_mesh(input.job.mesh);
  input.splines = bytes_of_splines(input.job.adapt, mesh, fs::path(path).parent_path());
  input.mesh = medit_text(mesh);
  for (const auto& [number, name] : mesh.patch_names) {
    input.job.patch_names.emplace(number, name);
  }
  input.job.mesh = fs::path(input.job.mesh).filename().string();
  input.files = solver_files(input.job, fs::path(path).parent_path());
  return input;
}

bool is_loop_file(const std::string& path) {
  return path.ends_with(".toml") && is_loop_job(text_of_job_file(path), path);
}

BringFile published_in(const ArtifactStore& store) {
  return [store](const std::string&, const std::string& bytes) { return store.publish(bytes); };
}

wire::Submit submission_of_loop(const LoopInput& input, const BringFile& bring) {
  wire::Submit submit;
  submit.set_job_toml(to_toml(input.job));
  submit.set_name(input.job.name);
  std::string key = submit.job_toml();
  const auto add = [&](const std::string& name, const std::string& shown,
                       const std::string& bytes) {
    const StoredArtifact stored = bring(shown, bytes);
    wire::Artifact& artifact = *submit.add_inputs();
    artifact.set_name(name);
    artifact.set_hash(stored.hash);
    artifact.set_size(stored.size);
    key += name + stored.hash;
  };
  add(field_name(&SolveGiven::mesh), input.job.mesh, input.mesh);
  if (!input.files.empty()) {
    add(field_name(&SolveGiven::file_names), "names of files", names_of(input.files));
  }
  for (std::size_t i = 0; i < input.files.size(); ++i) {
    add(numbered(field_name(&SolveGiven::files), i), input.files[i].name, input.files[i].bytes);
  }
  for (std::size_t i = 0; i < input.splines.size(); ++i) {
    add(numbered(field_name(&SolveGiven::splines), i), "the points of a curve", input.splines[i]);
  }
  submit.set_key(hash128(key).hex());
  return submit;
}

}  // namespace tetfarm
