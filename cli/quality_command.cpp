#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/angle_text.h"
#include "base/large_blocks.h"
#include "cli/commands.h"
#include "cli/figures_report.h"
#include "cli/mesh_input.h"
#include "cli/read_ahead.h"
#include "cli/run_folder.h"
#include "json/json_line.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/job_file/job_file.h"
#include "mesh/quality/mesh_check.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int bar_width = 50;
constexpr int bin_deg = 10;

Json shapes_json(const ShapeStatistics& shapes) {
  const Vec3& worst = shapes.worst_centroid;
  return {{"elements", shapes.tets},
          {"min_dihedral_deg", shapes.min_dihedral_deg},
          {"max_dihedral_deg", shapes.max_dihedral_deg},
          {"mean_radius_ratio", shapes.mean_radius_ratio()},
          {"min_radius_ratio", shapes.min_radius_ratio},
          {"smallest_height", shapes.smallest_height},
          {"worst_at", {worst.x, worst.y, worst.z}},
          {"dihedral_histogram", shapes.dihedral_histogram}};
}

/// What the command tells of a mesh.
struct Report {
  MeshCheckResult check;
  MeshFigures figures;
  std::vector<std::string> region_names;  ///< of region 1, 2, …; empty when the file has none

  bool is_valid() const { return check.complaints.empty(); }
};

std::string region_name(const Report& report, std::size_t i) {
  return i < report.region_names.size() ? report.region_names[i] : "";
}

/// Pieces of a file that does not know them are not sub-domains.
std::size_t subdomains_of(const MeshFigures& figures) {
  return figures.knows_subdomains ? figures.subdomains.size() : 1;
}

/// Of a mesh with other cells than tets: what there is besides.
void add_others(const MeshFigures& figures, Json& json) {
  if (figures.boundary_quads > 0) json["boundary_quads"] = figures.boundary_quads;
  for (const ElementType type : cell_block_types) {
    const CellFigures& cells = figures.others[type];
    if (cells.cells == 0) continue;
    json[std::string(element(type).plural)] = {
        {"count", cells.cells},
        {"volume", cells.volume},
        {"least_scaled_jacobian", cells.least_scaled_jacobian},
        {"mean_scaled_jacobian", cells.mean_scaled_jacobian()}};
  }
}

Json report_json(const Report& report, const std::string& file) {
  const MeshFigures& figures = report.figures;
  Json json = {{"type", "quality"},
               {"file", file},
               {"valid", report.is_valid()},
               {"nodes", report.check.nodes},
               {"boundary_triangles", figures.boundary_triangles},
               {"subdomains", subdomains_of(figures)},
               {"volume", report.check.volume},
               {"enclosed_volume", report.check.enclosed_volume}};
  json.update(shapes_json(figures.all.shapes));
  const Vec3& forced = report.check.forced.at;
  json["forced_dihedral_deg"] = report.check.forced.at_most_deg;
  json["forced_at"] = {forced.x, forced.y, forced.z};
  json["near_cuts"] = shapes_json(figures.near_cuts.shapes);
  json["away_from_cuts"] = shapes_json(figures.away_from_cuts.shapes);
  json["regions"] = Json::array();
  for (std::size_t i = 0; i < figures.regions.size(); ++i) {
    const RegionShapes& region = figures.regions[i];
    json["regions"].push_back({{"number", i + 1},
                               {"name", region_name(report, i)},
                               {"volume", region.volume},
                               {"shapes", shapes_json(region.shapes)}});
  }
  add_others(figures, json);
  json["digest"] = report.check.digest.hex();
  json["complaints"] = report.check.complaints;
  return json;
}

void print_others(const MeshFigures& figures) {
  for (const ElementType type : cell_block_types) {
    const CellFigures& cells = figures.others[type];
    if (cells.cells == 0) continue;
    std::printf("%-16s%lld, volume %.12g, scaled Jacobian %.4f mean, %.4f smallest\n",
                std::string(element(type).plural).c_str(), static_cast<long long>(cells.cells),
                cells.volume, cells.mean_scaled_jacobian(), cells.least_scaled_jacobian);
  }
  if (figures.boundary_quads == 0) return;
  std::printf("boundary        %lld quads\n", static_cast<long long>(figures.boundary_quads));
}

double percent_of_angles(const ShapeStatistics& shapes, std::size_t bin) {
  const double all = 6.0 * static_cast<double>(std::max<std::int64_t>(shapes.tets, 1));
  return 100 * static_cast<double>(shapes.dihedral_histogram[bin]) / all;
}

void print_histogram(const ShapeStatistics& shapes) {
  const auto& bins = shapes.dihedral_histogram;
  const auto largest = static_cast<double>(*std::max_element(bins.begin(), bins.end()));
  std::printf("dihedral angles\n");
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const auto count = static_cast<double>(bins[i]);
    const int length = largest > 0 ? static_cast<int>(count / largest * bar_width) : 0;
    const int low = static_cast<int>(i) * bin_deg;
    std::printf("  %3d-%3d %8.4f %% %s\n", low, low + bin_deg, percent_of_angles(shapes, i),
                std::string(static_cast<std::size_t>(length), '#').c_str());
  }
}

/// The same figures near the cuts and away from them, side by side.
void print_side_by_side(const ShapeStatistics& near, const ShapeStatistics& away) {
  std::printf("%-16s%16s%16s\n", "", "near cuts", "elsewhere");
  std::printf("%-16s%16lld%16lld\n", "tets", static_cast<long long>(near.tets),
              static_cast<long long>(away.tets));
  const auto line = [&](const char* name, double of_near, double of_away) {
    std::printf("%-16s%16.6g%16.6g\n", name, of_near, of_away);
  };
  line("min dihedral", near.min_dihedral_deg, away.min_dihedral_deg);
  line("max dihedral", near.max_dihedral_deg, away.max_dihedral_deg);
  line("smallest height", near.smallest_height, away.smallest_height);
  line("radius ratio", near.mean_radius_ratio(), away.mean_radius_ratio());
  for (std::size_t i = 0; i < near.dihedral_histogram.size(); ++i) {
    const int low = static_cast<int>(i) * bin_deg;
    std::printf("  %3d-%3d       %14.4f %%%14.4f %%\n", low, low + bin_deg,
                percent_of_angles(near, i), percent_of_angles(away, i));
  }
}

void print_regions(const Report& report) {
  std::printf("%-16s%16s%16s%16s%16s\n", "region", "tets", "volume", "min dihedral",
              "radius ratio");
  for (std::size_t i = 0; i < report.figures.regions.size(); ++i) {
    const auto& [volume, shapes] = report.figures.regions[i];
    const std::string name = region_name(report, i);
    std::printf("%-16s%16lld%16.6g%16.6g%16.6g\n",
                (name.empty() ? std::to_string(i + 1) : name).c_str(),
                static_cast<long long>(shapes.tets), volume, shapes.min_dihedral_deg,
                shapes.mean_radius_ratio());
  }
}

/// Said only when it explains a small angle: empty when the surface allows 30 degrees.
std::string forced_text(const ForcedDihedral& forced) {
  constexpr double worth_saying_deg = 30;
  if (forced.at_most_deg >= worth_saying_deg) return "";
  char text[200];
  std::snprintf(text, sizeof text,
                "                the surface allows at most %s deg, at (%.6g, %.6g, %.6g)\n",
                angle_text(forced.at_most_deg, 3).c_str(), forced.at.x, forced.at.y, forced.at.z);
  return text;
}

/// @pre there are tets.
void print_shapes(const Report& report) {
  const MeshFigures& figures = report.figures;
  const ShapeStatistics& shapes = figures.all.shapes;
  std::printf("dihedral        %s to %s deg; worst at (%.6g, %.6g, %.6g)\n",
              angle_text(shapes.min_dihedral_deg, 3).c_str(),
              angle_text(shapes.max_dihedral_deg, 3).c_str(), shapes.worst_centroid.x,
              shapes.worst_centroid.y, shapes.worst_centroid.z);
  std::fputs(forced_text(report.check.forced).c_str(), stdout);
  std::printf("radius ratio    %.4f mean, %.4f smallest\nsmallest height %.6g\n",
              shapes.mean_radius_ratio(), shapes.min_radius_ratio, shapes.smallest_height);
}

void print_report(const Report& report) {
  const MeshFigures& figures = report.figures;
  const ShapeStatistics& shapes = figures.all.shapes;
  std::printf("tets            %lld\nnodes           %lld\nboundary        %lld triangles\n",
              static_cast<long long>(shapes.tets), static_cast<long long>(report.check.nodes),
              static_cast<long long>(figures.boundary_triangles));
  print_others(figures);
  std::printf("sub-domains     %zu\nvolume          %.12g, enclosed %.12g\n",
              subdomains_of(figures), report.check.volume, report.check.enclosed_volume);
  if (shapes.tets > 0) print_shapes(report);
  std::printf("digest          %s\n", report.check.digest.hex().c_str());
  if (shapes.tets > 0) print_histogram(shapes);
  if (figures.near_cuts.shapes.tets > 0) {
    print_side_by_side(figures.near_cuts.shapes, figures.away_from_cuts.shapes);
  }
  if (figures.regions.size() > 1) print_regions(report);
}

MeshCheckOptions check_options(const QualityOptions& options) {
  const std::optional<std::int64_t> memory = parse_memory(options.memory);
  if (!memory)
    throw UsageError("\"" + options.memory + "\" is not a size such as 256MiB", "--memory");
  MeshCheckOptions result;
  result.faces = options.check_faces;
  result.memory_bytes = static_cast<std::size_t>(*memory);
  if (!options.scratch.empty()) result.folder = options.scratch;
  return result;
}

/// With lengths over the spacing where the run is known that made the mesh.
Report report_of(const QualityOptions& options, const MeshCheckOptions& check_as,
                 const MeshInput& mesh) {
  std::unique_ptr<MeshSource> source = open_mesh(mesh, check_as.folder);
  if (source->takes_threads()) source = std::make_unique<ReadAhead>(std::move(source));
  const std::optional<SpacingField> spacing = options.run.empty()
                                                  ? spacing_of(mesh, options.source)
                                                  : spacing_beside(mesh_file(options.run));
  SpacingAt spacing_at;
  if (spacing) spacing_at = [&spacing](const Vec3& p) { return spacing->at(p); };
  MeshCheck check(*source, check_as);
  Report report;
  report.figures =
      figures_of(*source, spacing_at, [&check](const NumberedPart& part) { check.add(part); });
  report.check = check.finish();
  report.region_names = source->region_names();
  return report;
}

}  // namespace

std::filesystem::path mesh_file(const std::filesystem::path& input) {
  if (!std::filesystem::is_directory(input)) return input;
  std::vector<std::filesystem::path> meshes;
  for (const auto& entry : std::filesystem::directory_iterator(input)) {
    const std::string name = entry.path().filename();
    if (name.ends_with(".vtkhdf") || name.ends_with(".ugrid")) meshes.push_back(entry.path());
  }
  if (meshes.empty()) {
    if (is_mesh_folder(input)) return input;
    throw Error(ExitCode::not_found, input.string() + ": has no mesh (.vtkhdf, .lb8.ugrid)");
  }
  return *std::min_element(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) {
    return std::pair(a.extension() != ".vtkhdf", a) < std::pair(b.extension() != ".vtkhdf", b);
  });
}

ExitCode quality_command(const QualityOptions& options) {
  keep_freed_memory();
  const MeshCheckOptions check_as = check_options(options);
  const MeshInput mesh = find_mesh(options.input, options.source, check_as.folder);
  const Report report = report_of(options, check_as, mesh);
  if (options.json) {
    Json json = report_json(report, mesh.name);
    if (report.is_valid()) json.update(figures_json(report.figures));
    std::printf("%s\n", json_line(json).c_str());
  } else {
    print_report(report);
    if (report.is_valid()) std::fputs(figures_text(report.figures).c_str(), stdout);
  }
  if (report.is_valid()) return ExitCode::ok;
  std::string message = mesh.name + ": not a valid mesh";
  for (const std::string& complaint : report.check.complaints) message += "\n  " + complaint;
  throw Error(ExitCode::gate, message);
}

}  // namespace tetfarm
