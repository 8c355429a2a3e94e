#include "mesh/core/elements.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "mesh/core/signed_volume.h"
#include "mesh/core/tet_mesh.h"

namespace tetfarm {
namespace {

using enum ElementType;
using Edge = std::array<std::uint8_t, 2>;
using Order = std::array<std::uint8_t, most_element_nodes>;

constexpr std::array<Edge, 3> triangle_edges = {{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<Edge, 4> quad_edges = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};

constexpr std::array<ElementFace, 4> faces_of_tet() {
  std::array<ElementFace, 4> faces;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      faces[i].nodes[k] = static_cast<std::uint8_t>(tet_face_nodes[i][k]);
    }
  }
  return faces;
}
constexpr std::array<ElementFace, 4> tet_faces = faces_of_tet();
constexpr std::array<Edge, 6> tet_edges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

constexpr std::array<ElementFace, 5> pyramid_faces = {{{quad, {0, 3, 2, 1}},
                                                       {triangle, {0, 1, 4}},
                                                       {triangle, {1, 2, 4}},
                                                       {triangle, {2, 3, 4}},
                                                       {triangle, {3, 0, 4}}}};
constexpr std::array<Edge, 8> pyramid_edges = {
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};

constexpr std::array<ElementFace, 5> prism_faces = {{{triangle, {0, 2, 1}},
                                                     {triangle, {3, 4, 5}},
                                                     {quad, {0, 1, 4, 3}},
                                                     {quad, {1, 2, 5, 4}},
                                                     {quad, {2, 0, 3, 5}}}};
constexpr std::array<Edge, 9> prism_edges = {
    {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

constexpr std::array<ElementFace, 6> hex_faces = {{{quad, {0, 3, 2, 1}},
                                                   {quad, {4, 5, 6, 7}},
                                                   {quad, {0, 1, 5, 4}},
                                                   {quad, {1, 2, 6, 5}},
                                                   {quad, {2, 3, 7, 6}},
                                                   {quad, {3, 0, 4, 7}}}};
constexpr std::array<Edge, 12> hex_edges = {{{0, 1},
                                             {1, 2},
                                             {2, 3},
                                             {3, 0},
                                             {4, 5},
                                             {5, 6},
                                             {6, 7},
                                             {7, 4},
                                             {0, 4},
                                             {1, 5},
                                             {2, 6},
                                             {3, 7}}};

const ByType<Element>& shapes() {
  static const ByType<Element> table = [] {
    ByType<Element> all;
    all[triangle] = {"triangle", "triangles", 2, {}, triangle_edges};
    all[quad] = {"quad", "quads", 2, {}, quad_edges};
    all[tet] = {"tet", "tets", 3, tet_faces, tet_edges};
    all[pyramid] = {"pyramid", "pyramids", 3, pyramid_faces, pyramid_edges};
    all[prism] = {"prism", "prisms", 3, prism_faces, prism_edges};
    all[hex] = {"hex", "hexes", 3, hex_faces, hex_edges};
    return all;
  }();
  return table;
}

/// The nodes that edges join to a corner, in an order in which their determinant is positive: two
/// faces that follow one another round the corner share the edge between them.
std::vector<std::uint8_t> nodes_round(const Element& shape, std::uint8_t corner) {
  std::vector<std::array<std::uint8_t, 2>> steps;  // of each face, from one edge to the other
  for (const ElementFace& face : shape.faces) {
    const std::size_t nodes = nodes_of(face.type);
    for (std::size_t k = 0; k < nodes; ++k) {
      if (face.nodes[k] != corner) continue;
      steps.push_back({face.nodes[(k + nodes - 1) % nodes], face.nodes[(k + 1) % nodes]});
    }
  }
  std::vector<std::uint8_t> round = {steps.front()[0]};
  while (round.size() < steps.size()) {
    const auto next = std::find_if(steps.begin(), steps.end(),
                                   [&](const auto& step) { return step[0] == round.back(); });
    round.push_back((*next)[1]);
  }
  return round;
}

/// Three edges at a corner, by their other ends.
struct Corner {
  std::uint8_t node = 0;
  std::array<std::uint8_t, 3> ends{};
};

const std::vector<Corner>& corners_of(ElementType type) {
  static const ByType<std::vector<Corner>> table = [] {
    ByType<std::vector<Corner>> all;
    for (const ElementType each : all_element_types) {
      if (!is_cell(each)) continue;
      for (std::uint8_t node = 0; node < nodes_of(each); ++node) {
        const std::vector<std::uint8_t> round = nodes_round(element(each), node);
        if (round.size() == 3) all[each].push_back({node, {round[0], round[1], round[2]}});
      }
    }
    return all;
  }();
  return table[type];
}

/// What the determinant is at each corner that is looked at, over the lengths, if the element is
/// regular: all its edges have one length.
double regular_corner(ElementType type) {
  const double right_with_two_slants = std::sqrt(0.5);
  switch (type) {
    case tet:
    case pyramid:
      return right_with_two_slants;
    case prism:
      return std::sqrt(0.75);
    default:
      return 1;
  }
}

}  // namespace

const Element& element(ElementType type) { return shapes()[type]; }

std::string text_of_count(std::int64_t count, ElementType type) {
  const Element& shape = element(type);
  return std::to_string(count) + " " + std::string(count == 1 ? shape.name : shape.plural);
}

const std::array<std::uint8_t, most_element_nodes>& node_order(ElementCodes codes,
                                                               ElementType type) {
  static constexpr Order as_ours = {0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr Order vtk_wedge = {0, 2, 1, 3, 5, 4};
  static constexpr Order ugrid_pyramid = {0, 3, 4, 1, 2};
  if (code_of(codes, type) == 0) {
    throw Error(ExitCode::failed,
                "the format has no code for " + std::string(element(type).plural));
  }
  if (codes == ElementCodes::vtk && type == prism) return vtk_wedge;
  if (codes == ElementCodes::ugrid && type == pyramid) return ugrid_pyramid;
  return as_ours;
}

long double cone_volume(const Vec3& origin, std::span<const Vec3> face) {
  if (face.size() == 3) return signed_volume(origin, face[0], face[1], face[2]);
  const auto cone = [&](std::size_t a, std::size_t b, std::size_t c) {
    return signed_volume(origin, face[a], face[b], face[c]);
  };
  return (cone(0, 1, 2) + cone(0, 2, 3) + cone(0, 1, 3) + cone(1, 2, 3)) / 2;
}

long double element_volume(ElementType type, std::span<const Vec3> nodes) {
  if (type == tet) return signed_volume(nodes[0], nodes[1], nodes[2], nodes[3]);
  long double volume = 0;
  for (const ElementFace& face : element(type).faces) {
    std::array<Vec3, most_face_nodes> corners;
    const std::size_t count = nodes_of(face.type);
    for (std::size_t k = 0; k < count; ++k) corners[k] = nodes[face.nodes[k]];
    volume += cone_volume(nodes[0], {corners.data(), count});
  }
  return volume;
}

double scaled_jacobian(ElementType type, std::span<const Vec3> nodes) {
  double least = 1;
  for (const Corner& corner : corners_of(type)) {
    const Vec3& from = nodes[corner.node];
    const Vec3 a = nodes[corner.ends[0]] - from;
    const Vec3 b = nodes[corner.ends[1]] - from;
    const Vec3 c = nodes[corner.ends[2]] - from;
    const double lengths = norm(a) * norm(b) * norm(c);
    const double here = lengths > 0 ? dot(a, cross(b, c)) / lengths / regular_corner(type) : 0;
    least = std::min(least, here);
  }
  return least;
}

}  // namespace tetfarm
