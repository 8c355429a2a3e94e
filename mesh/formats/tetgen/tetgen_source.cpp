#include "mesh/formats/tetgen/tetgen_source.h"

#include <algorithm>
#include <limits>

#include "mesh/formats/mesh_text.h"
#include "mesh/formats/parsed_mesh.h"
#include "mesh/formats/tetgen/tetgen_lists.h"

namespace tetfarm {
namespace {

/// A file of elements: a line of counts, then records that begin with their numbers.
class ElementList {
 public:
  explicit ElementList(const std::filesystem::path& path)
      : text_(path, tetgen_comment),
        in_(text_.scanner()),
        count_(static_cast<std::int64_t>(tetgen_count(in_, "a count"))) {}

  const std::string& name() const { return text_.name(); }
  InputScanner& in() { return in_; }
  std::int64_t count() const { return count_; }
  /// A number of the first line.
  std::int64_t option() { return integer(); }
  void end_line() {
    in_.rest_of_line();
    text_.pass();
  }
  /// The number of the next record must be `expected`.
  void begin_record(std::int64_t expected) {
    if (in_.integer("a number") != expected) {
      in_.fail("expected record " + std::to_string(expected));
    }
  }
  std::int64_t integer() { return in_.to_integer(in_.word_in_line(), "a number"); }
  std::int32_t small() {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(integer(), 0, most));
  }

 private:
  MeshText text_;
  InputScanner& in_;
  std::int64_t count_;
};

/// Returns the number of the first.
std::int64_t read_nodes(const std::filesystem::path& path, ParsedMesh& mesh) {
  MeshText text(path, tetgen_comment);
  return walk_tetgen_nodes(text.scanner(), [&](const Vec3& p) {
    mesh.add_node(p);
    text.pass();
  });
}

void read_tets(const std::filesystem::path& path, std::int64_t first, ParsedMesh& mesh) {
  ElementList file(path);
  mesh.mesh().name = file.name();
  if (file.option() != 4) file.in().fail("only tets of four nodes are supported");
  const bool has_regions = file.option() > 0;
  file.end_line();
  for (std::int64_t i = 0; i < file.count(); ++i) {
    file.begin_record(first + i);
    ParsedMesh::Nodes nodes;
    for (std::int64_t& node : nodes) node = file.integer() - first;
    mesh.add_tet(nodes, has_regions ? file.small() : 1);
    file.end_line();
  }
}

void read_faces(const std::filesystem::path& path, std::int64_t first, ParsedMesh& mesh) {
  ElementList file(path);
  const bool has_marks = file.option() > 0;
  file.end_line();
  for (std::int64_t i = 0; i < file.count(); ++i) {
    file.begin_record(first + i);
    std::array<std::int64_t, 3> nodes;
    for (std::int64_t& node : nodes) node = file.integer() - first;
    mesh.add_triangle(nodes, has_marks ? file.small() - 1 : 0);
    file.end_line();
  }
}

}  // namespace

std::unique_ptr<MeshSource> open_tetgen(const std::filesystem::path& path,
                                        const std::filesystem::path& scratch_folder) {
  const auto with_ending = [&](const char* ending) {
    return std::filesystem::path(path).replace_extension(ending);
  };
  ParsedMesh mesh(scratch_folder);
  const std::int64_t first = read_nodes(with_ending(".node"), mesh);
  read_faces(with_ending(".face"), first, mesh);
  read_tets(with_ending(".ele"), first, mesh);
  return open_listed(mesh.take());
}

}  // namespace tetfarm
