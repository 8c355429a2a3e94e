#include "mesh/formats/su2/su2_source.h"

#include "mesh/formats/mesh_text.h"
#include "mesh/formats/parsed_mesh.h"
#include "mesh/formats/su2/su2_walker.h"

namespace tetfarm {
namespace {

class MeshContent : public Su2Content {
 public:
  MeshContent(MeshText& text, const std::filesystem::path& scratch_folder)
      : text_(text), mesh_(scratch_folder) {
    mesh_.mesh().name = text.name();
  }

  void add_node(const Vec3& p) override {
    mesh_.add_node(p);
    text_.pass();
  }
  void begin_marker(std::string_view name) override { mesh_.mesh().patch_names.emplace_back(name); }
  bool wants(Su2List list, std::int64_t type, const InputScanner& in) override {
    if (list == Su2List::elements && type != su2_tetra) in.fail("expected a tet, type 10");
    if (list == Su2List::marker && type != su2_triangle) in.fail("expected a triangle, type 5");
    return true;
  }
  void add_element(Su2List list, std::int64_t, std::span<const std::int64_t> nodes) override {
    if (list == Su2List::elements) {
      mesh_.add_tet({nodes[0], nodes[1], nodes[2], nodes[3]});
    } else {
      const auto patch = static_cast<std::int32_t>(mesh_.mesh().patch_names.size()) - 1;
      mesh_.add_triangle({nodes[0], nodes[1], nodes[2]}, patch);
    }
    text_.pass();
  }
  ListedMesh take() { return mesh_.take(); }

 private:
  MeshText& text_;
  ParsedMesh mesh_;
};

}  // namespace

std::unique_ptr<MeshSource> open_su2(const std::filesystem::path& path,
                                     const std::filesystem::path& scratch_folder) {
  MeshText text(path, '%');
  MeshContent content(text, scratch_folder);
  walk_su2(text.scanner(), content);
  return open_listed(content.take());
}

}  // namespace tetfarm
