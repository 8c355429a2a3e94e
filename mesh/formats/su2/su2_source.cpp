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
    const std::optional<ElementType> known = type_of(ElementCodes::vtk, type);
    if (list == Su2List::elements && !(known && is_cell(*known))) {
      in.fail("expected a tet, a hex, a prism or a pyramid, type 10, 12, 13 or 14");
    }
    if (list == Su2List::marker && !(known && !is_cell(*known))) {
      in.fail("expected a triangle or a quad, type 5 or 9");
    }
    return true;
  }
  void add_element(Su2List list, std::int64_t code, std::span<const std::int64_t> nodes) override {
    const ElementType type = type_of(ElementCodes::vtk, code).value();
    std::array<std::int64_t, most_element_nodes> ours{};
    take_from_order_of(ElementCodes::vtk, type, nodes, std::span<std::int64_t>(ours));
    const std::span<const std::int64_t> element(ours.data(), nodes.size());
    if (list == Su2List::elements) {
      mesh_.add_cell(type, element);
    } else {
      mesh_.add_face(type, element, static_cast<std::int32_t>(mesh_.mesh().patch_names.size()) - 1);
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
