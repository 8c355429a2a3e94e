#include "mesh/job_file/loop_job.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "base/error.h"
#include "base/job_name.h"
#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_section.h"
#include "mesh/job_file/toml_text.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 9> loop_keys = {
    "version", "name", "mesh", "cycles", "solver", "adapt", "patch_names", "point", "line"};
constexpr std::array<std::string_view, 8> solver_keys = {
    "command", "files", "mesh", "solution", "start", "time_limit", "memory", "keep"};
constexpr std::array<std::string_view, 11> adapt_keys = {
    "vertices", "fields",    "mode",         "norm",   "h_min",   "h_max",
    "aspect",   "gradation", "corner_angle", "curves", "transfer"};
constexpr std::array<std::string_view, 2> transfer_methods = {"conservative", "linear"};
constexpr std::array<std::string_view, 2> adapt_modes = {"lp", "hessian"};

constexpr std::int64_t longest_time_limit_s = 30 * 86'400;
constexpr std::int64_t most_vertices = 100'000'000;
constexpr std::int64_t most_fields = 1000;
constexpr std::size_t most_kept = 100;

/// A name of a file in the solver's folder, or below it.
std::string inner_name(const JobSection& section, std::string_view key, std::string name) {
  // A mesh may be a folder: "case/".
  const bool is_file = key == "mesh" || std::filesystem::path(name).has_filename();
  if (!is_file || !stays_inside(name))
    section.fail(key, "must name a file in the solver's own folder");
  return name;
}

std::vector<std::string> texts(const JobSection& section, std::string_view key) {
  std::vector<std::string> all;
  if (!section.has(key)) return all;
  for (const toml::node& node : section.array(key)) {
    const auto text = node.value_exact<std::string>();
    if (!text || text->empty()) section.fail(key, "must hold texts, none of them empty");
    all.push_back(*text);
  }
  return all;
}

LoopSolver parse_solver(const JobSection& section) {
  LoopSolver solver;
  solver.command = section.text("command");
  if (solver.command.empty()) section.fail("command", "must not be empty");
  solver.files = texts(section, "files");
  for (auto [key, name] : {std::pair("mesh", &solver.mesh), std::pair("solution", &solver.solution),
                           std::pair("start", &solver.start)}) {
    if (section.has(key)) *name = inner_name(section, key, section.text(key));
  }
  if (section.has("time_limit")) {
    solver.time_limit_s = section.integer("time_limit", 1, longest_time_limit_s);
  }
  if (section.has("memory")) {
    const auto bytes = parse_memory(section.text("memory"));
    if (!bytes) section.fail("memory", "must be an amount like \"2GiB\" or \"500MB\"");
    solver.memory_bytes = *bytes;
  }
  for (const std::string& name : texts(section, "keep")) {
    solver.keep.push_back(inner_name(section, "keep", name));
  }
  if (solver.keep.size() > most_kept) section.fail("keep", "must not name more than 100 files");
  return solver;
}

double parse_gradation(const JobSection& section) {
  const toml::node& node = section.node("gradation");
  if (node.value_exact<std::string>() == "off") return 0;
  const double gradation = section.finite(node, "gradation");
  if (gradation <= 1) section.fail("gradation", "must be more than 1, or \"off\"");
  return gradation;
}

LoopAdaptation parse_adaptation(const JobSection& section) {
  LoopAdaptation adapt;
  if (section.has("vertices")) adapt.vertices = section.integer("vertices", 3, most_vertices);
  if (section.has("fields")) {
    for (const toml::node& node : section.array("fields")) {
      const auto field = node.value_exact<std::int64_t>();
      if (!field || *field < 1 || *field > most_fields) {
        section.fail("fields", "must hold numbers of the solution's fields, from 1");
      }
      adapt.fields.push_back(*field);
    }
  }
  if (section.has("mode")) adapt.mode = section.one_of("mode", adapt_modes);
  if (section.has("norm")) adapt.norm = section.positive("norm");
  if (section.has("h_min")) adapt.h_min = section.positive("h_min");
  if (section.has("h_max")) adapt.h_max = section.positive("h_max");
  if (adapt.h_max > 0 && adapt.h_max < adapt.h_min) {
    section.fail("h_max", "must not be less than `h_min`");
  }
  if (section.has("aspect")) adapt.aspect = section.positive("aspect");
  if (adapt.aspect < 1) section.fail("aspect", "must be at least 1");
  if (section.has("gradation")) adapt.gradation = parse_gradation(section);
  if (section.has("corner_angle")) adapt.corner_angle_deg = section.not_negative("corner_angle");
  if (adapt.corner_angle_deg > 180) section.fail("corner_angle", "must be at most 180 degrees");
  adapt.curves = texts(section, "curves");
  if (section.has("transfer")) adapt.transfer = section.one_of("transfer", transfer_methods);
  return adapt;
}

/// Each "NUMBER NAME".
void parse_patch_names(const JobSection& top, LoopJob& job) {
  for (const std::string& line : texts(top, "patch_names")) {
    std::int64_t number = 0;
    const char* const last = line.data() + line.size();
    const auto [end, error] = std::from_chars(line.data(), last, number);
    if (error != std::errc() || last - end < 2 || *end != ' ') {
      top.fail("patch_names", "must hold texts like \"1 wing\"");
    }
    job.patch_names[number] = std::string(end + 1, last);
  }
}

std::string toml_list(const std::vector<std::string>& all) {
  std::string text = "[";
  for (const std::string& one : all) text += (text.size() > 1 ? ", " : "") + quoted_toml(one);
  return text + "]";
}

std::string solver_to_toml(const LoopSolver& solver) {
  std::string text = "\n[solver]\ncommand = " + quoted_toml(solver.command);
  text += "\nfiles = " + toml_list(solver.files);
  text += "\nmesh = " + quoted_toml(solver.mesh);
  text += "\nsolution = " + quoted_toml(solver.solution);
  text += "\nstart = " + quoted_toml(solver.start);
  text += "\ntime_limit = " + std::to_string(solver.time_limit_s);
  if (solver.memory_bytes > 0) {
    text += "\nmemory = \"" + std::to_string(solver.memory_bytes) + "\"";
  }
  return text + "\nkeep = " + toml_list(solver.keep) + "\n";
}

std::string adaptation_to_toml(const LoopAdaptation& adapt) {
  std::string text = "\n[adapt]\nmode = " + quoted_toml(adapt.mode);
  if (adapt.vertices) text += "\nvertices = " + std::to_string(*adapt.vertices);
  if (!adapt.fields.empty()) {
    text += "\nfields = [";
    for (const std::int64_t field : adapt.fields) {
      text += (text.back() == '[' ? "" : ", ") + std::to_string(field);
    }
    text += ']';
  }
  text += "\nnorm = " + toml_number(adapt.norm);
  if (adapt.h_min > 0) text += "\nh_min = " + toml_number(adapt.h_min);
  if (adapt.h_max > 0) text += "\nh_max = " + toml_number(adapt.h_max);
  text += "\naspect = " + toml_number(adapt.aspect);
  text += "\ngradation = " + (adapt.gradation > 0 ? toml_number(adapt.gradation) : "\"off\"");
  text += "\ncorner_angle = " + toml_number(adapt.corner_angle_deg);
  if (!adapt.curves.empty()) text += "\ncurves = " + toml_list(adapt.curves);
  return text + "\ntransfer = " + quoted_toml(adapt.transfer) + "\n";
}

}  // namespace

bool stays_inside(std::string_view name) {
  const std::filesystem::path path(name);
  return !name.empty() && path.is_relative() &&
         std::find(path.begin(), path.end(), "..") == path.end();
}

bool is_loop_job(std::string_view text, const std::string& path) {
  return parse_toml(text, path).contains("solver");
}

LoopJob parse_loop_job(std::string_view text, const std::string& path) {
  namespace fs = std::filesystem;
  const toml::table table = parse_toml(text, path);
  const JobSection top(table, "", loop_keys, path);
  if (top.has("version") && top.integer("version", 1) != 1) {
    top.fail("version", "must be 1: this Tetfarm knows no newer version of job files");
  }
  LoopJob job;
  job.name = top.has("name") ? top.text("name") : fs::path(path).stem().string();
  const std::string problem = problem_with_job_name(job.name);
  if (!problem.empty()) top.fail("name", problem);
  const std::string mesh = top.text("mesh");
  if (mesh.empty()) top.fail("mesh", "must not be empty");
  job.mesh = (fs::path(path).parent_path() / mesh).lexically_normal().string();
  if (top.has("cycles")) job.cycles = top.integer("cycles", 1, most_cycles);
  parse_patch_names(top, job);
  top.node("solver");
  job.solver = parse_solver(top.table("solver", solver_keys));
  job.adapt = parse_adaptation(top.table("adapt", adapt_keys));
  job.adapt.sources = plane_sources_of(top);
  return job;
}

std::string to_toml(const LoopJob& job) {
  std::vector<std::string> names;
  for (const auto& [number, name] : job.patch_names) {
    names.push_back(std::to_string(number) + " " + name);
  }
  return "version = 1\nname = " + quoted_toml(job.name) + "\nmesh = " + quoted_toml(job.mesh) +
         "\ncycles = " + std::to_string(job.cycles) + "\npatch_names = " + toml_list(names) + "\n" +
         solver_to_toml(job.solver) + adaptation_to_toml(job.adapt) + to_toml(job.adapt.sources);
}

std::vector<std::string> loop_job_keys() {
  std::vector<std::string> all = {"version", "name", "mesh", "cycles", "patch_names"};
  for (const std::string_view key : solver_keys) all.push_back("solver." + std::string(key));
  for (const std::string_view key : adapt_keys) all.push_back("adapt." + std::string(key));
  for (const std::string& key : plane_source_keys()) all.push_back(key);
  return all;
}

}  // namespace tetfarm
