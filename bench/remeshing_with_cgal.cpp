// A surface remeshed by CGAL, for comparison, and a judge of remeshed surfaces that shares no code
// with ours (bench/remeshing.py). Built only where CGAL is installed.
//
//   remeshing_with_cgal remesh IN OUT.off EDGE     even edges, those sharper than 30 degrees kept
//   remeshing_with_cgal judge IN REMESHED EDGE     one line of JSON
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;
namespace processing = CGAL::Polygon_mesh_processing;

constexpr double sharp_deg = 30;

Mesh read(const std::string& path) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  if (!CGAL::IO::read_polygon_soup(path, points, triangles))
    throw std::runtime_error("cannot read " + path);
  processing::repair_polygon_soup(points, triangles);
  processing::orient_polygon_soup(points, triangles);
  Mesh mesh;
  processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

auto sharp_edges(Mesh& mesh) {
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  processing::detect_sharp_edges(mesh, sharp_deg, is_sharp);
  return is_sharp;
}

void remesh(const std::string& in, const std::string& out, double edge) {
  Mesh mesh = read(in);
  const std::clock_t start = std::clock();
  const auto is_sharp = sharp_edges(mesh);
  std::vector<Mesh::Edge_index> long_edges;
  for (const Mesh::Edge_index e : mesh.edges()) {
    if (is_sharp[e]) long_edges.push_back(e);
  }
  namespace parameters = processing::parameters;
  processing::split_long_edges(long_edges, edge, mesh,
                               parameters::edge_is_constrained_map(is_sharp));
  processing::isotropic_remeshing(
      faces(mesh), edge, mesh,
      parameters::number_of_iterations(5).protect_constraints(true).edge_is_constrained_map(
          is_sharp));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  mesh.collect_garbage();
  if (!CGAL::IO::write_OFF(out, mesh, CGAL::parameters::stream_precision(17))) {
    throw std::runtime_error("cannot write " + out);
  }
  std::cout << "{\"seconds\":" << seconds << "}" << std::endl;
}

/// The farthest of points spread over the triangles of one surface from another: corners, middles
/// of edges, and ten points inside.
double farthest(const Mesh& from, const Tree& to) {
  double farthest2 = 0;
  const auto look_at = [&](const Point& p) {
    farthest2 = std::max(farthest2, to.squared_distance(p));
  };
  for (const Mesh::Face_index f : from.faces()) {
    std::vector<Point> corners;
    for (const auto v : CGAL::vertices_around_face(from.halfedge(f), from))
      corners.push_back(from.point(v));
    constexpr int steps = 4;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        look_at(CGAL::barycenter(corners[0], i, corners[1], j, corners[2], steps - i - j));
      }
    }
  }
  return std::sqrt(farthest2);
}

/// Pairs of triangles that share more than their common corners.
std::size_t meeting_pairs(const Mesh& mesh) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

struct Shapes {
  double smallest_deg = 180;
  double smallest_free_deg = 180;  ///< of triangles without a corner on a sharp edge
  std::size_t free = 0;
  std::size_t free_below_30 = 0;
  double mean_ratio = 0;  ///< twice the inradius over the circumradius
};

Shapes shapes_of(Mesh& mesh) {
  const auto is_sharp = sharp_edges(mesh);
  std::vector<bool> is_on_feature(mesh.number_of_vertices(), false);
  for (const Mesh::Edge_index e : mesh.edges()) {
    if (!is_sharp[e]) continue;
    is_on_feature[mesh.vertex(e, 0)] = true;
    is_on_feature[mesh.vertex(e, 1)] = true;
  }
  Shapes shapes;
  for (const Mesh::Face_index f : mesh.faces()) {
    std::array<Point, 3> p;
    bool is_free = true;
    std::size_t next = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      p[next++] = mesh.point(v);
      is_free = is_free && !is_on_feature[v];
    }
    std::array<double, 3> lengths;
    double smallest = 180;
    for (std::size_t i = 0; i < 3; ++i) {
      lengths[i] = std::sqrt(CGAL::squared_distance(p[i], p[(i + 1) % 3]));
      smallest = std::min(smallest, CGAL::approximate_angle(p[(i + 1) % 3], p[i], p[(i + 2) % 3]));
    }
    const auto& [a, b, c] = lengths;
    if (a > 0 && b > 0 && c > 0) {
      shapes.mean_ratio += (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c);
    }
    shapes.smallest_deg = std::min(shapes.smallest_deg, smallest);
    if (!is_free) continue;
    ++shapes.free;
    shapes.smallest_free_deg = std::min(shapes.smallest_free_deg, smallest);
    if (smallest < 30) ++shapes.free_below_30;
  }
  shapes.mean_ratio /= static_cast<double>(std::max<std::size_t>(mesh.number_of_faces(), 1));
  return shapes;
}

void judge(const std::string& in, const std::string& remeshed, double edge) {
  const Mesh before = read(in);
  Mesh after = read(remeshed);
  const Tree tree_before(faces(before).first, faces(before).second, before);
  const Tree tree_after(faces(after).first, faces(after).second, after);
  const auto euler = [](const Mesh& mesh) {
    return static_cast<long>(mesh.number_of_vertices()) -
           static_cast<long>(mesh.number_of_edges()) + static_cast<long>(mesh.number_of_faces());
  };
  std::size_t well_sized = 0;
  double lengths = 0;
  for (const Mesh::Edge_index e : after.edges()) {
    const double length = processing::edge_length(after.halfedge(e), after) / edge;
    lengths += length;
    if (length >= 0.6 && length <= 1.5) ++well_sized;
  }
  const auto edges = static_cast<double>(std::max<std::size_t>(after.number_of_edges(), 1));
  const Shapes shapes = shapes_of(after);
  std::cout << std::setprecision(9) << std::boolalpha
            << "{\"triangles\":" << after.number_of_faces()
            << ",\"closed_before\":" << CGAL::is_closed(before)
            << ",\"closed\":" << CGAL::is_closed(after) << ",\"euler_before\":" << euler(before)
            << ",\"euler\":" << euler(after)
            << ",\"self_intersections_before\":" << meeting_pairs(before)
            << ",\"self_intersections\":" << meeting_pairs(after)
            << ",\"smallest_deg\":" << shapes.smallest_deg << ",\"free\":" << shapes.free
            << ",\"smallest_free_deg\":" << shapes.smallest_free_deg
            << ",\"free_below_30\":" << shapes.free_below_30
            << ",\"mean_ratio\":" << shapes.mean_ratio << ",\"mean_length\":" << lengths / edges
            << ",\"well_sized\":" << static_cast<double>(well_sized) / edges
            << ",\"distance_to\":" << farthest(after, tree_before)
            << ",\"distance_from\":" << farthest(before, tree_after)
            << ",\"volume_before\":" << (CGAL::is_closed(before) ? processing::volume(before) : 0)
            << ",\"volume\":" << (CGAL::is_closed(after) ? processing::volume(after) : 0) << "}"
            << std::endl;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string act = argc == 5 ? argv[1] : "";
    if (act == "remesh") {
      remesh(argv[2], argv[3], std::stod(argv[4]));
    } else if (act == "judge") {
      judge(argv[2], argv[3], std::stod(argv[4]));
    } else {
      throw std::runtime_error(
          "remeshing_with_cgal remesh IN OUT.off EDGE | judge IN REMESHED EDGE");
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
