/// A recovered boundary with one Steiner point: what takes the point off it begins with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"
#include "mesh/recovery/surface_splitting.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {

/// A cube whose boundary is recovered; then a point is put on one of its edges or faces, which is
/// split.
struct SplitCube {
  SplitCube(std::int32_t triangle, bool is_on_edge)
      : domain(root_subdomain(shapes::unit_cube())),
        complex(bowyer_watson(domain.vertices).complex),
        marks(complex.nodes.size(), 0) {
    EXPECT_TRUE(recover_boundary(complex, marks, domain.triangles).lost.empty());
    mesh.emplace(complex, marks);
    const auto& [a, b, c] = domain.triangles[static_cast<std::size_t>(triangle)];
    const FinePoint on_edge = between(fine(mesh->point(a)), fine(mesh->point(b)), {0.3, 1e-20});
    const DoubleDouble share = is_on_edge ? DoubleDouble{} : DoubleDouble{0.4, 1e-20};
    node = mesh->add_point(between(on_edge, fine(mesh->point(c)), share));
    surface = unsplit(domain.triangles);
    if (is_on_edge) {
      put_into_tets({a, b});
      split_edge(surface, a, b, node);
    } else {
      put_into_tets({a, b, c});
      split_face(surface, triangle, node);
    }
    for (const Triangle& t : surface.triangles) {
      const FaceHandle face = mesh->find_face(t[0], t[1], t[2]);
      EXPECT_NE(face, no_face);
      mesh->constrain(face, true);
    }
  }

  void put_into_tets(const std::vector<std::int32_t>& crossed) {
    std::vector<std::int32_t> tets;
    std::vector<Tet> parts;
    for (const std::int32_t t : mesh->star(crossed.front())) {
      const Tet& n = complex.nodes[static_cast<std::size_t>(t)];
      const auto holds = [&n](std::int32_t v) { return std::count(n.begin(), n.end(), v) > 0; };
      if (!std::all_of(crossed.begin(), crossed.end(), holds)) continue;
      tets.push_back(t);
      for (const std::int32_t v : crossed) {
        parts.push_back(n);
        std::replace(parts.back().begin(), parts.back().end(), v, node);
      }
    }
    mesh->replace(tets, parts);
  }

  /// The inside as a mesh, as it is after the outside is gone.
  TetMesh inside_mesh() {
    const RecoverySurface whole(domain.triangles, static_cast<std::int32_t>(complex.points.size()));
    InsideComplex kept = keep_inside(complex, marks, inside_tets(*mesh, whole), 8, 4);
    kept.complex.points.resize(static_cast<std::size_t>(node) - 4 + 1);
    return to_tet_mesh(kept.complex, 8);
  }

  Subdomain domain;
  TetComplex complex;
  std::vector<std::uint8_t> marks;
  std::optional<LocalRemeshing> mesh;
  SplitSurface surface;
  std::int32_t node = -1;
};

}  // namespace tetfarm
