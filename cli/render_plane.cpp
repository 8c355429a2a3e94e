#include "cli/render_plane.h"

#include <array>
#include <filesystem>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "cli/node_field.h"
#include "cli/picture_options.h"
#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/formats/plane/plane_medit.h"
#include "mesh/render/patch_curve.h"
#include "mesh/render/plane_picture.h"
#include "report/line_chart.h"

namespace tetfarm {
namespace {

/// What only pictures of space have.
void require_no_space_options(const RenderCommand& command) {
  const RenderCommand plain;
  const bool is_of_regions = command.colour == plain.colour || command.colour == "region";
  for (const auto& [is_given, option] : {std::pair{command.view != plain.view, "--view"},
                                         {!is_of_regions, "--colour"},
                                         {!command.from.empty(), "--from"},
                                         {command.up != plain.up, "--up"},
                                         {!command.bodies.empty(), "--body"},
                                         {!command.hidden.empty(), "--hide"},
                                         {command.plane != plain.plane, "--plane"},
                                         {command.at.has_value(), "--at"},
                                         {command.explode != plain.explode, "--explode"}}) {
    if (is_given) {
      throw UsageError("is for meshes of space; " + command.input + " is one of the plane", option);
    }
  }
  if (command.centre.size() == 3) {
    throw UsageError("a place in the plane has two numbers: X,Y", "--centre");
  }
}

std::vector<double> field_on(const PlaneMesh& mesh, const std::string& file,
                             const RenderCommand& command) {
  return node_field(file, command.field_number, mesh.points.size(), mesh.name);
}

std::vector<Metric2> metrics_at_nodes(const std::string& file, const PlaneMesh& mesh) {
  NodeFields fields = read_plane_sol(file);
  if (fields.metrics.empty()) {
    throw InvalidInput("has no symmetric tensors: a metric has kind 3", file);
  }
  require_value_for_each_node(fields.metrics.front().size(), mesh.points.size(), mesh.name, file);
  check_metrics(mesh, fields.metrics.front(), file);
  return std::move(fields.metrics.front());
}

PlanePictureOptions plane_options(const RenderCommand& command) {
  PlanePictureOptions options;
  std::tie(options.width, options.height) = picture_size(command.size);
  options.edge_width = command.edge_width.value_or(command.field.empty() ? 0.9 : 0);
  options.window.zoom = command.zoom;
  options.window.across = command.across;
  if (!command.centre.empty()) options.window.centre = Vec2{command.centre[0], command.centre[1]};
  options.levels = command.levels;
  if (!command.range.empty()) options.range = {command.range[0], command.range[1]};
  return options;
}

ExitCode write_picture(const RenderCommand& command) {
  TF_CHECK(command.along.empty());
  require_png(command.output);
  const PlanePictureOptions options = plane_options(command);
  const PlaneMesh mesh = read_plane_medit(command.input);
  std::vector<double> field;
  std::vector<Metric2> metrics;
  if (!command.field.empty()) field = field_on(mesh, command.field, command);
  if (!command.metric.empty()) metrics = metrics_at_nodes(command.metric, mesh);
  const Picture picture = plane_picture(mesh, {field, metrics}, options);
  write_file_atomically(command.output, png_of(picture));
  return ExitCode::ok;
}

/// A mesh and its field, for a chart.
struct MeshAndField {
  std::string mesh;
  std::string field;
};

std::vector<MeshAndField> all_of_chart(const RenderCommand& command) {
  std::vector<MeshAndField> all = {{command.input, command.field}};
  for (const std::string& pair : command.also) {
    const std::size_t comma = pair.find(',');
    if (comma == std::string::npos || comma == 0 || comma + 1 == pair.size()) {
      throw UsageError("\"" + pair + "\" is not MESH,FIELD", "--also");
    }
    all.push_back({pair.substr(0, comma), pair.substr(comma + 1)});
  }
  return all;
}

void require_patches(const PlaneMesh& mesh, const std::vector<std::int32_t>& patches) {
  const std::set<std::int32_t> known(mesh.patches.begin(), mesh.patches.end());
  for (const std::int32_t patch : patches) {
    if (known.contains(patch)) continue;
    std::string all;
    for (const std::int32_t one : known) all += (all.empty() ? "" : ", ") + std::to_string(one);
    throw UsageError(mesh.name + " has no patch " + std::to_string(patch) +
                         (all.empty() ? "; it has none" : "; its patches are " + all),
                     "--along");
  }
}

LineChart::Curve curve_of(const MeshAndField& files, const RenderCommand& command) {
  const PlaneMesh mesh = read_plane_medit(files.mesh);
  require_nodes_of_mesh(mesh);
  require_patches(mesh, command.along);
  const std::vector<double> field = field_on(mesh, files.field, command);
  return {files.field, "", values_over_x(mesh, field, command.along)};
}

ExitCode write_chart(const RenderCommand& command) {
  TF_CHECK(!command.along.empty());
  if (!has_ending(command.output, ".svg")) {
    throw ErrorWithHelp(ExitCode::usage,
                        command.output +
                            ": a chart is written as SVG; give a name that ends in "
                            ".svg",
                        "");
  }
  LineChart chart;
  std::tie(chart.width, chart.height) = picture_size(command.size);
  chart.x_name = "x";
  chart.is_reversed = command.reversed;
  for (const MeshAndField& files : all_of_chart(command)) {
    chart.curves.push_back(curve_of(files, command));
    chart.curves.back().colour = chart_colours.at((chart.curves.size() - 1) % chart_colours.size());
  }
  write_file_atomically(command.output, svg_file_of(chart));
  return ExitCode::ok;
}

}  // namespace

bool is_plane_mesh_name(const std::string& file) {
  return std::filesystem::path(file).extension() == ".mesh";
}

void require_no_plane_options(const RenderCommand& command) {
  for (const auto& [value, option] :
       {std::pair{command.field, "--field"}, {command.metric, "--metric"}}) {
    if (!value.empty()) throw UsageError("is for meshes of the plane (.mesh)", option);
  }
}

ExitCode render_plane(const RenderCommand& command) {
  require_no_space_options(command);
  return command.along.empty() ? write_picture(command) : write_chart(command);
}

}  // namespace tetfarm
