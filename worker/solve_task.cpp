#include "worker/solve_task.h"

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/clock.h"
#include "base/counted.h"
#include "base/file_system.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/job_file/loop_job.h"
#include "tasks/solve_contract.h"
#include "worker/solver_process.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_log_kept = std::size_t{16} << 20U;
constexpr std::size_t last_words = 2000;

std::string end_of(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(text.size() - most);
}

void put(const fs::path& folder, const std::string& name, const std::string& bytes) {
  const fs::path path = folder / name;
  make_folders(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw IoError("cannot write", path.string(), errno);
}

/// Lines "x NAME" of programs and "- NAME" of other files, in the order of the numbers of `files`.
void put_files(const TaskIo& io, const SolveGiven& given, const fs::path& folder) {
  if (!given.file_names) return;
  std::istringstream lines(io.read(*given.file_names));
  std::string line;
  for (std::uint64_t number = 1; std::getline(lines, line); ++number) {
    const std::string name = line.size() > 2 ? line.substr(2) : "";
    if (!stays_inside(name)) {
      throw UsageError("a file of the solver may not be named '" + name + "'", "the loop");
    }
    put(folder, name, io.read(file_of_leaf(given.files, number)));
    if (line.front() == 'x') ::chmod((folder / name).c_str(), 0777);
  }
}

/// How many nodes it has.
std::size_t put_mesh(const TaskIo& io, const SolveGiven& given, const LoopJob& job,
                     const fs::path& folder) {
  const fs::path path = folder / job.solver.mesh;
  make_folders(path.parent_path());
  PlaneMesh mesh = read_plane_medit(io.path(given.mesh));
  for (const auto& [number, name] : job.patch_names) {
    mesh.patch_names[static_cast<std::int32_t>(number)] = name;
  }
  write_plane_mesh(mesh, path);
  return mesh.points.size();
}

/// How many nodes the mesh has.
std::size_t prepare(const TaskIo& io, const SolveGiven& given, const LoopJob& job,
                    const fs::path& folder) {
  put_files(io, given, folder);
  const std::size_t nodes = put_mesh(io, given, job, folder);
  if (given.start) put(folder, job.solver.start, io.read(*given.start));
  return nodes;
}

std::vector<std::pair<std::string, std::string>> variables_of(const SolveGiven& given,
                                                              const LoopSolver& solver) {
  return {{"TETFARM_CYCLE", std::to_string(given.cycle)},
          {"TETFARM_CYCLES", std::to_string(given.cycles)},
          {"TETFARM_MESH", solver.mesh},
          {"TETFARM_SOLUTION", solver.solution},
          {"TETFARM_START", given.start ? solver.start : ""}};
}

[[noreturn]] void refuse(const SolveGiven& given, const std::string& what, const std::string& log) {
  std::string message = "cycle " + std::to_string(given.cycle) + ": the solver " + what;
  if (!log.empty()) message += "; its last words:\n" + end_of(log, last_words);
  throw TaskRefusal(ExitCode::failed, message, {{"solver.log", end_of(log, longest_log_kept)}});
}

void require_good_end(const SolverEnd& end, const SolveGiven& given, const LoopSolver& solver,
                      const std::string& log) {
  if (end.is_overdue) {
    refuse(given,
           "did not end within its `time_limit` of " +
               counted(static_cast<std::uint64_t>(solver.time_limit_s), "second"),
           log);
  }
  // What was killed may go well another time.
  if (end.signal != 0) {
    throw Error(ExitCode::failed, "the solver was ended by signal " + std::to_string(end.signal) +
                                      "; its last words:\n" + end_of(log, last_words));
  }
  if (end.exit_code != 0) {
    refuse(given, "ended with exit code " + std::to_string(end.exit_code), log);
  }
}

/// Numbers at each vertex of the mesh.
std::string checked_solution(const SolveGiven& given, const LoopSolver& solver, std::size_t nodes,
                             const fs::path& folder, const std::string& log) {
  const fs::path path = folder / solver.solution;
  if (!fs::is_regular_file(path)) refuse(given, "left no file '" + solver.solution + "'", log);
  std::string bytes = read_file(path);
  const NodeFields fields =
      read_plane_sol(bytes, "cycle " + std::to_string(given.cycle) + ": " + solver.solution);
  const std::size_t values = !fields.scalars.empty()   ? fields.scalars.front().size()
                             : !fields.vectors.empty() ? fields.vectors.front().size()
                                                       : 0;
  if (values != nodes) {
    refuse(given,
           "gives values at " + counted(values, "node") + " in '" + solver.solution +
               "'; the mesh has " + std::to_string(nodes),
           log);
  }
  return bytes;
}

void require_permission() {
  const char* said = std::getenv(solvers_variable);
  if (said != nullptr && std::string(said) == "yes") return;
  throw UsageError(
      "this worker runs no solvers: start workers for loops with `tetfarm worker --solvers`",
      "the loop");
}

}  // namespace

void solve_task(TaskIo& io) {
  require_permission();
  const auto given = io.given<SolveGiven>();
  const LoopJob job = parse_loop_job(io.read(given.job), "job.toml");
  const LoopSolver& solver = job.solver;
  const fs::path folder = io.scratch_path("solver");
  const fs::path log_path = io.scratch_path("solver.log");
  make_folders(folder);
  const std::size_t nodes = prepare(io, given, job, folder);
  report_cost(io, cost_of(SolveGiven::kind, {}, {}));
  io.progress().begin(WorkStage::solve);
  const std::int64_t start = steady_ms();
  const SolverEnd end = run_solver(
      {solver.command, folder, log_path, variables_of(given, solver), 1000 * solver.time_limit_s},
      [&io] { io.progress().add(0); });
  io.number("solver_seconds", static_cast<double>(steady_ms() - start) / 1000);
  const std::string log = end_of(read_file(log_path), longest_log_kept);
  require_good_end(end, given, solver, log);
  SolveMade made;
  made.solution = io.publish(checked_solution(given, solver, nodes, folder, log));
  made.log = io.publish(log);
  for (std::size_t i = 0; i < solver.keep.size(); ++i) {
    const fs::path kept = folder / solver.keep[i];
    if (fs::is_regular_file(kept)) made.kept[i + 1] = io.publish(read_file(kept));
  }
  io.made(made);
}

}  // namespace tetfarm
