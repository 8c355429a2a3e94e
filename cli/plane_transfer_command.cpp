#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/error.h"
#include "base/hash.h"
#include "cli/adapted_report.h"
#include "cli/commands.h"
#include "json/json_line.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/adaptation/solution_transfer.h"
#include "mesh/formats/plane/number_fields.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_meshb.h"

namespace tetfarm {
namespace {

NodeFields checked_fields(const std::string& file, const PlaneMesh& mesh) {
  NodeFields fields = read_plane_fields(file);
  if (fields.order.empty()) throw InvalidInput("has no fields", file);
  for (const std::vector<double>& values : fields.scalars) check_values(mesh, values, file);
  for (const std::vector<Metric2>& metrics : fields.metrics) check_metrics(mesh, metrics, file);
  return fields;
}

Hash128 digest_of_fields(const TransferredSolution& solution) {
  Hasher hasher;
  for (const TransferredField& field : solution.fields) {
    hasher.add(field.values.data(), field.values.size() * sizeof(double));
  }
  for (const std::vector<Metric2>& metrics : solution.metrics) {
    hasher.add(metrics.data(), metrics.size() * sizeof(Metric2));
  }
  return hasher.finish();
}

nlohmann::ordered_json solution_json(const PlaneTransferCommand& command, std::size_t vertices,
                                     const std::vector<NumberField>& fields,
                                     const TransferredSolution& solution, double seconds) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const TransferredField& field = solution.fields[f];
    list.push_back({{"name", fields[f].name},
                    {"min_before", field.before.min},
                    {"max_before", field.before.max},
                    {"integral_before", field.before.integral},
                    {"min", field.after.min},
                    {"max", field.after.max},
                    {"integral", field.after.integral},
                    {"gain", field.gain}});
  }
  nlohmann::ordered_json json{{"type", "transfer"},
                              {"file", command.output},
                              {"method", command.method},
                              {"vertices", vertices},
                              {"fields", std::move(list)},
                              {"metrics", solution.metrics.size()},
                              {"nodes_outside", solution.nodes_outside},
                              {"farthest_outside", solution.farthest_outside}};
  if (solution.nodes_outside > 0) {
    json["farthest_at"] = {solution.farthest_at.x, solution.farthest_at.y};
  }
  if (solution.covered_percent >= 0) json["covered_percent"] = solution.covered_percent;
  json["seconds"] = seconds;
  json["digest"] = digest_of_fields(solution).hex();
  return json;
}

void print_solution(const PlaneTransferCommand& command, std::size_t vertices,
                    const std::vector<NumberField>& fields, const TransferredSolution& solution,
                    double seconds) {
  std::printf("%s: %zu vertices, %s, %.2f s\n", command.output.c_str(), vertices,
              command.method.c_str(), seconds);
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const TransferredField& field = solution.fields[f];
    std::printf("field %-10sfrom %.8g to %.8g; before from %.8g to %.8g\n", fields[f].name.c_str(),
                field.after.min, field.after.max, field.before.min, field.before.max);
    std::printf("  integral      %.12g; before %.12g, gain %.2g\n", field.after.integral,
                field.before.integral, field.gain);
  }
  if (!solution.metrics.empty()) std::printf("metrics         %zu\n", solution.metrics.size());
  if (solution.covered_percent >= 0) {
    std::printf("covered         %.4f %% of the new domain\n", solution.covered_percent);
  }
  std::printf("nodes outside   %lld", static_cast<long long>(solution.nodes_outside));
  if (solution.nodes_outside > 0) {
    std::printf(", by %.3g at most (at %.6g, %.6g)", solution.farthest_outside,
                solution.farthest_at.x, solution.farthest_at.y);
  }
  std::printf("\n");
}

void require_solution_name(const std::string& file) {
  if (std::filesystem::path(file).extension() == ".sol") return;
  throw UsageError("solutions are read and written as .sol (Medit, text)", file);
}

}  // namespace

ExitCode plane_transfer_command(const PlaneTransferCommand& command) {
  require_plane_input_name(command.input);
  require_plane_input_name(command.to);
  require_solution_name(command.output);
  const std::int64_t start = steady_ms();
  const PlaneMesh from = read_plane_mesh(command.input);
  const NodeFields before = checked_fields(command.solution, from);
  const std::vector<NumberField> fields = number_fields(before);
  std::vector<std::vector<double>> numbers;
  for (const NumberField& field : fields) {
    if (field.is_component) check_values(from, field.values, command.solution);
    numbers.push_back(field.values);
  }
  const PlaneMesh to = read_plane_mesh(command.to);
  const TransferredSolution solution = transfer_solution(
      from, numbers, before.metrics, to,
      command.method == "linear" ? TransferMethod::linear : TransferMethod::conservative);
  std::vector<std::vector<double>> brought;
  for (const TransferredField& field : solution.fields) brought.push_back(field.values);
  write_plane_sol(assembled_fields(before, std::move(brought), solution.metrics), command.output);
  const double seconds = static_cast<double>(steady_ms() - start) / 1000;
  if (command.json) {
    std::printf(
        "%s\n",
        json_line(solution_json(command, to.points.size(), fields, solution, seconds)).c_str());
  } else {
    print_solution(command, to.points.size(), fields, solution, seconds);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
