#include "mesh/formats/plane/plane_su2.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/array_index.h"
#include "base/file_system.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/plane/plane_sides.h"
#include "mesh/formats/plane/text_lines.h"
#include "mesh/formats/su2/su2_walker.h"

namespace tetfarm {
namespace {

constexpr int plane = 2;
constexpr std::int64_t su2_vertex = 1;

/// Whether an element of that type is read: triangles, and lines in markers. Single vertices in
/// markers are passed over, all else fails.
bool is_wanted(Su2List list, std::int64_t type, const InputScanner& in) {
  if (list == Su2List::elements && type != su2_triangle) {
    in.fail("element type " + std::to_string(type) +
            (type == 9 ? " is a quadrilateral" : " is no triangle") +
            ": only triangles (5) are read");
  }
  if (list == Su2List::marker && type != su2_line && type != su2_vertex) {
    in.fail("element type " + std::to_string(type) + " in a marker is no line (3)");
  }
  return type != su2_vertex;
}

class PlaneContent : public Su2Content {
 public:
  explicit PlaneContent(const InputScanner& in) : in_(in) {}

  void add_node(const Vec3& p) override {
    if (mesh_.points.size() == std::numeric_limits<std::int32_t>::max()) in_.fail("too many nodes");
    mesh_.points.push_back({p.x, p.y});
  }
  void begin_marker(std::string_view name) override { patch_ = names_.number_of(name) + 1; }
  bool wants(Su2List list, std::int64_t type, const InputScanner& in) override {
    return is_wanted(list, type, in);
  }
  void add_element(Su2List list, std::int64_t, std::span<const std::int64_t> nodes) override {
    if (list == Su2List::elements) {
      mesh_.triangles.push_back({node(nodes[0]), node(nodes[1]), node(nodes[2])});
    } else {
      mesh_.edges.push_back({node(nodes[0]), node(nodes[1])});
      mesh_.patches.push_back(patch_);
    }
  }

  /// The largest number of a node that an element has.
  std::int32_t last_node() const { return last_node_; }
  std::size_t nodes() const { return mesh_.points.size(); }

  PlaneMesh take() {
    if (mesh_.points.empty()) in_.fail("the file has no nodes (NPOIN=)");
    if (mesh_.triangles.empty()) in_.fail("the file has no triangles (NELEM=)");
    mesh_.regions.assign(mesh_.triangles.size(), 0);
    const std::vector<std::string> names = names_.take();
    for (std::size_t i = 0; i < names.size(); ++i) {
      mesh_.patch_names[static_cast<std::int32_t>(i) + 1] = names[i];
    }
    return std::move(mesh_);
  }

 private:
  std::int32_t node(std::int64_t number) {
    if (number < 0 || number >= std::numeric_limits<std::int32_t>::max()) {
      in_.fail("there is no node " + std::to_string(number));
    }
    const auto node = static_cast<std::int32_t>(number);
    last_node_ = std::max(last_node_, node);
    return node;
  }

  const InputScanner& in_;
  PatchNames names_;
  std::int32_t patch_ = 0;
  std::int32_t last_node_ = -1;
  PlaneMesh mesh_;
};

/// Fails at the first element with a node that is not among so many: nodes may come after it, so
/// that it shows at the end only.
class MissingNode : public Su2Content {
 public:
  MissingNode(const InputScanner& in, std::size_t nodes)
      : in_(in), nodes_(static_cast<std::int64_t>(nodes)) {}

  void add_node(const Vec3&) override {}
  void begin_marker(std::string_view) override {}
  bool wants(Su2List list, std::int64_t type, const InputScanner& in) override {
    return is_wanted(list, type, in);
  }
  void add_element(Su2List, std::int64_t, std::span<const std::int64_t> nodes) override {
    for (const std::int64_t node : nodes) {
      if (node < nodes_) continue;
      in_.fail("there is no node " + std::to_string(node) + ": the file has " +
               std::to_string(nodes_) + ", counted from 0");
    }
  }

 private:
  const InputScanner& in_;
  std::int64_t nodes_;
};

}  // namespace

PlaneMesh read_plane_su2(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name, '%');
  PlaneContent content(in);
  walk_su2(in, content, plane);
  if (content.last_node() >= 0 && at(content.last_node()) >= content.nodes()) {
    InputScanner again(bytes, name, '%');
    MissingNode missing(again, content.nodes());
    walk_su2(again, missing, plane);
  }
  PlaneMesh mesh = content.take();
  mesh.name = name;
  return mesh;
}

void write_plane_su2(const PlaneMesh& mesh, const std::filesystem::path& path) {
  const PlaneSides sides = sides_of(mesh);
  const std::vector<PlanePatch> patches = border_patches(mesh, sides);
  TextLines lines(60 * mesh.points.size() + 30 * mesh.triangles.size() + 1000);
  lines.words("NDIME= 2\nNELEM= ").number(mesh.triangles.size()).end();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    lines.number(su2_triangle);
    for (const std::int32_t v : mesh.triangles[t]) lines.number(v);
    lines.number(t).end();
  }
  lines.words("NPOIN= ").number(mesh.points.size()).end();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    lines.number(mesh.points[i].x).number(mesh.points[i].y).number(i).end();
  }
  lines.words("NMARK= ").number(patches.size()).end();
  auto side = sides.border.begin();
  for (const PlanePatch& patch : patches) {
    const auto end = std::find_if(side, sides.border.end(), [&](const OuterSide& other) {
      return other.patch != patch.number;
    });
    lines.words("MARKER_TAG= " + patch.name + "\nMARKER_ELEMS= ").number(end - side).end();
    for (; side != end; ++side) lines.number(su2_line).number(side->a).number(side->b).end();
  }
  write_file_atomically(path, lines.text());
}

}  // namespace tetfarm
