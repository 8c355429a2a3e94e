#include "mesh/formats/plane/plane_meshb.h"

#include <limits>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/medit/medit_file.h"
#include "mesh/formats/number_text.h"

namespace tetfarm {
namespace {

constexpr std::int32_t own_byte_order = 1;
constexpr std::int32_t gmf_version = 3;
constexpr std::int64_t integer_bytes = 4;

/// @throws InvalidInput when a number of a record has more than 32 bits.
std::int32_t small_of(const MeditFile& file, medit::Keyword list, std::size_t record,
                      std::int64_t number) {
  if (number < std::numeric_limits<std::int32_t>::min() ||
      number > std::numeric_limits<std::int32_t>::max()) {
    file.fail_at(list, static_cast<std::int64_t>(record),
                 "the number " + std::to_string(number) + " is too large");
  }
  return static_cast<std::int32_t>(number);
}

/// A vertex, counted from 0.
std::int32_t vertex_in(const MeditFile& file, medit::Keyword list, std::size_t record,
                       std::int64_t number) {
  const std::int64_t vertices = file.count(medit::vertices);
  if (number < 1 || number > vertices) {
    file.fail_at(list, static_cast<std::int64_t>(record),
                 "there is no vertex " + std::to_string(number) + "; the file has " +
                     std::to_string(vertices));
  }
  return small_of(file, list, record, number - 1);
}

void read_points(const MeditFile& file, PlaneMesh& mesh) {
  std::vector<Vec3> points(at(file.count(medit::vertices)));
  file.read_vertices(0, points);
  mesh.points.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].z != points[0].z) {
      file.fail_at(medit::vertices, static_cast<std::int64_t>(i),
                   "the vertices do not lie in one plane z = constant");
    }
    mesh.points.push_back({points[i].x, points[i].y});
  }
}

/// The nodes of the elements of a list, and their references.
template <std::size_t N>
void read_list(const MeditFile& file, medit::Keyword list,
               std::vector<std::array<std::int32_t, N>>& elements,
               std::vector<std::int32_t>& references) {
  std::vector<std::array<std::int64_t, N + 1>> records(at(file.count(list)));
  file.read_elements<N + 1>(list, 0, records);
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::array<std::int32_t, N> nodes{};
    for (std::size_t k = 0; k < N; ++k) nodes[k] = vertex_in(file, list, i, records[i][k]);
    elements.push_back(nodes);
    references.push_back(small_of(file, list, i, records[i][N]));
  }
}

void refuse_other_elements(const MeditFile& file) {
  for (const medit::Keyword list :
       {medit::quadrangles, medit::tetrahedra, medit::pyramids, medit::prisms, medit::hexahedra}) {
    if (file.count(list) > 0) file.fail_at(list, "only triangles and edges can be adapted");
  }
}

/// A file in the making: lists one after the other.
class BinaryLists {
 public:
  BinaryLists() {
    bytes_.small(own_byte_order);
    bytes_.small(gmf_version);
    bytes_.small(medit::dimension);
    bytes_.integer(bytes_.size() + 8 + integer_bytes);
    bytes_.small(2);
  }
  /// `extra_bytes` are those of the head behind the count.
  void begin(medit::Keyword list, std::size_t count, std::int64_t record_bytes,
             std::int64_t extra_bytes = 0) {
    constexpr std::int64_t head = integer_bytes + 8 + integer_bytes;
    const auto records = static_cast<std::int64_t>(count);
    bytes_.small(list);
    bytes_.integer(bytes_.size() + head - integer_bytes + extra_bytes + records * record_bytes);
    bytes_.small(static_cast<std::int32_t>(count));
  }
  NumberText& numbers() { return bytes_; }
  void write(const std::filesystem::path& path) {
    bytes_.small(medit::end);
    bytes_.integer(0);
    write_file_atomically(path, bytes_.bytes());
  }

 private:
  NumberText bytes_ = NumberText::raw();
};

template <std::size_t N>
void write_list(BinaryLists& lists, medit::Keyword list,
                const std::vector<std::array<std::int32_t, N>>& elements,
                const std::vector<std::int32_t>& references) {
  TF_CHECK(elements.size() == references.size());
  lists.begin(list, elements.size(), integer_bytes * static_cast<std::int64_t>(N + 1));
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const std::int32_t v : elements[i]) lists.numbers().small(v + 1);
    lists.numbers().small(references[i]);
  }
}

}  // namespace

PlaneMesh read_plane_meshb(std::string_view bytes, const std::string& name) {
  const MeditFile file(bytes, name, medit::World::plane);
  if (file.count(medit::vertices) == 0) throw InvalidInput("the file has no vertices", name);
  if (file.count(medit::triangles) == 0) throw InvalidInput("the file has no triangles", name);
  refuse_other_elements(file);
  PlaneMesh mesh;
  mesh.name = name;
  read_points(file, mesh);
  read_list(file, medit::edges, mesh.edges, mesh.patches);
  read_list(file, medit::triangles, mesh.triangles, mesh.regions);
  std::vector<std::int64_t> corners(at(file.count(medit::corners)));
  file.read_numbers(medit::corners, 0, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.corners.push_back(vertex_in(file, medit::corners, i, corners[i]));
  }
  return mesh;
}

void write_plane_meshb(const PlaneMesh& mesh, const std::filesystem::path& path) {
  BinaryLists lists;
  lists.begin(medit::vertices, mesh.points.size(), 16 + integer_bytes);
  for (const Vec2& p : mesh.points) {
    lists.numbers().real(p.x);
    lists.numbers().real(p.y);
    lists.numbers().small(0);
  }
  write_list(lists, medit::edges, mesh.edges, mesh.patches);
  write_list(lists, medit::triangles, mesh.triangles, mesh.regions);
  lists.begin(medit::corners, mesh.corners.size(), integer_bytes);
  for (const std::int32_t v : mesh.corners) lists.numbers().small(v + 1);
  lists.write(path);
}

NodeFields read_plane_solb(std::string_view bytes, const std::string& name) {
  const MeditFile file(bytes, name, medit::World::plane);
  const std::vector<std::int64_t>& kinds = file.kinds_of_fields();
  if (kinds.empty()) throw InvalidInput("the file has no fields at vertices", name);
  std::size_t reals = 0;
  NodeFields fields;
  for (const std::int64_t kind : kinds) {
    reals += at(kind);
    if (kind == 1) fields.scalars.emplace_back();
    if (kind == 2) fields.vectors.emplace_back();
    if (kind == 3) fields.metrics.emplace_back();
  }
  std::vector<double> record(reals);
  for (std::int64_t i = 0; i < file.count(medit::fields_at_vertices); ++i) {
    file.read_fields(i, record);
    std::array<std::size_t, 4> next_of_kind{};
    const double* next = record.data();
    for (const std::int64_t kind : kinds) {
      const std::size_t k = next_of_kind[at(kind)]++;
      if (kind == 1) fields.scalars[k].push_back(next[0]);
      if (kind == 2) fields.vectors[k].push_back({next[0], next[1]});
      if (kind == 3) fields.metrics[k].push_back({next[0], next[1], next[2]});
      next += kind;
    }
  }
  return fields;
}

void write_plane_solb(std::span<const Metric2> metrics, const std::filesystem::path& path) {
  BinaryLists lists;
  lists.begin(medit::fields_at_vertices, metrics.size(), 3 * 8, 2 * integer_bytes);
  lists.numbers().small(1);
  lists.numbers().small(3);
  for (const Metric2& m : metrics) {
    for (const double value : {m.xx, m.xy, m.yy}) lists.numbers().real(value);
  }
  lists.write(path);
}

NodeFields read_plane_fields(const std::filesystem::path& path) {
  if (path.extension() != ".solb") return read_plane_sol(path);
  return read_plane_solb(read_whole_file(path.string()), path.string());
}

}  // namespace tetfarm
