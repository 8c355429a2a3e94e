/// Whether a finished mesh is right, told while its parts pass by (`tetfarm quality`): memory of
/// one part and a stated amount, whatever the size of the mesh.
///
/// Source: the invariants of mesh/core/tet_mesh.h and of thesis 4.3.4.2.2, for the whole mesh.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/file_system.h"
#include "base/hash.h"
#include "mesh/assemble/mesh_digest.h"
#include "mesh/core/complaints.h"
#include "mesh/quality/face_check.h"
#include "mesh/quality/forced_angles.h"
#include "mesh/quality/node_check.h"

namespace tetfarm {

struct MeshCheckOptions {
  bool faces = true;  ///< false: faces are not compared, all else is
  std::size_t memory_bytes = std::size_t{256} << 20;
  std::filesystem::path folder = temporary_folder();  ///< for what does not fit
};

struct MeshCheckResult {
  std::int64_t nodes = 0;  ///< each once
  double volume = 0;
  double enclosed_volume = 0;
  ForcedDihedral forced;
  Hash128 digest;  ///< see mesh_digest.h
  /// What is wrong, a line each with numbers and places, at most twenty: tets that are flat or
  /// turned, other cells that are so as a whole or at a corner (elements.h), nodes that no tet has
  /// or that parts have at different places, gaps in their numbers, faces that are neither shared
  /// by two cells nor a boundary face, boundary faces without their cell, volumes that do not add
  /// up to 1e-9. Empty for a right mesh.
  std::vector<std::string> complaints;
};

class MeshCheck {
 public:
  /// Reads each part once, without its elements. The source must outlive this.
  /// @throws InvalidInput when a node number is out of range; IoError; what the source throws.
  explicit MeshCheck(const MeshSource& source, const MeshCheckOptions& options = {});

  /// Parts 0, 1, … of the source. @pre the elements' nodes are the part's.
  void add(const NumberedPart& part);
  /// Called once, after the last part. Reads all parts again when faces are wrong.
  MeshCheckResult finish();

 private:
  void add_tets(const NumberedPart& part);
  void add_other_cells(const NumberedPart& part, std::vector<bool>& is_used);
  void add_other_faces(const NumberedPart& part);
  void complain_of_unused(const NumberedPart& part, const std::vector<bool>& is_used);
  void add_faces(const NumberedPart& part);
  std::string where(const NumberedPart& part) const;

  const MeshSource& source_;
  NodeCheck nodes_;
  ForcedAngles angles_;
  std::optional<FaceCheck> faces_;
  MeshDigest digest_;
  Complaints complaints_;
  std::optional<Vec3> origin_;  ///< volumes are of cones from here
  long double volume_ = 0;
  long double enclosed_ = 0;
  std::int64_t tets_ = 0;
  ElementCounts others_;
};

/// Of a whole mesh, for who wants nothing else.
MeshCheckResult check_mesh(const MeshSource& source, const MeshCheckOptions& options = {});

}  // namespace tetfarm
