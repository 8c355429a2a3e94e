/// The lists of a mesh that is read from its file once, from the beginning to the end: nodes and
/// tets are kept in files without names, so that any stretch can be read at any time.
///
/// For formats whose numbers are text, or lie where only who reads all before them knows. On disk
/// for the time: 24 bytes a node, 8 for each node of a cell.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesh/formats/listed_mesh.h"
#include "mesh/formats/scratch_file.h"

namespace tetfarm {

class ParsedMesh {
 public:
  using Nodes = ListedMesh::Nodes;

  /// @throws IoError, also later.
  explicit ParsedMesh(const std::filesystem::path& scratch_folder);

  /// The next node: numbers are 0, 1, … as they come.
  void add_node(const Vec3& p);
  /// A node by its number, when they come in another order. @pre number >= 0.
  void set_node(std::int64_t number, const Vec3& p);
  void add_tet(const Nodes& nodes, std::int32_t region = 1, std::int32_t subdomain = 0);
  void add_triangle(const std::array<std::int64_t, 3>& nodes, std::int32_t patch) {
    mesh_.triangles.push_back({nodes, patch});
  }
  /// A cell of any type, its nodes in our order.
  void add_cell(ElementType type, std::span<const std::int64_t> nodes, std::int32_t region = 1,
                std::int32_t subdomain = 0);
  /// A boundary face of any type.
  void add_face(ElementType type, std::span<const std::int64_t> nodes, std::int32_t patch);
  std::int64_t nodes() const { return nodes_; }
  std::int64_t tets() const { return tets_; }

  /// What names and numbers are known besides. Called once, after everything else.
  ListedMesh& mesh() { return mesh_; }
  ListedMesh take();

 private:
  void flush_nodes();
  void flush_tets();
  void flush_cells(ElementType type);

  /// Cells of a type in blocks.
  struct Cells {
    std::shared_ptr<ScratchFile> file;  ///< made for the first
    std::vector<std::int64_t> last_nodes;
  };

  ListedMesh mesh_;
  std::shared_ptr<ScratchFile> node_file_;
  std::shared_ptr<ScratchFile> tet_file_;
  std::vector<Vec3> last_nodes_;  // with the numbers before next_node_
  std::int64_t next_node_ = 0;
  std::int64_t nodes_ = 0;
  std::vector<Nodes> last_tets_;
  std::int64_t tets_ = 0;
  std::filesystem::path scratch_folder_;
  ByType<Cells> cells_;
};

}  // namespace tetfarm
