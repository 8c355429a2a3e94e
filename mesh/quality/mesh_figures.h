/// What a solver's user wants to know of a finished mesh: distributions, the worst tets, the time
/// step, the balance of the sub-domains; near the cuts and away from them.
///
/// Source: thesis 4.3.4.1.3 (figs. 86, 87: dihedral angles; table 1: smallest height and time
/// step), chapter 5. Taken part by part: `tetfarm quality` and `tetfarm report` show the same.
/// Units: those of the mesh; angles in degrees.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "mesh/assemble/mesh_shapes.h"
#include "mesh/assemble/shape_statistics.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/quality/histogram.h"

namespace tetfarm {

struct TetFigures {
  ShapeStatistics shapes;
  Histogram radius_ratio{0, 1, 20};
  Vec3 lowest_at;  ///< the centroid of the first tet with the smallest height
  void add(const TetShape& shape);
};

struct WorstTet {
  double min_dihedral_deg = 0;
  double max_dihedral_deg = 0;
  double radius_ratio = 0;
  double height = 0;
  Vec3 centroid;
  std::size_t subdomain = 0;
  std::int64_t tet = 0;  ///< in the whole mesh, sub-domain after sub-domain
  bool is_near_cut = false;
};

/// Of the cells of a type that are no tets. Dihedral angles, heights and radius ratios are of tets.
struct CellFigures {
  std::int64_t cells = 0;
  double volume = 0;
  double least_scaled_jacobian = 1;  ///< see elements.h
  double sum_of_scaled_jacobians = 0;
  double mean_scaled_jacobian() const {
    return cells > 0 ? sum_of_scaled_jacobians / static_cast<double>(cells) : 0;
  }
};

struct SubdomainFigures {
  std::int64_t cells = 0;  ///< of all types
  std::int64_t nodes = 0;
  std::int64_t boundary_triangles = 0;
  double volume = 0;
  double min_dihedral_deg = 180;
};

/// Lengths of edges over the spacing wanted at their middles. An edge on a cut counts once for each
/// sub-domain that has it.
struct EdgeFigures {
  Histogram over_spacing{0, 2.5, 25};
  std::int64_t edges = 0;
  double shortest = 0;  ///< over the spacing, as the others
  double longest = 0;
  double sum = 0;
  double mean() const { return edges > 0 ? sum / static_cast<double>(edges) : 0; }
};

struct MeshFigures {
  std::int64_t nodes = 0;  ///< each once
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::int64_t boundary_quads = 0;
  double volume = 0;
  ByType<CellFigures> others;
  TetFigures all;
  TetFigures near_cuts;  ///< within layers_near_cuts; none when the file knows no sub-domains
  TetFigures away_from_cuts;
  std::vector<RegionShapes> regions;    ///< of region 1, 2, …
  std::map<int, std::int64_t> volumes;  ///< p: from 2^p to less than 2^(p + 1)
  EdgeFigures edges;                    ///< empty when no spacing is known
  std::vector<WorstTet> worst;          ///< by smallest angle
  bool knows_subdomains = true;
  std::vector<SubdomainFigures> subdomains;  ///< or pieces of the file

  /// An explicit solver's largest time step, times the speed of its waves: the smallest height.
  double time_step() const { return all.shapes.smallest_height; }
  /// How many times the time steps that the mesh away from the cuts would need; 1 without cuts.
  double steps_beside_away() const;
  std::int64_t cells() const;  ///< of all types
  /// The largest sub-domain's cells over their mean.
  double largest_over_mean() const;
};

inline constexpr std::size_t most_worst_tets = 20;

using SpacingAt = std::function<double(const Vec3&)>;

using VisitPart = std::function<void(const NumberedPart& part)>;

/// `spacing` may be empty. Reads each part once, and twice more without its elements where the
/// source knows sub-domains; `visit` sees each as it passes. @throws what the source throws.
/// @pre node numbers are not negative, and not above what a bit each has room for.
/// Memory: one part, a bit a node, and of CutNodes. Cost: O(n log n), about a microsecond a tet.
MeshFigures figures_of(const MeshSource& source, const SpacingAt& spacing = {},
                       const VisitPart& visit = {});

}  // namespace tetfarm
