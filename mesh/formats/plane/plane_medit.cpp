#include "mesh/formats/plane/plane_medit.h"

#include <array>
#include <limits>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/plane/text_lines.h"

namespace tetfarm {
namespace {

constexpr std::string_view text_start = "MeshVersionFormatted";

std::int32_t small(InputScanner& in, std::string_view what) {
  const std::int64_t value = in.integer(what);
  if (value < std::numeric_limits<std::int32_t>::min() ||
      value > std::numeric_limits<std::int32_t>::max()) {
    in.fail(std::string(what) + " is too large");
  }
  return static_cast<std::int32_t>(value);
}

class MeshReader {
 public:
  MeshReader(std::string_view bytes, const std::string& name) : in_(bytes, name, '#') {
    mesh_.name = name;
  }

  PlaneMesh read() {
    in_.expect(text_start);
    in_.integer("the version");
    in_.expect("Dimension");
    dimension_ = in_.integer("the dimension");
    if (dimension_ != 2 && dimension_ != 3) in_.fail("the dimension is neither 2 nor 3");
    while (!in_.at_end()) {
      const std::string_view word = in_.word();
      if (word == "End") break;
      if (word == "Vertices") read_vertices();
      if (word == "Edges") read_edges();
      if (word == "Triangles") read_triangles();
      if (word == "Corners") read_corners();
      if (word == "Quadrilaterals" || word == "Tetrahedra") {
        if (list_length(1) > 0) in_.fail("only triangles and edges can be adapted");
      }
      // Numbers and the names of other lists are passed over, word by word.
    }
    if (mesh_.points.empty()) in_.fail("the file has no vertices");
    if (mesh_.triangles.empty()) in_.fail("the file has no triangles");
    return std::move(mesh_);
  }

 private:
  /// Each number of a record takes two bytes at least.
  std::size_t list_length(std::size_t numbers) {
    return in_.to_count(in_.integer("the length of a list"), 2 * numbers - 1);
  }

  void read_vertices() {
    const std::size_t count = list_length(3);
    mesh_.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = in_.coordinate();
      mesh_.points.push_back({x, in_.coordinate()});
      if (dimension_ == 3) check_height(in_.coordinate());
      in_.integer("a reference");
    }
  }

  void check_height(double z) {
    if (mesh_.points.size() == 1) height_ = z;
    if (z != height_) in_.fail("the vertices do not lie in one plane z = constant");
  }

  std::int32_t node() {
    const std::int32_t number = small(in_, "a vertex number");
    if (number < 1) in_.fail("vertices are numbered from 1");
    return number - 1;
  }

  void read_edges() {
    const std::size_t count = list_length(3);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t a = node();
      mesh_.edges.push_back({a, node()});
      mesh_.patches.push_back(small(in_, "a reference"));
    }
  }

  void read_triangles() {
    const std::size_t count = list_length(4);
    mesh_.triangles.reserve(count);
    mesh_.regions.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t a = node();
      const std::int32_t b = node();
      mesh_.triangles.push_back({a, b, node()});
      mesh_.regions.push_back(small(in_, "a reference"));
    }
  }

  void read_corners() {
    const std::size_t count = list_length(1);
    for (std::size_t i = 0; i < count; ++i) mesh_.corners.push_back(node());
  }

  InputScanner in_;
  std::int64_t dimension_ = 2;
  double height_ = 0;
  PlaneMesh mesh_;
};

/// The name of a list, and how long it is.
void begin_list(TextLines& lines, std::string_view name, std::size_t count) {
  lines.words("\n").words(name).words("\n").number(count).end();
}

/// Of every field.
std::size_t node_count(const NodeFields& fields) {
  TF_CHECK(!fields.order.empty());
  TF_CHECK(fields.order.size() ==
           fields.scalars.size() + fields.vectors.size() + fields.metrics.size());
  const std::size_t nodes = !fields.scalars.empty()   ? fields.scalars.front().size()
                            : !fields.vectors.empty() ? fields.vectors.front().size()
                                                      : fields.metrics.front().size();
  for (const auto& field : fields.scalars) TF_CHECK(field.size() == nodes);
  for (const auto& field : fields.vectors) TF_CHECK(field.size() == nodes);
  for (const auto& field : fields.metrics) TF_CHECK(field.size() == nodes);
  return nodes;
}

}  // namespace

PlaneMesh read_plane_medit(std::string_view bytes, const std::string& name) {
  return MeshReader(bytes, name).read();
}

PlaneMesh read_plane_medit(const std::filesystem::path& path) {
  return read_plane_medit(read_whole_file(path.string()), path.string());
}

std::string medit_text(const PlaneMesh& mesh) {
  TF_CHECK(mesh.patches.size() == mesh.edges.size());
  TF_CHECK(mesh.regions.size() == mesh.triangles.size());
  TextLines lines(60 * mesh.points.size() + 30 * mesh.triangles.size() + 1000);
  lines.words("MeshVersionFormatted 2\n\nDimension 2\n");
  begin_list(lines, "Vertices", mesh.points.size());
  for (const Vec2& p : mesh.points) lines.number(p.x).number(p.y).number(0).end();
  begin_list(lines, "Edges", mesh.edges.size());
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto [a, b] = mesh.edges[k];
    lines.number(a + 1).number(b + 1).number(mesh.patches[k]).end();
  }
  begin_list(lines, "Triangles", mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t v : mesh.triangles[t]) lines.number(v + 1);
    lines.number(mesh.regions[t]).end();
  }
  begin_list(lines, "Corners", mesh.corners.size());
  for (const std::int32_t v : mesh.corners) lines.number(v + 1).end();
  lines.words("\nEnd\n");
  return lines.take();
}

void write_plane_medit(const PlaneMesh& mesh, const std::filesystem::path& path) {
  write_file_atomically(path, medit_text(mesh));
}

NodeFields read_plane_sol(const std::filesystem::path& path) {
  return read_plane_sol(read_whole_file(path.string()), path.string());
}

NodeFields read_plane_sol(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name, '#');
  in.expect(text_start);
  in.integer("the version");
  in.expect("Dimension");
  if (in.integer("the dimension") != 2) in.fail("the fields are not those of a plane mesh");
  in.expect("SolAtVertices");
  const std::size_t nodes = in.to_count(in.integer("the number of nodes"), 2);
  const std::size_t count = in.to_count(in.integer("the number of fields"), 2);
  NodeFields fields;
  for (std::size_t k = 0; k < count; ++k) {
    const std::int64_t kind = in.integer("the kind of a field");
    if (kind < 1 || kind > 3) {
      in.fail("a field is a number (1), a vector (2) or a symmetric tensor (3)");
    }
    fields.order.push_back(static_cast<NodeFieldKind>(kind));
    if (kind == 1) fields.scalars.emplace_back().reserve(nodes);
    if (kind == 2) fields.vectors.emplace_back().reserve(nodes);
    if (kind == 3) fields.metrics.emplace_back().reserve(nodes);
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    std::array<std::size_t, 4> next_of_kind{};
    for (const NodeFieldKind kind : fields.order) {
      const std::size_t k = next_of_kind[static_cast<std::size_t>(kind)]++;
      const double first = in.coordinate();
      if (kind == NodeFieldKind::scalar) fields.scalars[k].push_back(first);
      if (kind == NodeFieldKind::vector) fields.vectors[k].push_back({first, in.coordinate()});
      if (kind == NodeFieldKind::metric) {
        const double xy = in.coordinate();
        fields.metrics[k].push_back({first, xy, in.coordinate()});
      }
    }
  }
  return fields;
}

void write_plane_sol(std::span<const Metric2> metrics, const std::filesystem::path& path) {
  NodeFields fields;
  fields.order = {NodeFieldKind::metric};
  fields.metrics.emplace_back(metrics.begin(), metrics.end());
  write_plane_sol(fields, path);
}

void write_plane_sol(const NodeFields& fields, const std::filesystem::path& path) {
  write_file_atomically(path, sol_text(fields));
}

std::string sol_text(const NodeFields& fields) {
  const std::size_t nodes = node_count(fields);
  TextLines lines(25 * nodes * fields.order.size() * 3 + 200);
  lines.words("MeshVersionFormatted 2\n\nDimension 2\n");
  begin_list(lines, "SolAtVertices", nodes);
  lines.number(fields.order.size());
  for (const NodeFieldKind kind : fields.order) lines.number(static_cast<int>(kind));
  lines.end();
  for (std::size_t i = 0; i < nodes; ++i) {
    std::array<std::size_t, 4> next_of_kind{};
    for (const NodeFieldKind kind : fields.order) {
      const std::size_t k = next_of_kind[static_cast<std::size_t>(kind)]++;
      if (kind == NodeFieldKind::scalar) lines.number(fields.scalars[k][i]);
      if (kind == NodeFieldKind::vector) {
        lines.number(fields.vectors[k][i].x).number(fields.vectors[k][i].y);
      }
      if (kind == NodeFieldKind::metric) {
        const Metric2& m = fields.metrics[k][i];
        lines.number(m.xx).number(m.xy).number(m.yy);
      }
    }
    lines.end();
  }
  lines.words("\nEnd\n");
  return lines.take();
}

}  // namespace tetfarm
