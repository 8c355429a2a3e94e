/// The lists of a binary UGRID file, read at their places: what the readers of surfaces and of
/// meshes have in common.
///
/// Source: UG_IO documentation, "UGRID file type": seven counts, then the lists of nodes,
/// triangles, quadrangles, patches of both, tets, pyramids, prisms and hexahedra. C order, no
/// records of Fortran.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"
#include "mesh/formats/input_file.h"

namespace tetfarm {

struct UgridForm {
  bool big_endian = false;
  bool wide = false;         ///< integers of 64 bits
  bool short_reals = false;  ///< coordinates of 32 bits
};

/// What stands before .ugrid tells the form: b8, lb8, b8l, lb8l, b4 or lb4, in upper or lower case,
/// also with .gz behind. Nothing for any other name: that is text.
std::optional<UgridForm> ugrid_form(std::string name);

struct UgridListCounts {
  std::int64_t nodes = 0;
  std::int64_t triangles = 0;
  std::int64_t quadrangles = 0;
  std::int64_t tets = 0;
  std::int64_t pyramids = 0;
  std::int64_t prisms = 0;
  std::int64_t hexahedra = 0;

  std::int64_t of(ElementType type) const;
};

/// Threads may read at once. Nodes count from 1, as in the file.
class UgridFile {
 public:
  /// @throws IoError; InvalidInput with the byte, also when the file ends before its patches do.
  UgridFile(const std::filesystem::path& path, UgridForm form);
  /// Of bytes that outlive it.
  UgridFile(std::string_view bytes, const std::string& name, UgridForm form);

  const UgridListCounts& counts() const { return counts_; }
  const std::string& name() const { return file_.name(); }
  std::int64_t size() const { return file_.size(); }
  /// Where the file ends when its counts are right.
  std::int64_t expected_size() const;

  /// Fill the spans with those from `first` on. @pre the lists have them. @throws IoError,
  /// InvalidInput for a coordinate that is not finite.
  void read_nodes(std::int64_t first, std::span<Vec3> into) const;
  void read_triangles(std::int64_t first, std::span<std::array<std::int64_t, 3>> into) const;
  void read_patches(std::int64_t first, std::span<std::int64_t> into) const;
  void read_tets(std::int64_t first, std::span<std::array<std::int64_t, 4>> into) const;
  /// The nodes of consecutive elements of a type from `first` on.
  void read_elements(ElementType type, std::int64_t first, std::span<std::int64_t> into) const;

  /// @throws InvalidInput for the place of a quadrangle, or of a triangle's corner.
  [[noreturn]] void fail_at_quadrangle(const std::string& what, std::int64_t quadrangle) const;
  [[noreturn]] void fail_at_corner(const std::string& what, std::int64_t triangle,
                                   std::size_t corner) const;
  /// @throws InvalidInput for the counts.
  [[noreturn]] void fail_at_counts(const std::string& what) const { file_.fail(what, 0); }

 private:
  void read_counts();
  std::int64_t integer_bytes() const { return form_.wide ? 8 : 4; }
  std::int64_t node_bytes() const { return form_.short_reals ? 12 : 24; }
  std::int64_t node_place(std::int64_t node) const;
  std::int64_t triangle_place(std::int64_t triangle) const;
  std::int64_t patch_place(std::int64_t face) const;
  std::int64_t tet_place(std::int64_t tet) const;
  std::int64_t element_place(ElementType type, std::int64_t i) const;
  void read_integers(std::int64_t place, std::span<std::int64_t> into) const;
  template <class Number>
  void read(std::int64_t place, std::span<Number> into) const;

  InputFile file_;
  UgridForm form_;
  UgridListCounts counts_;
};

}  // namespace tetfarm
