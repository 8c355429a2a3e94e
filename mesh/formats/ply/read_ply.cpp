#include "mesh/formats/ply/read_ply.h"

#include <array>
#include <limits>

#include "base/check.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

enum class Form { text, little, big };

/// A number's kind, by either of its names.
struct Kind {
  std::string_view name;
  std::string_view other_name;
  std::size_t bytes;
  bool is_real;
  bool is_signed;
};
constexpr std::array<Kind, 8> kinds = {{{"char", "int8", 1, false, true},
                                        {"uchar", "uint8", 1, false, false},
                                        {"short", "int16", 2, false, true},
                                        {"ushort", "uint16", 2, false, false},
                                        {"int", "int32", 4, false, true},
                                        {"uint", "uint32", 4, false, false},
                                        {"float", "float32", 4, true, true},
                                        {"double", "float64", 8, true, true}}};

struct Property {
  std::string_view name;
  Kind kind;
  Kind count_kind;  ///< of a list
  bool is_list = false;
};

struct Element {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name) : scanner_(bytes, name) {}

  SurfaceMesh read() {
    read_header();
    for (const Element& element : elements_) {
      // An element of no properties could be there any number of times without a byte.
      if (element.properties.empty()) continue;
      scanner_.to_count(element.count, 1);
      for (std::int64_t i = 0; i < element.count; ++i) read_element(element);
    }
    return std::move(surface_);
  }

 private:
  void read_header() {
    scanner_.expect("ply");
    for (;;) {
      const std::string_view word = scanner_.word();
      if (word == "format") {
        read_format();
      } else if (word == "element") {
        Element element;
        element.name = scanner_.word_in_line();
        element.count = scanner_.to_integer(scanner_.word_in_line(), "a number of elements");
        if (element.count < 0) scanner_.fail("a negative number of elements");
        elements_.push_back(element);
      } else if (word == "property") {
        if (elements_.empty()) scanner_.fail("a property before the first element");
        elements_.back().properties.push_back(read_property());
      } else if (word == "end_header") {
        scanner_.rest_of_line();
        return;
      } else if (word == "comment" || word == "obj_info") {
        scanner_.rest_of_line();
      } else {
        scanner_.fail("expected a line of the header, found " + quoted(word));
      }
    }
  }

  void read_format() {
    const std::string_view form = scanner_.word_in_line();
    if (form == "ascii") {
      form_ = Form::text;
    } else if (form == "binary_little_endian") {
      form_ = Form::little;
    } else if (form == "binary_big_endian") {
      form_ = Form::big;
    } else {
      scanner_.fail("unknown format " + quoted(form));
    }
    scanner_.rest_of_line();
  }

  Kind kind_of(std::string_view word) const {
    for (const Kind& kind : kinds) {
      if (word == kind.name || word == kind.other_name) return kind;
    }
    scanner_.fail("expected a type of number, found " + quoted(word));
  }

  Property read_property() {
    Property property;
    std::string_view word = scanner_.word_in_line();
    property.is_list = word == "list";
    if (property.is_list) {
      property.count_kind = kind_of(scanner_.word_in_line());
      if (property.count_kind.is_real) scanner_.fail("the length of a list is not an integer");
      word = scanner_.word_in_line();
    }
    property.kind = kind_of(word);
    property.name = scanner_.word_in_line();
    return property;
  }

  template <class T>
  double raw() {
    return static_cast<double>(form_ == Form::little ? scanner_.raw<T>()
                                                     : scanner_.raw_turned<T>());
  }

  /// Integers of 32 bits and less are whole in a double.
  double number(const Kind& kind) {
    if (form_ == Form::text) return scanner_.coordinate();
    if (kind.is_real) return scanner_.finite(kind.bytes == 4 ? raw<float>() : raw<double>());
    if (kind.bytes == 1) return kind.is_signed ? raw<std::int8_t>() : raw<std::uint8_t>();
    if (kind.bytes == 2) return kind.is_signed ? raw<std::int16_t>() : raw<std::uint16_t>();
    TF_CHECK(kind.bytes == 4);
    return kind.is_signed ? raw<std::int32_t>() : raw<std::uint32_t>();
  }

  /// Of a quality or a normal, which may be anything, even "nan".
  void pass_over(const Kind& kind) {
    if (form_ != Form::text) {
      scanner_.skip_bytes(kind.bytes);
    } else if (scanner_.word().empty()) {
      scanner_.fail("the file ends too early");
    }
  }

  std::int64_t integer(const Kind& kind) {
    if (form_ == Form::text) return scanner_.integer("an integer");
    return static_cast<std::int64_t>(number(kind));
  }

  void read_element(const Element& element) {
    Vec3 point;
    for (const Property& property : element.properties) {
      if (property.is_list) {
        read_list(element, property);
        continue;
      }
      const std::size_t axis = std::string_view("xyz").find(property.name);
      if (element.name != "vertex" || property.name.size() != 1 || axis == property.name.npos) {
        pass_over(property.kind);
      } else {
        point[static_cast<int>(axis)] = number(property.kind);
      }
    }
    if (element.name != "vertex") return;
    if (surface_.vertices.size() >= std::numeric_limits<std::int32_t>::max()) {
      scanner_.fail("too many vertices");
    }
    surface_.vertices.push_back(point);
  }

  void read_list(const Element& element, const Property& property) {
    const std::int64_t count = integer(property.count_kind);
    const std::size_t length = scanner_.to_count(count, 1);
    const bool has_corners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (element.name == "tristrips" && has_corners) return read_strips(property.kind, length);
    const bool is_face = element.name == "face" && has_corners;
    if (is_face && length < 3) scanner_.fail("a face with " + std::to_string(length) + " vertices");
    corners_.clear();
    for (std::size_t i = 0; i < length; ++i) {
      if (is_face) {
        corners_.push_back(vertex_of(scanner_, surface_, integer(property.kind), 0));
      } else {
        pass_over(property.kind);
      }
    }
    if (is_face) add_polygon(surface_, corners_);
  }

  /// Each corner after the first two makes a triangle with the two before it, every other one
  /// turned round; -1 ends a strip. A corner that is there twice only turns the rest.
  void read_strips(const Kind& kind, std::size_t length) {
    std::array<std::int32_t, 2> before = {-1, -1};
    bool is_turned = false;
    for (std::size_t i = 0; i < length; ++i) {
      const std::int64_t number = integer(kind);
      if (number == -1) {
        before = {-1, -1};
        is_turned = false;
        continue;
      }
      const std::int32_t v = vertex_of(scanner_, surface_, number, 0);
      const auto [a, b] = before;
      before = {b, v};
      if (a < 0) continue;
      if (a != b && b != v && v != a) {
        surface_.triangles.push_back(is_turned ? Triangle{b, a, v} : Triangle{a, b, v});
      }
      is_turned = !is_turned;
    }
  }

  InputScanner scanner_;
  Form form_ = Form::text;
  std::vector<Element> elements_;
  SurfaceMesh surface_;
  std::vector<std::int32_t> corners_;  ///< of the face at hand
};

}  // namespace

SurfaceMesh read_ply(std::string_view bytes, const std::string& name) {
  return PlyReader(bytes, name).read();
}

}  // namespace tetfarm
