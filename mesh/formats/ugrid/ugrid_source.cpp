#include "mesh/formats/ugrid/ugrid_source.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "mesh/formats/input_file.h"
#include "mesh/formats/listed_mesh.h"

namespace tetfarm {
namespace {

constexpr std::int64_t most_regions = 1'000'000;

struct RegionLine {
  std::int64_t number = 1;
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::string name;
};

std::vector<std::string> names_of_mapbc(const std::filesystem::path& path) {
  std::vector<std::string> names;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream words(line);
    long number = 0;
    long code = 0;
    std::string name;
    if (words >> number >> code && std::getline(words >> std::ws, name)) names.push_back(name);
  }
  return names;
}

std::vector<RegionLine> regions_beside(const std::filesystem::path& path, std::int64_t tets) {
  std::vector<RegionLine> regions;
  std::ifstream file(path);
  std::string line;
  std::int64_t expected = 1;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    RegionLine region;
    const bool is_whole = static_cast<bool>(words >> region.number >> region.first >> region.last);
    if (!is_whole || region.number < 1 || region.number > most_regions ||
        region.first != expected || region.last + 1 < region.first || region.last > tets) {
      throw InvalidInput("a line does not match the mesh: " + line, path.string());
    }
    std::getline(words >> std::ws, region.name);
    expected = region.last + 1;
    regions.push_back(region);
  }
  if (!regions.empty() && expected != tets + 1) {
    throw InvalidInput("the lines do not cover all tets", path.string());
  }
  return regions;
}

/// A file beside the mesh: NAME.mapbc beside NAME.b8.ugrid.
std::filesystem::path beside(const std::filesystem::path& path, const std::string& ending) {
  return std::filesystem::path(path).replace_extension().replace_extension().string() + ending;
}

/// The file with its counts, and where its lists begin.
template <class Integer>
class Ugrid {
 public:
  Ugrid(const std::filesystem::path& path, bool big_endian) : file_(path), turned_(big_endian) {
    std::array<Integer, 7> counts{};
    read(0, std::span(counts));
    // A list of so many would not fit in a file: sums below cannot overflow.
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 256;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto place = static_cast<std::int64_t>(i * sizeof(Integer));
      if (counts[i] < 0) file_.fail("a count is negative", place);
      if (counts[i] > most) file_.fail("a count is larger than the file", place);
    }
    if (counts[2] + counts[4] + counts[5] + counts[6] != 0) {
      file_.fail("has elements other than triangles and tets", 0);
    }
    nodes = counts[0];
    triangles = counts[1];
    tets = counts[3];
    if (tet_place(tets) != file_.size()) {
      throw InvalidInput("the length of the file does not match its counts", file_.name());
    }
  }

  void read_nodes(std::int64_t first, std::span<Vec3> into) const {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    read(header_bytes + first * 24, std::span(&into.data()->x, 3 * into.size()));
  }
  void read_tets(std::int64_t first, std::span<ListedMesh::Nodes> into) const {
    std::vector<Integer> numbers(4 * into.size());
    read(tet_place(first), std::span(numbers));
    for (std::size_t i = 0; i < numbers.size(); ++i) into[i / 4][i % 4] = numbers[i] - 1;
  }
  /// Normals in the file all point into the domain or all out of it.
  std::vector<ListedTriangle> boundary() const {
    const auto count = static_cast<std::size_t>(triangles);
    std::vector<Integer> numbers(3 * count);
    read(triangle_place(), std::span(numbers));
    std::vector<Integer> patches(count);
    read(triangle_place() + triangles * 3 * integer_bytes, std::span(patches));
    std::vector<ListedTriangle> boundary(count);
    double volume = 0;
    for (std::size_t t = 0; t < count; ++t) {
      std::array<Vec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t node = boundary[t].nodes[k] = numbers[3 * t + k] - std::int64_t{1};
        if (node < 0 || node >= nodes) {
          file_.fail("boundary triangle " + std::to_string(t) + " has node " +
                         std::to_string(node + 1) + " of " + std::to_string(nodes),
                     triangle_place() + static_cast<std::int64_t>(3 * t + k) * integer_bytes);
        }
        read_nodes(node, std::span(&p[k], 1));
      }
      volume += dot(p[0], cross(p[1], p[2]));
      boundary[t].patch = static_cast<std::int32_t>(
          std::clamp<std::int64_t>(patches[t], 0, std::numeric_limits<std::int32_t>::max()) - 1);
    }
    for (ListedTriangle& triangle : boundary) {
      if (volume < 0) std::swap(triangle.nodes[1], triangle.nodes[2]);
    }
    return boundary;
  }
  const std::string& name() const { return file_.name(); }

  std::int64_t nodes = 0;
  std::int64_t triangles = 0;
  std::int64_t tets = 0;

 private:
  static constexpr std::int64_t integer_bytes = sizeof(Integer);
  static constexpr std::int64_t header_bytes = 7 * integer_bytes;

  std::int64_t triangle_place() const { return header_bytes + nodes * 24; }
  std::int64_t tet_place(std::int64_t tet) const {
    return triangle_place() + (triangles + tet) * 4 * integer_bytes;
  }
  template <class Number, std::size_t extent>
  void read(std::int64_t place, std::span<Number, extent> into) const {
    file_.read(place, into.data(), into.size_bytes());
    if (turned_) turn_bytes(std::span<Number>(into));
  }

  InputFile file_;
  bool turned_;
};

template <class Integer>
std::unique_ptr<MeshSource> open(const std::filesystem::path& path, bool big_endian,
                                 std::int64_t tets_of_piece) {
  const auto file = std::make_shared<const Ugrid<Integer>>(path, big_endian);
  ListedMesh mesh;
  mesh.name = file->name();
  mesh.nodes = file->nodes;
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_nodes(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    file->read_tets(first, into);
  };
  mesh.triangles = file->boundary();
  mesh.patch_names = names_of_mapbc(beside(path, ".mapbc"));
  std::vector<RegionLine> regions = regions_beside(beside(path, ".regions"), file->tets);
  if (regions.empty()) regions = {{1, 1, file->tets, "domain"}};
  for (const RegionLine& region : regions) {
    const auto number = static_cast<std::size_t>(region.number);
    mesh.region_names.resize(std::max(mesh.region_names.size(), number));
    mesh.region_names[number - 1] = region.name;
    add_tets(mesh.runs, {region.last + 1 - region.first, static_cast<std::int32_t>(number), 0});
  }
  return open_listed(std::move(mesh), tets_of_piece);
}

}  // namespace

std::unique_ptr<MeshSource> open_ugrid(const std::filesystem::path& path, UgridLayout layout,
                                       std::int64_t tets_of_piece) {
  return layout.wide ? open<std::int64_t>(path, layout.big_endian, tets_of_piece)
                     : open<std::int32_t>(path, layout.big_endian, tets_of_piece);
}

}  // namespace tetfarm
