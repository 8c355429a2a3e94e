#include "mesh/formats/plane/plane_msh.h"

#include <limits>
#include <map>
#include <utility>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/formats/msh/msh_walker.h"
#include "mesh/formats/plane/text_lines.h"

namespace tetfarm {
namespace {

constexpr std::int64_t msh_line = 1;

/// Triangles and lines with the names of their physical groups.
class PlaneMshContent : public MshContent {
 public:
  explicit PlaneMshContent(const InputScanner& in) : in_(in) {}

  void add_name(int dimension, std::int64_t group, std::string_view name) override {
    if (dimension == 1) mesh_.patch_names[to_group(group)] = name;
    if (dimension == 2) mesh_.region_names[to_group(group)] = name;
  }
  void add_node(std::int64_t tag, const Vec3& p) override {
    if (mesh_.points.size() == std::numeric_limits<std::int32_t>::max()) in_.fail("too many nodes");
    if (mesh_.points.empty()) height_ = p.z;
    if (p.z != height_) in_.fail("the nodes do not lie in one plane z = constant");
    tags_.add(tag);
    mesh_.points.push_back({p.x, p.y});
  }
  void end_nodes() override {
    if (const auto twice = tags_.sort()) {
      in_.fail("two nodes have the tag " + std::to_string(*twice));
    }
  }
  bool wants(const MshElementType& type, std::int64_t number) override {
    if (type.dimension == 0) return false;
    if (number != msh_line && number != msh_triangle) {
      in_.fail("a " + std::string(type.name) +
               ": only lines of 2 and triangles of 3 nodes are read");
    }
    return true;
  }
  void add_element(const MshElement& element) override {
    const std::int32_t group = to_group(element.group);
    if (element.type == msh_line) {
      mesh_.edges.push_back({node(element, 0), node(element, 1)});
      mesh_.patches.push_back(group);
    } else {
      mesh_.triangles.push_back({node(element, 0), node(element, 1), node(element, 2)});
      mesh_.regions.push_back(group);
    }
  }

  PlaneMesh take() {
    if (mesh_.points.empty()) in_.fail("the file has no nodes");
    if (mesh_.triangles.empty()) in_.fail("the file has no triangles");
    return std::move(mesh_);
  }

 private:
  /// Without the sign, which tells in version 2.2 that an element is turned.
  std::int32_t to_group(std::int64_t number) const {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    if (number < -most || number > most) in_.fail("a physical tag is too large");
    return static_cast<std::int32_t>(number < 0 ? -number : number);
  }
  std::int32_t node(const MshElement& element, std::size_t k) const {
    const std::int32_t found = tags_.find(element.nodes[k]);
    if (found < 0) in_.fail("there is no node " + std::to_string(element.nodes[k]));
    return found;
  }

  const InputScanner& in_;
  MshNodeTags tags_;
  double height_ = 0;
  PlaneMesh mesh_;
};

/// Entities from 1 on, one for each number of a patch or region.
std::map<std::int32_t, std::size_t> entities_of(const std::vector<std::int32_t>& numbers) {
  std::map<std::int32_t, std::size_t> entities;
  for (const std::int32_t number : numbers) entities[number] = 0;
  std::size_t next = 1;
  for (auto& [number, entity] : entities) entity = next++;
  return entities;
}

void write_names(TextLines& lines, int dimension,
                 const std::map<std::int32_t, std::string>& names) {
  for (const auto& [number, name] : names) {
    std::string plain;
    for (const char c : name) plain += c == '"' || c == '\n' ? '_' : c;
    lines.number(dimension).number(number).words("\"" + plain + "\" ").end();
  }
}

}  // namespace

PlaneMesh read_plane_msh(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name);
  PlaneMshContent content(in);
  MshWalker(in).walk(content);
  PlaneMesh mesh = content.take();
  mesh.name = name;
  return mesh;
}

void write_plane_msh(const PlaneMesh& mesh, const std::filesystem::path& path) {
  TF_CHECK(mesh.patches.size() == mesh.edges.size());
  TF_CHECK(mesh.regions.size() == mesh.triangles.size());
  TextLines lines(60 * mesh.points.size() + 40 * mesh.triangles.size() + 1000);
  lines.words("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n");
  lines.number(mesh.patch_names.size() + mesh.region_names.size()).end();
  write_names(lines, 1, mesh.patch_names);
  write_names(lines, 2, mesh.region_names);
  lines.words("$EndPhysicalNames\n$Nodes\n").number(mesh.points.size()).end();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    lines.number(i + 1).number(mesh.points[i].x).number(mesh.points[i].y).number(0).end();
  }
  lines.words("$EndNodes\n$Elements\n").number(mesh.edges.size() + mesh.triangles.size()).end();
  std::size_t number = 1;
  const auto put = [&](std::int64_t type, std::int32_t group, std::size_t entity,
                       const auto& nodes) {
    lines.number(number++).number(type).number(2).number(group).number(entity);
    for (const std::int32_t v : nodes) lines.number(v + 1);
    lines.end();
  };
  const auto lines_of = entities_of(mesh.patches);
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    put(msh_line, mesh.patches[k], lines_of.at(mesh.patches[k]), mesh.edges[k]);
  }
  const auto surfaces_of = entities_of(mesh.regions);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    put(msh_triangle, mesh.regions[t], surfaces_of.at(mesh.regions[t]), mesh.triangles[t]);
  }
  lines.words("$EndElements\n");
  write_file_atomically(path, lines.text());
}

}  // namespace tetfarm
