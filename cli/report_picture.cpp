#include "cli/report_picture.h"

namespace tetfarm {

ReportPicture picture_of(const MeshSource& mesh, const RenderOptions& options,
                         const std::string& caption) {
  const ForEachPart for_each_part = [&mesh](const auto& visit) {
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      NumberedPart part = mesh.part(i);
      visit(part);
    }
  };
  return {caption, png_of(render_mesh(for_each_part, mesh.patch_names(), options))};
}

}  // namespace tetfarm
