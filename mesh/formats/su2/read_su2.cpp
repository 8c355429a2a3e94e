#include "mesh/formats/su2/read_su2.h"

#include <array>
#include <limits>
#include <utility>

#include "mesh/formats/patch_names.h"
#include "mesh/formats/su2/su2_walker.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

/// The triangles of the markers, or those among the elements when there are none.
class SurfaceContent : public Su2Content {
 public:
  explicit SurfaceContent(const InputScanner& in) : in_(in) {}

  void add_node(const Vec3& p) override {
    if (surface_.vertices.size() == std::numeric_limits<std::int32_t>::max()) {
      in_.fail("too many nodes");
    }
    surface_.vertices.push_back(p);
  }
  void begin_marker(std::string_view name) override { patch_ = patches_.number_of(name); }
  bool wants(Su2List list, std::int64_t type, const InputScanner& in) override {
    if (list == Su2List::marker && type != su2_triangle) {
      in.fail("an element of a marker is not a triangle (5)");
    }
    return type == su2_triangle;
  }
  void add_element(Su2List list, std::int64_t, std::span<const std::int64_t> nodes) override {
    const Corners corners{{nodes[0], nodes[1], nodes[2]}, patch_};
    (list == Su2List::marker ? markers_ : elements_).push_back(corners);
  }

  SurfaceMesh take() {
    const bool has_markers = !markers_.empty();
    for (const Corners& corners : has_markers ? markers_ : elements_) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = vertex_of(in_, surface_, corners.nodes[k], 0);
      }
      surface_.triangles.push_back(triangle);
      if (has_markers) surface_.patch_of_triangle.push_back(corners.patch);
    }
    if (has_markers) surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  /// As the file has it: nodes may come after it.
  struct Corners {
    std::array<std::int64_t, 3> nodes{};
    std::int32_t patch = 0;
  };

  const InputScanner& in_;
  PatchNames patches_;
  std::int32_t patch_ = 0;
  std::vector<Corners> markers_;
  std::vector<Corners> elements_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh read_su2(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name, '%');
  SurfaceContent content(in);
  walk_su2(in, content);
  return content.take();
}

}  // namespace tetfarm
