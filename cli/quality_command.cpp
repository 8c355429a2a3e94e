#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.h"
#include "mesh/assemble/mesh_report.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int bar_width = 50;
constexpr int bin_deg = 10;

/// The file itself, or of the meshes in the folder the first by name, .vtkhdf (which knows the
/// sub-domains) before .ugrid.
std::filesystem::path mesh_file(const std::filesystem::path& input) {
  if (!std::filesystem::is_directory(input)) return input;
  std::vector<std::filesystem::path> meshes;
  for (const auto& entry : std::filesystem::directory_iterator(input)) {
    const std::string name = entry.path().filename();
    if (name.ends_with(".vtkhdf") || name.ends_with(".ugrid")) meshes.push_back(entry.path());
  }
  if (meshes.empty()) {
    throw Error(ExitCode::not_found, input.string() + ": no mesh (.vtkhdf, .lb8.ugrid) in there");
  }
  return *std::min_element(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) {
    return std::pair(a.extension() != ".vtkhdf", a) < std::pair(b.extension() != ".vtkhdf", b);
  });
}

Json report_json(const MeshReport& report, const std::string& file) {
  const Vec3& worst = report.shapes.worst_centroid;
  const Vec3& forced = report.forced.at;
  return {{"type", "quality"},
          {"file", file},
          {"valid", report.complaints.empty()},
          {"elements", report.tets},
          {"nodes", report.nodes},
          {"boundary_triangles", report.boundary_triangles},
          {"subdomains", report.subdomains},
          {"volume", report.volume},
          {"enclosed_volume", report.enclosed_volume},
          {"min_dihedral_deg", report.shapes.min_dihedral_deg},
          {"max_dihedral_deg", report.shapes.max_dihedral_deg},
          {"mean_radius_ratio", report.shapes.mean_radius_ratio()},
          {"min_radius_ratio", report.shapes.min_radius_ratio},
          {"worst_at", {worst.x, worst.y, worst.z}},
          {"forced_dihedral_deg", report.forced.at_most_deg},
          {"forced_at", {forced.x, forced.y, forced.z}},
          {"dihedral_histogram", report.shapes.dihedral_histogram},
          {"digest", report.digest.hex()},
          {"complaints", report.complaints}};
}

void print_histogram(const ShapeStatistics& shapes) {
  const auto& bins = shapes.dihedral_histogram;
  const auto largest = static_cast<double>(*std::max_element(bins.begin(), bins.end()));
  const double all = 6.0 * static_cast<double>(std::max<std::int64_t>(shapes.tets, 1));
  std::printf("dihedral angles\n");
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const auto count = static_cast<double>(bins[i]);
    const int length = largest > 0 ? static_cast<int>(count / largest * bar_width) : 0;
    const int low = static_cast<int>(i) * bin_deg;
    std::printf("  %3d-%3d %8.4f %% %s\n", low, low + bin_deg, 100 * count / all,
                std::string(static_cast<std::size_t>(length), '#').c_str());
  }
}

/// Said only when it explains a small angle: empty when the surface allows 30 degrees.
std::string forced_text(const ForcedDihedral& forced) {
  constexpr double worth_saying_deg = 30;
  if (forced.at_most_deg >= worth_saying_deg) return "";
  char text[200];
  std::snprintf(text, sizeof text,
                "                the surface forces at most %.3f deg, at (%.6g, %.6g, %.6g)\n",
                forced.at_most_deg, forced.at.x, forced.at.y, forced.at.z);
  return text;
}

void print_report(const MeshReport& report) {
  const ShapeStatistics& shapes = report.shapes;
  std::printf("tets            %lld\nnodes           %lld\nboundary        %lld triangles\n",
              static_cast<long long>(report.tets), static_cast<long long>(report.nodes),
              static_cast<long long>(report.boundary_triangles));
  std::printf("sub-domains     %d\nvolume          %.12g, enclosed %.12g\n", report.subdomains,
              report.volume, report.enclosed_volume);
  std::printf("dihedral        %.3f to %.3f deg; worst at (%.6g, %.6g, %.6g)\n",
              shapes.min_dihedral_deg, shapes.max_dihedral_deg, shapes.worst_centroid.x,
              shapes.worst_centroid.y, shapes.worst_centroid.z);
  std::fputs(forced_text(report.forced).c_str(), stdout);
  std::printf("radius ratio    %.4f mean, %.4f smallest\ndigest          %s\n",
              shapes.mean_radius_ratio(), shapes.min_radius_ratio, report.digest.hex().c_str());
  print_histogram(shapes);
}

}  // namespace

ExitCode quality_command(const QualityOptions& options) {
  const std::filesystem::path file = mesh_file(options.input);
  const MeshReport report = report_on(read_global_mesh(file));
  if (options.json) {
    std::printf("%s\n", report_json(report, file.string()).dump().c_str());
  } else {
    print_report(report);
  }
  if (report.complaints.empty()) return ExitCode::ok;
  std::string message = file.string() + ": not a valid mesh";
  for (const std::string& complaint : report.complaints) message += "\n  " + complaint;
  throw Error(ExitCode::gate, message);
}

}  // namespace tetfarm
