/// The job file of an adaptation loop: a solver, a first mesh of the plane, and what each cycle's
/// mesh is to be like. Every key is documented in docs/adaptation.md.
///
/// Source: thesis 3.3: solve, adapt, bring the solution along, and again.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/job_file/plane_sources.h"

namespace tetfarm {

/// The program that computes a solution on a mesh. It is run by /bin/sh in a folder of its own.
struct LoopSolver {
  std::string command;
  std::vector<std::string> files;  ///< that lie there when it starts, beside the mesh; or folders
  std::string mesh = "mesh.mesh";  ///< the name under which it finds the mesh; its ending decides
  std::string solution = "solution.sol";  ///< what it leaves: numbers at the vertices
  std::string start = "start.sol";  ///< the solution of the cycle before, brought to the new mesh
  std::int64_t time_limit_s = 3600;
  std::int64_t memory_bytes = 0;  ///< that it is given room for; 0: as much as any task
  std::vector<std::string> keep;  ///< files that it leaves for people, where it does
};

/// What a mesh is adapted to; as the options of `tetfarm adapt`.
struct LoopAdaptation {
  std::optional<std::int64_t> vertices;  ///< as many as the mesh before has
  std::vector<std::int64_t> fields;      ///< of the solution, from 1; empty: all
  std::string mode = "lp";               ///< "lp" | "hessian"
  double norm = 2;
  double h_min = 0;
  double h_max = 0;
  double aspect = 1e4;
  double gradation = 1.4;  ///< 0: off
  double corner_angle_deg = 30;
  std::vector<std::string> curves;        ///< as --curve: "1=naca0012"
  std::string transfer = "conservative";  ///< of the solution: "conservative" | "linear"
  std::vector<PlaneSource> sources;       ///< beside the solution, in each cycle
};

struct LoopJob {
  std::string name;
  std::string mesh;  ///< a file, resolved against the job file's folder
  std::int64_t cycles = 6;
  /// Of the mesh, by the numbers of its patches: formats that have names give them to the solver.
  /// Who reads the mesh adds them.
  std::map<std::int64_t, std::string> patch_names;
  LoopSolver solver;
  LoopAdaptation adapt;
};

inline constexpr std::int64_t most_cycles = 999;

/// Whether the text is that of a loop: it has a table [solver]. @throws UsageError as below.
bool is_loop_job(std::string_view text, const std::string& path);

/// Whether a name, put behind that of a folder, names something in it or below it.
bool stays_inside(std::string_view name);

/// Without a name, the job is named like `path` without its folder and ending.
/// @throws UsageError "file:line:column: …", with "did you mean" for an unknown key.
LoopJob parse_loop_job(std::string_view text, const std::string& path);

/// The same job as canonical TOML. Parsed again it gives the same job.
std::string to_toml(const LoopJob& job);

/// Every key that the parser knows, as "solver.command"; for the test that the documents have them.
std::vector<std::string> loop_job_keys();

}  // namespace tetfarm
