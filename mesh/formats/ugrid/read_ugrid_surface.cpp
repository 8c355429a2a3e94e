#include "mesh/formats/ugrid/read_ugrid_surface.h"

#include <array>
#include <limits>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

struct Form {
  std::string_view suffix;
  bool is_big = false;
  bool is_wide = false;   ///< integers of 64 bits
  bool is_short = false;  ///< coordinates of 32 bits
};
constexpr std::array<Form, 6> binary_forms = {{{".b8", true, false, false},
                                               {".lb8", false, false, false},
                                               {".b8l", true, true, false},
                                               {".lb8l", false, true, false},
                                               {".b4", true, false, true},
                                               {".lb4", false, false, true}}};

const Form* binary_form(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (const Form& form : binary_forms) {
    const std::string ending = std::string(form.suffix) + ".ugrid";
    if (name.ends_with(ending) || name.ends_with(ending + ".gz")) return &form;
  }
  return nullptr;
}

class UgridReader {
 public:
  UgridReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name), form_(binary_form(name)) {}

  SurfaceMesh read() {
    std::array<std::int64_t, 7> counts{};
    for (std::int64_t& count : counts) {
      count = integer("a count");
      if (count < 0) scanner_.fail("a count is negative");
    }
    if (counts[2] > 0) scanner_.fail("has quadrangles: only triangles are supported");
    const std::size_t nodes = scanner_.to_count(counts[0], form_ == nullptr ? 6 : 12);
    const std::size_t triangles = scanner_.to_count(counts[1], form_ == nullptr ? 8 : 16);
    if (nodes > std::numeric_limits<std::int32_t>::max()) scanner_.fail("too many nodes");
    surface_.vertices.reserve(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      const double x = coordinate();
      const double y = coordinate();
      surface_.vertices.push_back({x, y, coordinate()});
    }
    for (std::size_t i = 0; i < triangles; ++i) {
      Triangle triangle;
      for (std::int32_t& v : triangle) {
        v = vertex_of(scanner_, surface_, integer("a node number"), 1);
      }
      surface_.triangles.push_back(triangle);
    }
    PatchNames patches;
    for (std::size_t i = 0; i < triangles; ++i) {
      surface_.patch_of_triangle.push_back(
          patches.number_of("patch " + std::to_string(integer("a patch number"))));
    }
    surface_.patch_names = patches.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  template <class T>
  T raw() {
    return form_->is_big ? scanner_.raw_turned<T>() : scanner_.raw<T>();
  }
  std::int64_t integer(std::string_view what) {
    if (form_ == nullptr) return scanner_.integer(what);
    return form_->is_wide ? raw<std::int64_t>() : raw<std::int32_t>();
  }
  double coordinate() {
    if (form_ == nullptr) return scanner_.coordinate();
    return scanner_.finite(form_->is_short ? static_cast<double>(raw<float>()) : raw<double>());
  }

  InputScanner scanner_;
  const Form* form_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh read_ugrid_surface(std::string_view bytes, const std::string& name) {
  return UgridReader(bytes, name).read();
}

}  // namespace tetfarm
