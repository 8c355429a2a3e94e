#include "mesh/formats/su2/read_su2.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/su2/su2_walker.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

/// The triangles and quadrangles of the markers, or those among the elements when there are none.
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
    const bool is_face = type == su2_triangle || type == su2_quad;
    if (list == Su2List::marker && !is_face) {
      in.fail("an element of a marker has the type " + std::to_string(type) +
              ": expected a triangle (5) or a quadrangle (9)");
    }
    return is_face;
  }
  void add_element(Su2List list, std::int64_t, std::span<const std::int64_t> nodes) override {
    Face face;
    face.count = nodes.size();
    face.patch = patch_;
    std::ranges::copy(nodes, face.nodes.begin());
    (list == Su2List::marker ? markers_ : elements_).push_back(face);
  }

  SurfaceMesh take() {
    const bool has_markers = !markers_.empty();
    for (const Face& face : has_markers ? markers_ : elements_) {
      std::array<std::int32_t, 4> corners{};
      for (std::size_t k = 0; k < face.count; ++k) {
        corners[k] = vertex_of(in_, surface_, face.nodes[k], 0);
      }
      const std::size_t triangles = add_polygon(surface_, std::span(corners.data(), face.count));
      if (!has_markers) continue;
      surface_.patch_of_triangle.insert(surface_.patch_of_triangle.end(), triangles, face.patch);
    }
    if (has_markers) surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  /// As the file has it: nodes may come after it.
  struct Face {
    std::array<std::int64_t, 4> nodes{};
    std::size_t count = 0;  ///< of these
    std::int32_t patch = 0;
  };

  const InputScanner& in_;
  PatchNames patches_;
  std::int32_t patch_ = 0;
  std::vector<Face> markers_;
  std::vector<Face> elements_;
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
