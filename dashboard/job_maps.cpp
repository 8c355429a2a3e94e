#include "dashboard/job_maps.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "dashboard/shown_surface.h"
#include "dashboard/surface_answers.h"
#include "json/json_line.h"
#include "mesh/inspect/vtp_triangles.h"

namespace tetfarm {
namespace {

using MapJson = nlohmann::ordered_json;

constexpr std::size_t most_maps = 16;
constexpr std::uint64_t longest_legend = 16 * 1024;
constexpr std::size_t most_meanings = 256;
/// Files never change: what is made of one need not be made again.
constexpr FetchTime map_for_good{std::int64_t{1} << 60U, 0};

/// What a file is a map of, by the end of its name, and which of its arrays is shown.
struct KindOfMap {
  std::string_view ending;
  const char* word = "";
  const char* array = "";
};
constexpr std::array<KindOfMap, 2> kinds_of_maps = {
    {{".defects.vtp", "defects", "defect"}, {".layers.vtp", "layers", "layers"}}};

struct JobMap {
  wire::Artifact file;
  KindOfMap kind;
};

/// In the order of the job's files.
std::vector<JobMap> maps_of(const std::string& job, FarmSource& source) {
  const wire::StatusReply reply = source.job(job);
  if (reply.jobs_size() != 1) throw Error(ExitCode::not_found, "no job " + job);
  std::vector<JobMap> maps;
  for (const wire::Artifact& file : reply.jobs(0).files()) {
    for (const KindOfMap& kind : kinds_of_maps) {
      if (file.name().ends_with(kind.ending) && maps.size() < most_maps) {
        maps.push_back({file, kind});
      }
    }
  }
  return maps;
}

/// What its numbers mean, from the comments "<!-- defect 0: open edge -->" at its beginning.
std::vector<std::string> meanings_of(std::string_view text, const std::string& array) {
  std::vector<std::string> meanings;
  while (meanings.size() < most_meanings) {
    const std::string begin = "<!-- " + array + " " + std::to_string(meanings.size()) + ": ";
    const std::size_t found = text.find(begin);
    if (found == std::string_view::npos) return meanings;
    text.remove_prefix(found + begin.size());
    const std::size_t end = text.find(" -->");
    if (end == std::string_view::npos) return meanings;
    meanings.emplace_back(text.substr(0, end));
  }
  return meanings;
}

std::string read_map(const JobMap& map, FarmSource& source) {
  const std::string name(map.file.name());
  if (!source.sees_files()) {
    throw Error(ExitCode::not_found, "the dashboard does not see the store: start it with --store");
  }
  if (map.file.size() > largest_shown_file) {
    throw Error(ExitCode::out_of_resources, name + " is too large to be drawn");
  }
  const std::optional<std::filesystem::path> path = source.find_file(map.file);
  if (!path) throw Error(ExitCode::not_found, name + " is no longer in the store");
  return read_part_of_file(*path, 0, map.file.size());
}

/// The numbers on the triangles, as the pieces that they are of.
std::vector<std::int32_t> numbers_of(const NumberedTriangles& map, const char* array,
                                     const std::string& name) {
  constexpr double most = 1e9;
  const auto found = map.arrays.find(array);
  if (found == map.arrays.end()) {
    throw CorruptFile("has no array \"" + std::string(array) + "\"", name);
  }
  std::vector<std::int32_t> numbers;
  numbers.reserve(found->second.size());
  for (const double value : found->second) {
    if (!(value >= 0 && value <= most) || value != std::floor(value)) {
      throw CorruptFile("has a number that is no whole one from 0", name);
    }
    numbers.push_back(static_cast<std::int32_t>(value));
  }
  TF_CHECK(numbers.size() == map.triangles.size());
  return numbers;
}

}  // namespace

std::string JobMaps::list(const std::string& job, FarmSource& source) const {
  MapJson maps = MapJson::array();
  for (const JobMap& map : maps_of(job, source)) {
    const std::optional<std::filesystem::path> path = source.find_file(map.file);
    const std::string head = path ? read_part_of_file(*path, 0, longest_legend) : std::string();
    maps.push_back({{"map", maps.size() + 1},
                    {"file", map.file.name()},
                    {"of", map.kind.word},
                    {"meanings", meanings_of(head, map.kind.array)},
                    {"hash", map.file.hash()},
                    {"bytes", map.file.size()},
                    {"is_there", path.has_value() && map.file.size() <= largest_shown_file}});
  }
  return json_line({{"sees_files", source.sees_files()}, {"maps", maps}});
}

ApiAnswer JobMaps::map(const ApiRequest& request, FarmSource& source) {
  TF_CHECK(request.number > 0 && request.triangles > 0 &&
           request.triangles <= most_shown_triangles);
  const std::vector<JobMap> maps = maps_of(request.job, source);
  if (request.number > maps.size()) {
    throw Error(ExitCode::not_found, request.job + " has no map " + std::to_string(request.number));
  }
  const JobMap& map = maps[at(request.number - 1)];
  const std::string name = map.file.hash() + " " + std::to_string(request.triangles);
  if (const auto* made = maps_.find(name, 0)) return {200, made->thing, ApiForm::bytes};
  NumberedTriangles read = triangles_from_vtp(read_map(map, source), map.file.name());
  const std::vector<std::int32_t> numbers = numbers_of(read, map.kind.array, map.file.name());
  Subdomain shown;
  shown.vertices = std::move(read.points);
  shown.triangles = std::move(read.triangles);
  auto bytes = std::make_shared<const std::string>(
      shown_surface(shown, numbers, request.triangles, map.file.name()));
  maps_.keep({name, map_for_good, bytes->size(), bytes});
  return {200, bytes, ApiForm::bytes};
}

}  // namespace tetfarm
