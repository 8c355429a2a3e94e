/// The lists of a binary Medit file (.meshb, the GMF of libMeshb), read at their places: what the
/// readers of surfaces and of meshes have in common, and the keywords that the writer uses.
///
/// Source: libMeshb's documentation, "GMF file format": versions 1 to 4, in the order of bytes of
/// the machine that wrote it. Integers have 64 bits from version 4, places of lists from version 3,
/// coordinates 32 bits in version 1.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"
#include "mesh/formats/input_file.h"

namespace tetfarm {

namespace medit {

/// What says which list follows.
enum Keyword : std::int32_t {
  dimension = 3,
  vertices = 4,
  edges = 5,
  triangles = code_of(ElementCodes::medit, ElementType::triangle),
  quadrangles = code_of(ElementCodes::medit, ElementType::quad),
  tetrahedra = code_of(ElementCodes::medit, ElementType::tet),
  prisms = code_of(ElementCodes::medit, ElementType::prism),
  hexahedra = code_of(ElementCodes::medit, ElementType::hex),
  pyramids = code_of(ElementCodes::medit, ElementType::pyramid),
  corners = 13,
  end = 54,
  fields_at_vertices = 62
};

/// In the plane the dimension is 2, or 3 as some programs write it, and there are edges, corners
/// and fields beside the lists of a mesh in space.
enum class World { space, plane };

inline constexpr std::string_view not_of_space =
    "the mesh is not three-dimensional; `tetfarm adapt` takes meshes of the plane";

}  // namespace medit

/// Threads may read at once. Lists of other keywords are passed over.
class MeditFile {
 public:
  /// Finds the lists. @throws IoError; InvalidInput with the byte, also for a count that the file
  /// cannot hold.
  explicit MeditFile(const std::filesystem::path& path);
  /// Of bytes that outlive it.
  MeditFile(std::string_view bytes, const std::string& name,
            medit::World world = medit::World::space);

  const std::string& name() const { return file_.name(); }
  /// How many records of that kind the file has.
  std::int64_t count(medit::Keyword list) const;
  std::int64_t dimension() const { return dimension_; }
  /// What the fields at vertices are: 1 a number, 2 a vector, 3 a symmetric tensor.
  const std::vector<std::int64_t>& kinds_of_fields() const { return kinds_; }

  /// The numbers of all fields at the vertices from `first` on, vertex after vertex. @pre the span
  /// has room for whole records, and the list has them. @throws as read_vertices.
  void read_fields(std::int64_t first, std::span<double> into) const;

  /// Fills the span with the vertices from `first` on; in the plane z is 0. @pre the list has them.
  /// @throws IoError, InvalidInput for a coordinate that is not finite.
  void read_vertices(std::int64_t first, std::span<Vec3> into) const;
  /// The same with elements: their nodes, from 1, and behind them the reference. @pre N is one more
  /// than the nodes of an element of that list.
  template <std::size_t N>
  void read_elements(medit::Keyword list, std::int64_t first,
                     std::span<std::array<std::int64_t, N>> into) const {
    if (into.empty()) return;
    read_integers(lists_.at(list).place + first * static_cast<std::int64_t>(N) * integer_bytes(),
                  {reinterpret_cast<std::int64_t*>(into.data()), N * into.size()});
  }

  /// The numbers of records from `first` on, of lists whose elements are known only when the
  /// program runs. @pre the list has them.
  void read_numbers(medit::Keyword list, std::int64_t first, std::span<std::int64_t> into) const {
    if (!into.empty()) read_integers(lists_.at(list).place + first * record_bytes(list), into);
  }

  /// @throws InvalidInput for the head of that list, or for its `record`.
  [[noreturn]] void fail_at(medit::Keyword list, const std::string& what) const;
  [[noreturn]] void fail_at(medit::Keyword list, std::int64_t record,
                            const std::string& what) const;

 private:
  struct List {
    std::int64_t place = 0;  ///< of the first record
    std::int64_t count = 0;
  };

  void find_lists();
  std::int64_t read_keyword(std::int64_t place);
  void read_dimension(std::int64_t place);
  /// Returns where the records begin.
  std::int64_t read_kinds(std::int64_t place);
  /// As many as the span has, as they lie in the file.
  void take_reals(const char* bytes, std::span<double> into) const;
  void add_list(medit::Keyword keyword, std::int64_t place, std::int64_t next);
  /// Bytes of a record; 0 for a list that is passed over.
  std::int64_t record_bytes(medit::Keyword list) const;
  std::int64_t integer_bytes() const { return version_ < 4 ? 4 : 8; }
  std::int64_t place_bytes() const { return version_ < 3 ? 4 : 8; }
  std::int64_t real_bytes() const { return version_ == 1 ? 4 : 8; }
  std::int64_t integer_at(std::int64_t place, std::int64_t bytes) const;
  void read_integers(std::int64_t place, std::span<std::int64_t> into) const;

  InputFile file_;
  bool is_turned_ = false;
  std::int64_t version_ = 0;
  medit::World world_ = medit::World::space;
  std::int64_t dimension_ = 3;
  std::vector<std::int64_t> kinds_;
  std::int64_t reals_of_fields_ = 0;  ///< of all at one vertex
  std::map<medit::Keyword, List> lists_;
};

}  // namespace tetfarm
