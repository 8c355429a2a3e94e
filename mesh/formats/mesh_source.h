/// A finished mesh as a file has it, part by part: what is written in other formats is read from.
///
/// Parts are sub-domains where the file knows them, else pieces of consecutive tets. Any part can
/// be read at any time and as often as wanted; only that part is in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/core/patch_type.h"

namespace tetfarm {

class MeshSource {
 public:
  virtual ~MeshSource() = default;
  virtual std::size_t size() const = 0;
  /// The i-th part, with the number i. @throws InvalidInput, IoError.
  virtual NumberedPart part(std::size_t i) const = 0;
  /// The same; its tets and faces may be left out, their patches and regions not.
  virtual CountedPart counted_part(std::size_t i) const;
  /// Whether parts are sub-domains, and not pieces of the file.
  virtual bool knows_subdomains() const { return true; }
  /// Whether `part` may be called while another thread writes a mesh.
  virtual bool takes_threads() const { return false; }
  /// Which marks the parts have, if not all cells have 0.
  virtual std::vector<CellMark> cell_marks() const { return {}; }
  /// Whether the parts tell of the feet of nodes, if some have one. A foot is a node of the mesh.
  virtual bool has_feet() const { return false; }
  /// What is wrong with what the file has beside its parts, a line each.
  virtual std::vector<std::string> complaints() const { return {}; }
  virtual std::vector<std::string> patch_names() const = 0;   ///< empty: the file has none
  virtual std::vector<std::string> region_names() const = 0;  ///< of regions 1, 2, …
  /// Of the patches that have names; empty: the file does not say.
  virtual std::vector<PatchType> patch_types() const { return {}; }
};

/// What a part, or the mesh, has of a type that is kept in blocks.
struct BlockOutline {
  std::int64_t count = 0;
  std::int64_t first = 0;              ///< what the parts before have
  std::vector<std::int64_t> of_group;  ///< of regions 1, 2, …; of a face, of patches 0, 1, …
  std::vector<std::int64_t> first_of_group;  ///< of each: what the parts before have
};

/// What must be known before the first part is written.
struct PartOutline {
  std::int64_t nodes = 0;
  std::int64_t owned_nodes = 0;  ///< that no part before has
  std::int64_t tets = 0;
  std::int64_t first_tet = 0;  ///< in the whole mesh: tets are counted part after part
  std::vector<std::int64_t> tets_of_region;  ///< of regions 1, 2, …; in this order in the part
  std::vector<std::int64_t> faces_of_patch;
  std::int64_t faces = 0;
  std::int64_t first_face = 0;                    ///< faces are counted part after part too
  std::vector<std::int64_t> first_face_of_patch;  ///< of each patch: what the parts before have
  ByType<BlockOutline> blocks;                    ///< cells of a type are in the order of regions
  std::int64_t first_cell = 0;                    ///< cells of all types, part after part
  Box3 box;

  ElementCounts elements() const;  ///< of each type
};

struct MeshOutline {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::vector<PartOutline> parts;
  std::vector<std::int64_t> faces_of_patch;  ///< one for each name
  std::vector<std::int64_t> tets_of_region;  ///< one for each name
  ByType<BlockOutline> blocks;               ///< sums
  std::vector<std::string> patch_names;      ///< all have one: "patch 3" without
  std::vector<std::string> region_names;     ///< all have one: "domain", or "region 2" without
  std::vector<PatchType> patch_types = {};   ///< one for each name, or none: all are unspecified

  ElementCounts elements() const;  ///< of each type
  std::int64_t cells() const;
  std::int64_t boundary_faces() const;
  /// Of a patch, triangles and others.
  std::int64_t boundary_faces_of(std::size_t patch) const;
  /// Whether cells are tets and boundary faces triangles.
  bool has_tets_alone() const;
};

/// For formats that hold nothing else: `what` is "TetGen files hold". @throws Error with a sentence
/// that says what the mesh has besides tets and triangles, and what to do.
void require_tets_alone(const MeshOutline& outline, const std::string& what);

/// From what each part has: where in the whole mesh it begins, and the sums. All parts get as many
/// patches and regions as there are names. @pre each has a name.
void add_up(MeshOutline& outline);

/// The cells of a part that are of one region: tets, and others where there are any.
struct RegionRun {
  std::size_t part = 0;
  std::int32_t region = 1;
  std::int64_t first_tet = 0;  ///< in the whole mesh
  std::int64_t tets = 0;
  ElementCounts first_in_block;  ///< in the whole mesh, within the type
  ElementCounts others;

  std::int64_t cells() const;
};

/// Part after part, in each by region. A part without cells has a run without cells, of region 1.
std::vector<RegionRun> region_runs(const MeshOutline& outline);

/// Reads each part once, without the nodes of its elements, and checks it. @throws InvalidInput
/// when a number is out of range, a node number belongs to no node, or the tets of a part are not
/// in the order of their regions. Memory: one part, and a bit for each node of the mesh.
MeshOutline outline_of(const MeshSource& source);

}  // namespace tetfarm
