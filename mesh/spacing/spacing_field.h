/// The spacing: target edge length as one function of position, for cuts and volumes alike.
///
/// Source: thesis 3.2 (sources, fig. 15), 4.3.1.9 (background mesh). Made once by `inspect`, read
/// by every task. A 2:1-balanced octree whose cells follow the spacing (octree_build.h); the value
/// is interpolated from the corners of the cell. Units: lengths in the unit of the input.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

/// A mesh-control source with its 1, 2 or 3 corners (thesis: point, line, triangle). Spacing is
/// constant within the inner radius, decays exponentially to the background at the outer radius,
/// and is interpolated linearly between corners.
struct SourceCorner {
  Vec3 at;
  double spacing = 0;
  double inner_radius = 0;
  double outer_radius = 0;
};
/// What lies between the corners.
enum class SourceShape : std::uint8_t {
  hull,     ///< 1, 2 or 3 corners: a point, a line, a triangle
  box,      ///< 2: two opposite corners of a box along the axes, filled
  cylinder  ///< 2: the ends of its axis; filled, with flat ends, each of its own radius
};
struct Source {
  std::vector<SourceCorner> corners;
  SourceShape shape = SourceShape::hull;
  std::array<double, 2> radii{};  ///< of a cylinder, at its ends; 0: a tip
};

/// A triangle, most likely of a patch, at which the spacing is wanted: constant within 0.6 of
/// itself of the triangle, and growing beyond. The growth counts no more than that of all of the
/// field.
struct TriangleDemand {
  std::array<Vec3, 3> corners;
  double spacing = 0;
  double growth = 0;
};

struct SpacingOptions {
  /// Spacing far from everything; 0: the largest that surface and growth allow.
  double background = 0;
  /// Spacing grows by at most this much per unit length (dimensionless, > 0).
  double growth = 0.3;
  /// The surface's own edge lengths count too.
  bool inherit_surface = true;
  std::vector<Source> sources;
  std::vector<TriangleDemand> triangles;
};

/// One node of the job's body-centred-cubic lattice (kernel: points inside). `cell_edge` is the
/// edge of the smallest octree cell that the node belongs to. Where cells of two sizes meet, the
/// node is better off the lattice, by `shift` / 128 of cell_edge towards the larger ones
/// (level_shift.h); zero elsewhere. `grid` and `cell_size` tell place and cell in whole numbers: a
/// corner is a multiple of the size on all axes, a centre lies half of it further.
struct LatticeNode {
  Vec3 at;
  double cell_edge = 0;
  std::array<std::int32_t, 3> grid{};
  std::uint8_t cell_bits = 0;
  std::array<std::int8_t, 3> shift{};

  std::int32_t cell_size() const { return 1 << cell_bits; }

  /// Where it is put in a mesh; the lattice node itself when there is no shift.
  Vec3 place() const {
    return at + 0x1p-7 * cell_edge *
                    Vec3{static_cast<double>(shift[0]), static_cast<double>(shift[1]),
                         static_cast<double>(shift[2])};
  }
};

/// Some of the nodes of the lattice, evenly spread among them.
struct LatticeSample {
  std::vector<LatticeNode> nodes;
  double nodes_for_each = 1;
};

/// A plane of the lattice's {110} family. Lattice tets between cells of one size have their faces
/// in such planes: where its nodes lie in one, none crosses it. It holds the grid points whose
/// coordinates p, in half-units of the octree, fulfil p[axis] + sign p[other_axis] = sum.
struct LatticePlane {
  std::size_t axis = 0;
  std::size_t other_axis = 1;
  std::int32_t sign = 1;
  std::int32_t sum = 0;
  Vec3 normal;        // of length 1
  double offset = 0;  // along the normal
};

/// The six directions of such planes: unit normals.
std::array<Vec3, 6> lattice_plane_normals();

using BoxPredicate = std::function<bool(const Box3&)>;

/// What a walk over the lattice came to, for measurements.
struct LatticeVisits {
  std::int64_t cells = 0;      // of the octree and of its blocks
  std::int64_t questions = 0;  // whether a box is needless
};

class SpacingField {
 public:
  /// A constant field: for tests.
  explicit SpacingField(double constant);
  SpacingField(SpacingField&&) noexcept;
  SpacingField& operator=(SpacingField&&) noexcept;
  ~SpacingField();

  /// The spacing at a point, also outside the octree (then: of the nearest point of its box).
  /// Always positive and finite. Cost: well under a microsecond.
  double at(const Vec3& point) const;

  /// Not more than the spacing is anywhere, and nearly as much somewhere. Cost: O(cells).
  double smallest() const;

  /// The edge of the smallest lattice cell that holds the point, or the nearest one of the octree's
  /// box. Cost: as at().
  double lattice_cell_edge(const Vec3& point) const;

  /// The nodes of the graded body-centred lattice (corners and centres of the balanced octree's
  /// leaf cells, cell edge about spacing / 0.92) inside the closed box, each once, in the Morton
  /// order of the cells that own them, the same coordinates whatever the box. Cost: O(cells that
  /// meet the box).
  std::vector<LatticeNode> lattice_nodes(const Box3& box) const;

  /// The same without those of the blocks of cells of which `is_needless` holds: it is asked of
  /// cells of the octree, of blocks of 64 cells and more, and of the parts of those that are
  /// needed. Adds to `visits`, if given.
  std::vector<LatticeNode> lattice_nodes(const Box3& box, const BoxPredicate& is_needless,
                                         LatticeVisits* visits = nullptr) const;

  /// Of those lattice nodes one of each n, scattered, n being the power of two that leaves no more
  /// than `most` (and two). Where that would visit too many cells, points as dense as the nodes
  /// instead (lattice_volume.h).
  /// Cost: O(cells of the octree, and at the faces of its blocks, that meet the box), some ten
  /// nanoseconds each; never more than most_cells_walked of them.
  LatticeSample sample_lattice(const Box3& box, std::size_t most) const;

  /// Of those lattice nodes the ones in a plane. Cost: O(cells of the box that meet the plane).
  std::vector<LatticeNode> lattice_nodes_in_plane(const Box3& box, const LatticePlane& plane) const;

  /// Of the planes with normal lattice_plane_normals()[direction] and an offset within the bounds,
  /// the one that holds nodes of the largest cells; nothing when there is none.
  std::optional<LatticePlane> coarsest_lattice_plane(std::size_t direction, double least_offset,
                                                     double largest_offset) const;

  /// Estimated elements in a box of this spacing: its volume times elements per h^3 is ∫ c dV /
  /// h^3.
  static constexpr double elements_per_h3 = 8.48528137423857;  // 6 sqrt(2): regular tets of edge h

  std::string to_bytes() const;
  /// @throws CorruptFile when the bytes are not what to_bytes wrote.
  static SpacingField from_bytes(std::string_view bytes, const std::string& name);
  /// The same of a file, of which only those parts come into memory that are asked for, beside the
  /// check of all of it now. It must not be shortened while the field is there. `name` is for
  /// messages. @throws IoError; CorruptFile.
  static SpacingField from_file(const std::filesystem::path& path, const std::string& name);

 private:
  friend SpacingField make_spacing_field(const SurfaceMesh&, const SpacingOptions&);
  struct Octree;
  explicit SpacingField(std::unique_ptr<Octree> octree);
  std::unique_ptr<Octree> octree_;
};

/// The field of a domain: the minimum of background, sources and (if asked) surface edge lengths,
/// growing by no more than options.growth per unit length. Deterministic to the last bit on every
/// machine (uses only + - * / sqrt).
/// @throws InvalidInput when a source has a spacing, growth or radius that is not positive, or
/// outer < inner. Cost: O(n log n) for n triangles + cells.
SpacingField make_spacing_field(const SurfaceMesh& surface, const SpacingOptions& options);

}  // namespace tetfarm
