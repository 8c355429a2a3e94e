// The sequential mesher in memory, and the quality of any mesh of the same surface.
//
//   kernel_bench mesh SURFACE GROWTH [POINTS]  meshes it; times and quality as one JSON object;
//                                              POINTS: lattice (default) or sweeps
//   kernel_bench measure SURFACE GROWTH MESH   the quality of another program's mesh: Gmsh 2.2
//   ASCII
//                                              (.msh), or TetGen's .ele with the .node beside it
//
// GROWTH is that of the spacing, per unit of length: 0.3 is the default of a job; 0 makes the
// spacing the mean edge length of the surface everywhere.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/file_system.h"
#include "base/large_blocks.h"
#include "mesh/assemble/shape_statistics.h"
#include "mesh/core/tet_complex.h"
#include "mesh/core/validate.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/spacing/spacing_field.h"
#include "mesh/volume/volume_mesh.h"

namespace tetfarm {
namespace {

struct Seconds {
  double wall = 0;
  double cpu = 0;
};

Seconds now() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return {wall.count(), of(use.ru_utime) + of(use.ru_stime)};
}

double peak_mb() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  return static_cast<double>(use.ru_maxrss) * 1024e-6;
}

/// The numbers of a text, one after the other.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : here_(text.data()), end_(here_ + text.size()) {}

  template <class Number>
  Number next() {
    while (here_ != end_ && (*here_ == ' ' || *here_ == '\n' || *here_ == '\t')) ++here_;
    Number number{};
    const auto [after, error] = std::from_chars(here_, end_, number);
    if (error != std::errc{}) throw std::runtime_error("expected a number in the mesh");
    here_ = after;
    return number;
  }
  Vec3 next_point() {
    const double x = next<double>();
    const double y = next<double>();
    return {x, y, next<double>()};
  }
  void skip_line() { here_ = std::find(here_, end_, '\n'); }

 private:
  const char* here_;
  const char* end_;
};

Numbers section(std::string_view text, std::string_view title) {
  const std::size_t at = text.find(title);
  if (at == std::string_view::npos) throw std::runtime_error("no " + std::string(title));
  return Numbers(text.substr(at + title.size()));
}

using Tag2Node = std::unordered_map<std::int64_t, std::int32_t>;

void add_node(TetMesh& mesh, Tag2Node& tag2node, std::int64_t tag, const Vec3& p) {
  tag2node[tag] = static_cast<std::int32_t>(mesh.nodes.size());
  mesh.nodes.push_back(p);
}

/// Turned to positive volume: programs differ in the order of nodes.
void add_tet(TetMesh& mesh, const Tag2Node& tag2node, Numbers& numbers) {
  Tet tet;
  for (std::int32_t& v : tet) v = tag2node.at(numbers.next<std::int64_t>());
  const auto at = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(tet[i])]; };
  if (tet_volume(at(0), at(1), at(2), at(3)) < 0) std::swap(tet[0], tet[1]);
  mesh.tets.push_back(tet);
}

TetMesh read_msh_tets(std::string_view text) {
  TetMesh mesh;
  Tag2Node tag2node;
  Numbers nodes = section(text, "$Nodes");
  for (auto left = nodes.next<std::int64_t>(); left > 0; --left) {
    const auto tag = nodes.next<std::int64_t>();
    add_node(mesh, tag2node, tag, nodes.next_point());
  }
  constexpr int type_of_tets = 4;
  Numbers elements = section(text, "$Elements");
  for (auto left = elements.next<std::int64_t>(); left > 0; --left) {
    elements.next<std::int64_t>();
    if (elements.next<int>() == type_of_tets) {
      for (int tags = elements.next<int>(); tags > 0; --tags) elements.next<std::int64_t>();
      add_tet(mesh, tag2node, elements);
    }
    elements.skip_line();
  }
  return mesh;
}

TetMesh read_tetgen(const std::string& ele_path) {
  TetMesh mesh;
  Tag2Node tag2node;
  const std::string node_text = read_file(ele_path.substr(0, ele_path.size() - 3) + "node");
  Numbers nodes(node_text);
  const auto count = nodes.next<std::int64_t>();
  nodes.skip_line();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto tag = nodes.next<std::int64_t>();
    add_node(mesh, tag2node, tag, nodes.next_point());
    nodes.skip_line();
  }
  const std::string ele_text = read_file(ele_path);
  Numbers elements(ele_text);
  const auto tets = elements.next<std::int64_t>();
  elements.skip_line();
  for (std::int64_t i = 0; i < tets; ++i) {
    elements.next<std::int64_t>();
    add_tet(mesh, tag2node, elements);
    elements.skip_line();
  }
  return mesh;
}

std::vector<std::array<std::int32_t, 2>> edges_of(const TetMesh& mesh) {
  std::vector<std::array<std::int32_t, 2>> edges;
  edges.reserve(6 * mesh.tets.size());
  for (const Tet& tet : mesh.tets) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        edges.push_back({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
      }
    }
  }
  std::ranges::sort(edges);
  const auto [first, last] = std::ranges::unique(edges);
  edges.erase(first, last);
  return edges;
}

/// Faces without a partner: as many as the surface has triangles, or the mesh is cracked.
std::int64_t boundary_faces(const TetMesh& mesh) {
  const TetComplex complex = make_tet_complex(mesh);
  std::int64_t faces = 0;
  for (const auto& neighbours : complex.neighbours) {
    faces += std::ranges::count(neighbours, no_face);
  }
  return faces;
}

/// The members of a JSON object, without its braces.
std::string quality_json(const TetMesh& mesh, const SpacingField& spacing) {
  const auto at = [&mesh](std::int32_t v) { return mesh.nodes[static_cast<std::size_t>(v)]; };
  ShapeStatistics shapes;
  double volume = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    shapes.add(at(a), at(b), at(c), at(d));
    volume += tet_volume(at(a), at(b), at(c), at(d));
  }
  double sum = 0;
  std::int64_t fitting = 0;
  const auto edges = edges_of(mesh);
  for (const auto& [a, b] : edges) {
    const double ratio = distance(at(a), at(b)) / spacing.at(0.5 * (at(a) + at(b)));
    sum += ratio;
    if (ratio >= 0.7 && ratio <= 1.4) ++fitting;
  }
  const auto angles = static_cast<double>(6 * shapes.tets);
  const auto small =
      static_cast<double>(shapes.dihedral_histogram[0] + shapes.dihedral_histogram[1]);
  std::array<char, 600> text;
  const int size = std::snprintf(
      text.data(), text.size(),
      R"("elements":%zu,"nodes":%zu,"boundary_faces":%lld,"volume":%.12g,"min_dihedral_deg":%.4g,)"
      R"("max_dihedral_deg":%.5g,"share_below_20_deg":%.4g,"mean_radius_ratio":%.4g,)"
      R"("mean_edge_over_spacing":%.4g,"share_of_fitting_edges":%.4g)",
      mesh.tets.size(), mesh.nodes.size(), static_cast<long long>(boundary_faces(mesh)), volume,
      shapes.min_dihedral_deg, shapes.max_dihedral_deg, small / angles, shapes.mean_radius_ratio(),
      sum / static_cast<double>(edges.size()),
      static_cast<double>(fitting) / static_cast<double>(edges.size()));
  return std::string(text.data(), static_cast<std::size_t>(size));
}

double mean_edge(const SurfaceMesh& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto at = [&](std::int32_t v) { return surface.vertices[static_cast<std::size_t>(v)]; };
    sum += distance(at(a), at(b)) + distance(at(b), at(c)) + distance(at(c), at(a));
  }
  return sum / (3 * static_cast<double>(surface.triangles.size()));
}

SpacingField spacing_of(const SurfaceMesh& surface, double growth) {
  if (growth == 0) return SpacingField(mean_edge(surface));
  SpacingOptions options;
  options.growth = growth;
  return make_spacing_field(surface, options);
}

int mesh(const std::string& path, double growth, InteriorPoints points) {
  const Seconds begin = now();
  const SurfaceMesh surface = read_surface(path);
  const Subdomain domain = root_subdomain(surface);
  const Seconds start = now();
  const SpacingField spacing = spacing_of(surface, growth);
  VolumeMeshOptions options;
  options.points = points;
  const TetMesh made = mesh_volume(domain, spacing, options).mesh.value();
  const Seconds end = now();
  const double memory = peak_mb();
  const std::vector<std::string> complaints = validate(made, domain.triangles);
  for (const std::string& line : complaints) std::fprintf(stderr, "%s\n", line.c_str());
  std::printf(
      R"({"wall_s":%.4f,"cpu_s":%.4f,"process_cpu_s":%.4f,"process_wall_s":%.4f,"peak_mb":%.1f,%s})"
      "\n",
      end.wall - start.wall, end.cpu - start.cpu, end.cpu, end.wall - begin.wall, memory,
      quality_json(made, spacing).c_str());
  return complaints.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

InteriorPoints points_of(const std::vector<std::string>& words) {
  if (words.size() < 4 || words[3] == "lattice") return InteriorPoints::lattice;
  if (words[3] == "sweeps") return InteriorPoints::sweeps;
  throw std::runtime_error("points are \"lattice\" or \"sweeps\", not " + words[3]);
}

int measure(const std::string& path, double growth, const std::string& mesh_path) {
  const SpacingField spacing = spacing_of(read_surface(path), growth);
  const TetMesh mesh =
      mesh_path.ends_with(".ele") ? read_tetgen(mesh_path) : read_msh_tets(read_file(mesh_path));
  if (mesh.tets.empty()) throw std::runtime_error(mesh_path + " has no tetrahedra");
  std::printf("{%s}\n", quality_json(mesh, spacing).c_str());
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace tetfarm

int main(int argc, char** argv) {
  tetfarm::give_back_large_blocks();
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if ((words.size() == 3 || words.size() == 4) && words[0] == "mesh") {
      return tetfarm::mesh(words[1], std::stod(words[2]), tetfarm::points_of(words));
    }
    if (words.size() == 4 && words[0] == "measure")
      return tetfarm::measure(words[1], std::stod(words[2]), words[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return EXIT_FAILURE;
  }
  std::fprintf(stderr,
               "usage: kernel_bench mesh SURFACE GROWTH [lattice | sweeps]"
               " | measure SURFACE GROWTH MESH\n");
  return 2;
}
