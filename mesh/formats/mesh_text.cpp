#include "mesh/formats/mesh_text.h"

namespace tetfarm {

MeshText::MeshText(const std::filesystem::path& path, char comment)
    : name_(path.string()), file_(path), scanner_(file_.bytes(), name_, comment) {}

void MeshText::let_go() const { file_.let_go(file_.bytes().size() - scanner_.bytes_left()); }

}  // namespace tetfarm
