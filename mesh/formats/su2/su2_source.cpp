#include "mesh/formats/su2/su2_source.h"

#include "mesh/formats/mesh_text.h"
#include "mesh/formats/parsed_mesh.h"

namespace tetfarm {
namespace {

constexpr std::int64_t vtk_triangle = 5;
constexpr std::int64_t vtk_tetra = 10;

class Su2Reader {
 public:
  Su2Reader(const std::filesystem::path& path, const std::filesystem::path& scratch_folder)
      : text_(path, '%'), in_(text_.scanner()), mesh_(scratch_folder) {
    mesh_.mesh().name = text_.name();
  }

  ListedMesh read() {
    while (!in_.at_end()) read_keyword();
    return mesh_.take();
  }

 private:
  /// "KEY= VALUE", with or without blanks: the value is left to be read.
  void read_keyword() {
    std::string_view word = in_.word_in_line();
    const std::size_t equals = word.find('=');
    const std::string_view key = word.substr(0, equals);
    std::string_view value;
    if (equals != word.npos) {
      value = word.substr(equals + 1);
    } else {
      value = in_.word_in_line();
      if (!value.starts_with('=')) in_.fail("expected KEYWORD=, found " + quoted(word));
      value.remove_prefix(1);
    }
    if (value.empty()) value = in_.word_in_line();
    if (key == "NDIME") {
      if (value != "3") in_.fail("the mesh is not three-dimensional");
    } else if (key == "NELEM") {
      return read_tets(count(value, 10));
    } else if (key == "NPOIN") {
      return read_nodes(count(value, 6));
    } else if (key == "MARKER_TAG") {
      mesh_.mesh().patch_names.emplace_back(value);
    } else if (key == "MARKER_ELEMS") {
      return read_triangles(count(value, 8));
    } else if (key != "NMARK") {
      in_.fail("unknown keyword " + quoted(key));
    }
    in_.rest_of_line();
  }

  std::size_t count(std::string_view value, std::size_t least_bytes) const {
    return in_.to_count(in_.to_integer(value, "a count"), least_bytes);
  }

  template <std::size_t N>
  std::array<std::int64_t, N> element(std::int64_t type, const char* what) {
    if (in_.integer("an element type") != type) in_.fail(std::string("expected ") + what);
    std::array<std::int64_t, N> nodes;
    for (std::int64_t& node : nodes) node = in_.to_integer(in_.word_in_line(), "a node number");
    in_.rest_of_line();
    text_.pass();
    return nodes;
  }

  void read_tets(std::size_t count) {
    in_.rest_of_line();
    for (std::size_t i = 0; i < count; ++i) mesh_.add_tet(element<4>(vtk_tetra, "a tet, type 10"));
  }

  void read_triangles(std::size_t count) {
    if (mesh_.mesh().patch_names.empty()) in_.fail("MARKER_ELEMS before any MARKER_TAG");
    const auto patch = static_cast<std::int32_t>(mesh_.mesh().patch_names.size()) - 1;
    in_.rest_of_line();
    for (std::size_t i = 0; i < count; ++i) {
      mesh_.add_triangle(element<3>(vtk_triangle, "a triangle, type 5"), patch);
    }
  }

  void read_nodes(std::size_t count) {
    in_.rest_of_line();
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 p;
      p.x = in_.coordinate();
      p.y = in_.coordinate_in_line();
      p.z = in_.coordinate_in_line();
      mesh_.add_node(p);
      in_.rest_of_line();
      text_.pass();
    }
  }

  MeshText text_;
  InputScanner& in_;
  ParsedMesh mesh_;
};

}  // namespace

std::unique_ptr<MeshSource> open_su2(const std::filesystem::path& path,
                                     const std::filesystem::path& scratch_folder) {
  return open_listed(Su2Reader(path, scratch_folder).read());
}

}  // namespace tetfarm
