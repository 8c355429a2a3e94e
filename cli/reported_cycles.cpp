#include "cli/reported_cycles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/file_system.h"
#include "base/work_stage.h"
#include "cli/node_field.h"
#include "cli/text_table.h"
#include "mesh/formats/plane/plane_files.h"
#include "mesh/formats/plane/plane_sides.h"
#include "mesh/render/crowded_window.h"
#include "mesh/render/patch_curve.h"
#include "mesh/render/plane_picture.h"
#include "report/line_chart.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr double picture_shape = 4.0 / 3;  // width over height

/// The name of its files without their endings: "…/cycle_03".
struct Cycle {
  std::int64_t number = 0;
  std::string stem;
};

/// 3 of "cycle_03.mesh"; 0 of any other name.
std::int64_t number_of_mesh(const fs::path& file) {
  const std::string name = file.filename().string();
  constexpr std::string_view before = "cycle_";
  constexpr std::string_view behind = ".mesh";
  if (!name.starts_with(before) || !name.ends_with(behind)) return 0;
  const std::string digits =
      name.substr(before.size(), name.size() - before.size() - behind.size());
  std::int64_t number = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_whole = read.ec == std::errc{} && read.ptr == digits.data() + digits.size();
  return is_whole && number > 0 ? number : 0;
}

std::vector<Cycle> cycles_in(const fs::path& folder) {
  std::vector<Cycle> cycles;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::int64_t number = number_of_mesh(entry.path());
    if (number == 0 || !entry.is_regular_file()) continue;
    cycles.push_back({number, fs::path(entry.path()).replace_extension().string()});
  }
  std::sort(cycles.begin(), cycles.end(),
            [](const Cycle& a, const Cycle& b) { return a.number < b.number; });
  return cycles;
}

std::vector<Cycle> shown_of(const std::vector<Cycle>& all) {
  if (all.size() <= most_shown_cycles) return all;
  std::vector<Cycle> shown;
  for (std::size_t i = 0; i < most_shown_cycles; ++i) {
    shown.push_back(all[i * (all.size() - 1) / (most_shown_cycles - 1)]);
  }
  return shown;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, comma - begin));
    if (comma == line.size()) return cells;
    begin = comma + 1;
  }
}

void read_table(const fs::path& file, CyclesContent& content) {
  std::istringstream lines(read_file(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::vector<std::string> cells = cells_of(line);
    if (number == 1) {
      content.head = std::move(cells);
      for (std::string& name : content.head) std::replace(name.begin(), name.end(), '_', ' ');
    } else if (cells.size() == content.head.size()) {
      content.rows.push_back(std::move(cells));
    } else {
      throw InvalidInput("has " + std::to_string(cells.size()) + " cells where the head has " +
                             std::to_string(content.head.size()),
                         file.string() + ":" + std::to_string(number));
    }
  }
}

PlaneMesh mesh_of(const Cycle& cycle) {
  PlaneMesh mesh = read_plane_mesh(cycle.stem + ".mesh");
  require_nodes_of_mesh(mesh);
  if (mesh.points.empty()) throw InvalidInput("has no vertices", cycle.stem + ".mesh");
  return mesh;
}

std::vector<double> first_field_of(const Cycle& cycle, const PlaneMesh& mesh) {
  return node_field(cycle.stem + ".sol", 1, mesh.points.size(), "the mesh");
}

/// The last line that is not empty, of the end of the log.
std::string last_words_of(const Cycle& cycle) {
  constexpr std::streamoff looked_at = 4096;
  std::ifstream log(cycle.stem + ".log", std::ios::binary | std::ios::ate);
  if (!log) return {};
  log.seekg(std::max<std::streamoff>(0, log.tellg() - looked_at));
  std::string line;
  std::string last;
  while (std::getline(log, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last.empty() ? last : harmless(last, 400);
}

/// What the flow goes round: the patches that bound holes alone.
std::vector<std::int32_t> walls_of(const PlaneMesh& mesh) {
  const PlaneSides sides = sides_of(mesh);
  const std::vector<PlanePatch> patches = border_patches(mesh, sides);
  const std::vector<bool> are_walls = bound_holes(mesh, sides, patches);
  std::vector<std::int32_t> walls;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (are_walls[i]) walls.push_back(patches[i].number);
  }
  return walls;
}

/// What all pictures have in common.
PlanePictureOptions options_for(const std::vector<Cycle>& cycles, int picture_width) {
  PlanePictureOptions options;
  options.width = picture_width;
  options.height = static_cast<int>(picture_width / picture_shape);
  std::array<double, 2> range = {};
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const PlaneMesh mesh = mesh_of(cycles[i]);
    const std::vector<double> field = first_field_of(cycles[i], mesh);
    const auto [low, high] = std::minmax_element(field.begin(), field.end());
    range = i == 0 ? std::array<double, 2>{*low, *high}
                   : std::array<double, 2>{std::min(range[0], *low), std::max(range[1], *high)};
    if (i + 1 == cycles.size()) {
      options.window = crowded_window(mesh.points, picture_shape);
    }
  }
  if (range[0] < range[1]) options.range = range;
  return options;
}

void add_to_chart(LineChart& chart, const Cycle& cycle, const PlaneMesh& mesh,
                  const std::vector<double>& field) {
  const std::vector<std::int32_t> walls = walls_of(mesh);
  if (walls.empty()) return;
  const std::string colour = chart_colours.at(chart.curves.size());
  chart.curves.push_back(
      {"cycle " + std::to_string(cycle.number), colour, values_over_x(mesh, field, walls)});
}

ReportPicture drawn(const PlaneMesh& mesh, std::span<const double> field,
                    PlanePictureOptions options, const std::string& caption) {
  if (!field.empty()) options.edge_width = 0;
  return {caption, png_of(plane_picture(mesh, {field, {}}, options))};
}

}  // namespace

bool is_loop_folder(const fs::path& folder) {
  return fs::is_regular_file(folder / "cycles.csv") && !cycles_in(folder).empty();
}

CyclesContent reported_cycles(const fs::path& folder, int picture_width) {
  static_assert(most_shown_cycles <= chart_colours.size());
  CyclesContent content;
  content.name = fs::absolute(folder / ".").lexically_normal().parent_path().filename().string();
  read_table(folder / "cycles.csv", content);
  const std::vector<Cycle> all = cycles_in(folder);
  const std::vector<Cycle> shown = shown_of(all);
  content.cycles = std::ssize(all);
  const PlanePictureOptions options = options_for(shown, picture_width);
  LineChart chart;
  chart.x_name = "x";
  chart.y_name = "first field";
  for (const Cycle& cycle : shown) {
    const PlaneMesh mesh = mesh_of(cycle);
    const std::vector<double> field = first_field_of(cycle, mesh);
    const std::string name = "Cycle " + std::to_string(cycle.number);
    add_to_chart(chart, cycle, mesh, field);
    content.shown.push_back({cycle.number,
                             drawn(mesh, {}, options,
                                   name + ": " + grouped_count(mesh.points.size()) + " vertices, " +
                                       grouped_count(mesh.triangles.size()) + " triangles"),
                             drawn(mesh, field, options, name), last_words_of(cycle)});
  }
  if (!chart.curves.empty()) content.chart = svg_file_of(chart);
  return content;
}

}  // namespace tetfarm
