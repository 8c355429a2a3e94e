#include "worker/collect_task.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include "base/hash.h"
#include "mesh/formats/plane/plane_medit.h"
#include "mesh/job_file/loop_job.h"
#include "tasks/collect_contract.h"
#include "worker/cycle_figures.h"
#include "worker/task_cost.h"

namespace tetfarm {
namespace {

/// "cycle_01", so that they are listed in their order.
std::string cycle_name(std::uint64_t cycle) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "cycle_%02llu", static_cast<unsigned long long>(cycle));
  return text.data();
}

void deliver(TaskIo& io, const LeafFiles& files, const std::string& ending) {
  for (const auto& [cycle, file] : files) io.publish(cycle_name(cycle) + ending, io.read(file));
}

void deliver_kept(TaskIo& io, const LeafFiles& files, const std::vector<std::string>& names) {
  for (const auto& [number, file] : files) {
    const std::size_t place = number % kept_of_cycle;
    if (place < 1 || place > names.size()) continue;
    const std::string name = std::filesystem::path(names[place - 1]).filename().string();
    io.publish(cycle_name(number / kept_of_cycle) + "_" + name, io.read(file));
  }
}

std::string table_of(const TaskIo& io, const CollectGiven& given) {
  std::string table = cycle_figures_head();
  for (const auto& [cycle, mesh] : given.meshes) {
    const auto figures = given.figures.find(cycle);
    table += std::to_string(cycle) + "," +
             (figures == given.figures.end() ? cycle_figures(read_plane_medit(io.path(mesh)))
                                             : io.read(figures->second)) +
             "\n";
  }
  return table;
}

}  // namespace

void collect_task(TaskIo& io) {
  const auto given = io.given<CollectGiven>();
  const LoopJob job = parse_loop_job(io.read(given.job), "job.toml");
  report_cost(io, cost_of(CollectGiven::kind, {}, {}));
  io.progress().begin(WorkStage::cycles, given.meshes.size());
  deliver(io, given.meshes, ".mesh");
  deliver(io, given.solutions, ".sol");
  deliver(io, given.logs, ".log");
  deliver_kept(io, given.kept, job.solver.keep);
  const std::string table = table_of(io, given);
  io.publish("cycles.csv", table);
  std::string bytes = table;
  for (const LeafFiles* files : {&given.meshes, &given.solutions}) {
    for (const auto& [cycle, file] : *files) bytes += file.hash;
  }
  io.text("digest", hash128(bytes).hex());
  io.made(CollectMade{});
  if (given.meshes.empty()) return;
  const PlaneMesh last = read_plane_medit(io.path(given.meshes.rbegin()->second));
  io.number("cycles", static_cast<double>(given.meshes.size()));
  io.number("vertices", static_cast<double>(last.points.size()));
  io.number("triangles", static_cast<double>(last.triangles.size()));
}

}  // namespace tetfarm
