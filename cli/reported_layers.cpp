#include "cli/reported_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/array_index.h"
#include "base/error.h"
#include "base/file_system.h"
#include "cli/report_picture.h"
#include "mesh/inspect/vtp_triangles.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/layer_request.h"
#include "mesh/render/render_mesh.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending_of_layers = ".layers.vtp";
constexpr int picture_width = 960;
constexpr int picture_height = 640;

/// How much of the layers that were asked for a triangle has, from all to none.
constexpr std::array<Colour, 4> colours_of_shares = {
    {{0.55F, 0.77F, 0.53F}, {0.98F, 0.85F, 0.45F}, {0.93F, 0.55F, 0.28F}, {0.76F, 0.22F, 0.20F}}};
constexpr std::array<const char*, 4> names_of_shares = {"all", "half or more", "fewer", "none"};

const std::vector<double>& array_of(const NumberedTriangles& map, const char* name) {
  const auto found = map.arrays.find(name);
  if (found != map.arrays.end()) return found->second;
  throw InvalidInput("it has no array \"" + std::string(name) + "\"", "map of layers");
}

std::string name_of_reason(double number) {
  for (const StopReason reason : all_stop_reasons) {
    if (static_cast<double>(reason) == number) return name_of(reason);
  }
  return "unknown";
}

std::size_t share_class(double layers, double wanted) {
  if (layers >= wanted) return 0;
  if (layers <= 0) return 3;
  return 2 * layers >= wanted ? 1 : 2;
}

void count_triangles(const NumberedTriangles& map, ReportedLayers& reported) {
  const std::vector<double>& layers = array_of(map, "layers");
  const std::vector<double>& reasons = array_of(map, "reason");
  const std::vector<double>& heights = array_of(map, "first_height");
  const std::vector<double>& asked = array_of(map, "first_wanted");
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    if (reasons[t] == static_cast<double>(StopReason::complete)) {
      ++reported.full;
    } else {
      ++reported.by_reason[name_of_reason(reasons[t])];
    }
    const auto count =
        static_cast<std::size_t>(std::clamp(layers[t], 0.0, static_cast<double>(most_layers)));
    if (reported.by_layers.size() <= count) reported.by_layers.resize(count + 1);
    ++reported.by_layers[count];
    if (layers[t] > 0 && asked[t] > 0) reported.first_heights.add(heights[t] / asked[t]);
  }
}

void add_shapes(const wire::JobStatus& status, ReportedLayers& reported) {
  constexpr std::array<std::pair<const char*, const char*>, 5> figures = {
      {{"scaled Jacobian of prisms over that at the wall, least", "layers_min_scaled_jacobian"},
       {"that of all but 1 %", "layers_scaled_jacobian_1_percent"},
       {"median", "layers_scaled_jacobian_median"},
       {"height of the tet on a last prism over that of the prism, median",
        "layers_top_jump_median"},
       {"99 %", "layers_top_jump_99"}}};
  for (const auto& [name, number] : figures) {
    const auto found = status.numbers().find(number);
    if (found == status.numbers().end()) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", found->second);
    reported.shapes.push_back({name, text});
  }
}

RenderOptions options_for(View view) {
  RenderOptions options;
  options.view = view;
  options.width = picture_width;
  options.height = picture_height;
  return options;
}

ReportPicture coverage_picture(const NumberedTriangles& map, const Vec3& from, const char* side) {
  NumberedPart part;
  part.nodes = map.points;
  part.faces = map.triangles;
  const std::vector<double>& layers = array_of(map, "layers");
  const std::vector<double>& wanted = array_of(map, "wanted");
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    part.patch_of_face.push_back(static_cast<std::int32_t>(share_class(layers[t], wanted[t])));
  }
  RenderOptions options = options_for(View::surface);
  options.camera.from = from;
  options.colour_by = ColourBy::patch;
  options.patch_colours.assign(colours_of_shares.begin(), colours_of_shares.end());
  options.edge_width = 0.4;
  const std::vector<std::string> names(names_of_shares.begin(), names_of_shares.end());
  const auto visit_it = [&part](const auto& visit) { visit(part); };
  return {std::string("Layers on the wall ") + side +
              ": green all, yellow half or more of them, orange fewer, red none",
          png_of(render_mesh(visit_it, names, options))};
}

/// Where a plane through the middle of the wall meets it first, and how high the layers are there.
struct Nose {
  Vec3 place;
  double height = 0;
};

Nose nose_of(const NumberedTriangles& map, double y) {
  const std::vector<double>& heights = array_of(map, "total_height");
  Nose nose;
  for (std::size_t t = 0; t < map.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) { return map.points[at(map.triangles[t].at(k))]; };
    const auto [low, high] = std::minmax({corner(0).y, corner(1).y, corner(2).y});
    const Vec3 middle = (corner(0) + corner(1) + corner(2)) / 3;
    if (low > y || high < y || !(heights[t] > 0)) continue;
    if (nose.height == 0 || middle.x < nose.place.x) nose = {middle, heights[t]};
  }
  return nose;
}

std::vector<ReportPicture> slice_pictures(const NumberedTriangles& map, const MeshSource& mesh) {
  if (mesh.cell_marks().empty()) return {};
  Box3 wall;
  for (const Vec3& p : map.points) wall.add(p);
  RenderOptions options = options_for(View::slice);
  options.colour_by = ColourBy::layer;
  options.camera.from = {0, -1, 0};
  options.cut_at = wall.centre().y;
  const Nose nose = nose_of(map, *options.cut_at);
  if (nose.height == 0) return {};
  const auto draw = [&](const Vec3& centre, double across, const std::string& caption) {
    options.camera.centre = Vec3{centre.x, *options.cut_at, centre.z};
    options.camera.across = across;
    char text[120];
    std::snprintf(text, sizeof text, "%s, y = %.6g; the picture is %.4g wide", caption.c_str(),
                  *options.cut_at, across);
    return picture_of(mesh, options, text);
  };
  const double size = std::max(wall.high.x - wall.low.x, 1.5 * (wall.high.z - wall.low.z));
  return {draw(wall.centre(), 1.2 * size, "A plane through the wall"),
          draw(nose.place, 8 * nose.height, "The layers where it meets the wall first")};
}

}  // namespace

std::optional<std::string> layer_map_of(const fs::path& mesh_file) {
  for (fs::path stem = mesh_file.stem(); !stem.empty(); stem = stem.stem()) {
    const fs::path map = mesh_file.parent_path() / (stem.string() + std::string(ending_of_layers));
    if (fs::exists(map)) return read_file(map);
    if (stem == stem.stem()) break;
  }
  return std::nullopt;
}

std::optional<std::string> layer_map_of(const wire::JobStatus& status, const ViewOptions& view,
                                        const fs::path& scratch_folder) {
  const auto found = std::find_if(
      status.files().begin(), status.files().end(),
      [](const wire::Artifact& file) { return file.name().ends_with(ending_of_layers); });
  if (found == status.files().end()) return std::nullopt;
  return read_file(bring_file_of_job(status, *found, view, scratch_folder).file);
}

ReportedLayers reported_layers(std::string_view text, const MeshSource& mesh,
                               const wire::JobStatus* status) {
  const NumberedTriangles map = triangles_from_vtp(text, "map of layers");
  ReportedLayers reported;
  count_triangles(map, reported);
  if (status != nullptr) add_shapes(*status, reported);
  if (map.triangles.empty()) return reported;
  reported.pictures = {coverage_picture(map, {-1, -2, 1}, "from above"),
                       coverage_picture(map, {-1, -2, -1}, "from below")};
  for (ReportPicture& picture : slice_pictures(map, mesh)) {
    reported.pictures.push_back(std::move(picture));
  }
  return reported;
}

}  // namespace tetfarm
