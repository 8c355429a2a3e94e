#include "mesh/formats/write_tetgen.h"

#include <algorithm>

#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// A file of one list: its first line, then records one after the other.
class ListFile {
 public:
  ListFile(std::filesystem::path path, const std::string& first_line) : file_(std::move(path)) {
    append(first_line);
  }
  void append(std::string_view bytes) {
    file_.write(place_, bytes);
    place_ += std::ssize(bytes);
  }
  OutputFile& file() { return file_; }
  std::int64_t place() const { return place_; }

 private:
  OutputFile file_;
  std::int64_t place_ = 0;
};

}  // namespace

void write_tetgen(const MeshSource& source, const MeshOutline& outline,
                  const std::filesystem::path& file) {
  const auto named = [&](const char* ending) {
    return std::filesystem::path(file).replace_extension(ending);
  };
  const NumberText style =
      NumberText::text(std::max({outline.nodes, outline.tets, outline.boundary_triangles}));
  ListFile nodes(named(".node"), std::to_string(outline.nodes) + " 3 0 0\n");
  ListFile faces(named(".face"), std::to_string(outline.boundary_triangles) + " 1\n");
  ListFile tets(named(".ele"), std::to_string(outline.tets) + " 4 1\n");
  std::int64_t face_number = 0;
  std::int64_t tet_number = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    write_node_records(nodes.file(), nodes.place(), style.record_bytes(1, 3), part, style,
                       [](NumberText& numbers, std::int64_t number, const Vec3& p) {
                         numbers.integer(number);
                         numbers.real(p.x);
                         numbers.real(p.y);
                         numbers.real(p.z);
                         numbers.end_record();
                       });
    NumberText lines = style;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      lines.integer(face_number++);
      for (const std::int32_t v : part.faces[f]) lines.integer(global_node(part, v));
      lines.integer(part.patch_of_face[f] + 1);
      lines.end_record();
    }
    faces.append(lines.take());
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      lines.integer(tet_number++);
      for (const std::int32_t v : part.tets[t]) lines.integer(global_node(part, v));
      lines.integer(part.region_of(t));
      lines.end_record();
    }
    tets.append(lines.take());
  }
  for (ListFile* list : {&nodes, &faces, &tets}) list->file().finish();
}

}  // namespace tetfarm
