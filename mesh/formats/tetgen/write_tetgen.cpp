#include "mesh/formats/tetgen/write_tetgen.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// A file of one list: its first line, then records of one length.
class ListFile {
 public:
  ListFile(std::filesystem::path path, const std::string& first_line, std::int64_t record_bytes)
      : file_(std::move(path)), first_(std::ssize(first_line)), record_bytes_(record_bytes) {
    file_.write(0, first_line);
  }
  void write(std::int64_t record, std::string_view bytes) {
    TF_CHECK(record >= 0);
    file_.write(first_ + record * record_bytes_, bytes);
  }
  OutputFile& file() { return file_; }
  std::int64_t place() const { return first_; }

 private:
  OutputFile file_;
  std::int64_t first_;
  std::int64_t record_bytes_;
};

}  // namespace

void write_tetgen(const MeshSource& source, const MeshOutline& outline,
                  const std::filesystem::path& file) {
  require_tets_alone(outline, "TetGen files hold");
  TF_CHECK(outline.parts.size() == source.size());
  const std::string larger = "use meshb or msh41, which count with 64 bits";
  require_32_bits(outline.nodes, "nodes", "TetGen's files", larger);
  require_32_bits(outline.tets, "tets", "TetGen's files", larger);
  require_32_bits(outline.boundary_triangles, "boundary triangles", "TetGen's files", larger);
  const auto named = [&](const char* ending) {
    return std::filesystem::path(file).replace_extension(ending);
  };
  const NumberText style =
      NumberText::text(std::max({outline.nodes, outline.tets, outline.boundary_triangles}));
  ListFile nodes(named(".node"), std::to_string(outline.nodes) + " 3 0 0\n",
                 style.record_bytes(1, 3));
  ListFile faces(named(".face"), std::to_string(outline.boundary_triangles) + " 1\n",
                 style.record_bytes(5, 0));
  ListFile tets(named(".ele"), std::to_string(outline.tets) + " 4 1\n", style.record_bytes(6, 0));
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
    std::int64_t face_number = outline.parts[i].first_face;
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      lines.integer(face_number++);
      for (const std::int32_t v : part.faces[f]) lines.integer(global_node(part, v));
      lines.integer(part.patch_of_face[f] + 1);
      lines.end_record();
    }
    faces.write(outline.parts[i].first_face, lines.take());
    std::int64_t tet_number = outline.parts[i].first_tet;
    for (std::size_t t = 0; t < part.tets.size(); ++t) {
      lines.integer(tet_number++);
      for (const std::int32_t v : part.tets[t]) lines.integer(global_node(part, v));
      lines.integer(part.region_of(t));
      lines.end_record();
    }
    tets.write(outline.parts[i].first_tet, lines.take());
  }
  for (ListFile* list : {&nodes, &faces, &tets}) list->file().finish();
}

}  // namespace tetfarm
