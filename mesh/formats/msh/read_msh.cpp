#include "mesh/formats/msh/read_msh.h"

#include <limits>
#include <map>
#include <vector>

#include "mesh/formats/msh/msh_walker.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

/// The triangles and quadrangles, with the names of their physical groups as patches.
class SurfaceContent : public MshContent {
 public:
  explicit SurfaceContent(const InputScanner& in) : in_(in) {}

  void add_name(int dimension, std::int64_t group, std::string_view name) override {
    if (dimension == 2) group2name_[group] = name;
  }
  void add_node(std::int64_t tag, const Vec3& p) override {
    if (surface_.vertices.size() == std::numeric_limits<std::int32_t>::max()) {
      in_.fail("too many nodes");
    }
    tags_.add(tag);
    surface_.vertices.push_back(p);
  }
  void end_nodes() override {
    if (const auto twice = tags_.sort()) {
      in_.fail("two nodes have the tag " + std::to_string(*twice));
    }
  }
  bool wants(const MshElementType& type, std::int64_t number) override {
    if (type.dimension == 2 && number != msh_triangle && number != msh_quad) {
      in_.fail("a " + std::string(type.name) +
               ": only triangles of 3 nodes and quadrangles of 4 are supported");
    }
    return type.dimension == 2;
  }
  void add_element(const MshElement& element) override {
    corners_.clear();
    for (const std::int64_t node : element.nodes) {
      corners_.push_back(tags_.find(node));
      if (corners_.back() < 0) in_.fail("there is no node " + std::to_string(node));
    }
    if (surface_.triangles.empty() || element.group != last_group_) {
      last_group_ = element.group;
      last_patch_ = patches_.number_of(patch_name(element.group));
    }
    const std::size_t triangles = add_polygon(surface_, corners_);
    surface_.patch_of_triangle.insert(surface_.patch_of_triangle.end(), triangles, last_patch_);
  }

  SurfaceMesh take() {
    keep_used_vertices(surface_);
    surface_.patch_names = patches_.take();
    return std::move(surface_);
  }

 private:
  std::string patch_name(std::int64_t group) const {
    if (group == 0) return "";
    const auto named = group2name_.find(group);
    return named != group2name_.end() ? named->second : "physical " + std::to_string(group);
  }

  const InputScanner& in_;
  SurfaceMesh surface_;
  MshNodeTags tags_;
  PatchNames patches_;
  std::map<std::int64_t, std::string> group2name_;
  std::int64_t last_group_ = 0;
  std::int32_t last_patch_ = 0;
  std::vector<std::int32_t> corners_;  ///< of the element at hand
};

}  // namespace

SurfaceMesh read_msh(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name);
  SurfaceContent content(in);
  MshWalker(in).walk(content);
  return content.take();
}

}  // namespace tetfarm
