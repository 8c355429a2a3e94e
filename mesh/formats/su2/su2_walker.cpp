#include "mesh/formats/su2/su2_walker.h"

#include <array>
#include <string>

#include "base/array_index.h"

namespace tetfarm {
namespace {

class Walker {
 public:
  Walker(InputScanner& in, Su2Content& content, int dimension)
      : in_(in), content_(content), dimension_(dimension) {}

  void walk() {
    while (!in_.at_end()) walk_keyword();
  }

 private:
  /// "KEY= VALUE", with or without blanks.
  void walk_keyword() {
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
      if (in_.to_integer(value, "the number of dimensions") != dimension_) {
        in_.fail(
            dimension_ == 3
                ? "the mesh is not three-dimensional; `tetfarm adapt` takes meshes of the plane"
                : "the mesh is not one of the plane");
      }
      in_.rest_of_line();
    } else if (key == "NELEM") {
      walk_elements(Su2List::elements, count(value, shortest_element()));
    } else if (key == "NPOIN") {
      walk_nodes(count(value, bytes_of(dimension_)));
    } else if (key == "MARKER_TAG") {
      content_.begin_marker(value);
      has_marker_ = true;
      in_.rest_of_line();
    } else if (key == "MARKER_ELEMS") {
      if (!has_marker_) in_.fail("MARKER_ELEMS before any MARKER_TAG");
      walk_elements(Su2List::marker, count(value, shortest_element()));
    } else {
      in_.rest_of_line();
    }
  }

  std::size_t count(std::string_view value, std::size_t bytes_each) {
    const std::size_t things = in_.to_count(in_.to_integer(value, "a count"), bytes_each);
    in_.rest_of_line();
    return things;
  }

  /// So many numbers of one digit, the last at the end of the file.
  static std::size_t bytes_of(int numbers) { return at(2 * numbers - 1); }
  /// A triangle with its type, and in the plane a vertex.
  std::size_t shortest_element() const { return bytes_of(dimension_ == 3 ? 4 : 2); }

  void walk_nodes(std::size_t nodes) {
    for (std::size_t i = 0; i < nodes; ++i) {
      Vec3 p;
      p.x = in_.coordinate();
      p.y = in_.coordinate_in_line();
      if (dimension_ == 3) p.z = in_.coordinate_in_line();
      in_.rest_of_line();
      content_.add_node(p);
    }
  }

  void walk_elements(Su2List list, std::size_t elements) {
    for (std::size_t i = 0; i < elements; ++i) {
      const std::int64_t type = in_.integer("the type of an element");
      if (!content_.wants(list, type, in_)) {
        in_.rest_of_line();
        continue;
      }
      const std::span<std::int64_t> nodes(nodes_.data(), nodes_of(type));
      for (std::int64_t& node : nodes) node = in_.to_integer(in_.word_in_line(), "a node number");
      in_.rest_of_line();
      content_.add_element(list, type, nodes);
    }
  }

  std::size_t nodes_of(std::int64_t type) const {
    if (type == su2_line) return 2;
    const std::optional<ElementType> known = type_of(ElementCodes::vtk, type);
    if (!known) in_.fail("unknown element type " + std::to_string(type));
    return tetfarm::nodes_of(*known);
  }

  InputScanner& in_;
  Su2Content& content_;
  int dimension_;
  bool has_marker_ = false;
  std::array<std::int64_t, most_element_nodes> nodes_{};
};

}  // namespace

void walk_su2(InputScanner& in, Su2Content& content, int dimension) {
  Walker(in, content, dimension).walk();
}

}  // namespace tetfarm
