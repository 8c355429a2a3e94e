/// The files of an OpenFOAM polyMesh, as text: lists of equal records, and the list of patches.
///
/// Source: OpenFOAM user guide, "Mesh files".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/assemble/output_file.h"
#include "mesh/core/face_nodes.h"
#include "mesh/core/patch_type.h"
#include "mesh/core/vec3.h"
#include "mesh/formats/number_text.h"

namespace tetfarm {

/// A list whose length is known beforehand. Records have one length: any can be written at any
/// time, or each behind the last.
class FoamList {
 public:
  struct Kind {
    const char* object;      ///< the file's name
    const char* foam_class;  ///< "labelList"
    std::int64_t record_bytes = 0;
    std::string note;  ///< for people and readers; may be empty
  };
  /// @throws IoError, as all that follows.
  FoamList(const std::filesystem::path& folder, const Kind& kind, std::int64_t records);

  void write(std::int64_t record, std::string_view bytes);
  void append(std::string_view bytes);
  std::int64_t first_place() const { return first_; }
  OutputFile& file() { return file_; }
  void finish();

 private:
  OutputFile file_;
  std::int64_t record_bytes_;
  std::int64_t records_;
  std::int64_t first_ = 0;
  std::int64_t next_ = 0;
};

std::int64_t foam_point_bytes(const NumberText& style);
/// Of a face with so many corners, or with fewer and blanks behind it.
std::int64_t foam_face_bytes(const NumberText& style, std::size_t most_corners);
std::int64_t foam_label_bytes(const NumberText& style);
void put_foam_point(NumberText& text, const Vec3& p);
/// @pre at most `most_corners` nodes.
void put_foam_face(NumberText& text, const FaceNodes<std::int64_t>& nodes,
                   std::size_t most_corners);
void put_foam_label(NumberText& text, std::int64_t label);

struct FoamPatch {
  std::string name;
  std::int64_t faces = 0;
  std::int64_t first_face = 0;
  int processor = -1;  ///< of a patch between two processors: this one
  int neighbour = -1;
  const char* type = "patch";  ///< of one that is not between processors
};

/// "patch" where OpenFOAM has no type of its own that fits.
const char* foam_type(PatchType type);

/// What OpenFOAM's programs and ParaView want in a folder before they take it for a case:
/// system/controlDict, fvSchemes and fvSolution, with `parts` > 0 decomposeParDict, and case.foam.
/// Schemes and solvers are left for the user to choose. A file that is there stays as it is.
/// @throws IoError.
void write_foam_system(const std::filesystem::path& folder, std::size_t parts);

/// The file `boundary`. @throws IoError.
void write_foam_boundary(const std::filesystem::path& folder,
                         const std::vector<FoamPatch>& patches);

/// Cells first … first + count - 1 of a zone.
struct FoamZoneRun {
  std::size_t zone = 0;
  std::int64_t first = 0;
  std::int64_t count = 0;
};

/// The file `cellZones`: a zone for each name. Written piece by piece. @throws IoError.
void write_foam_zones(const std::filesystem::path& folder, const std::vector<std::string>& names,
                      const std::vector<FoamZoneRun>& runs);

}  // namespace tetfarm
