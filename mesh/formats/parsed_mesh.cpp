#include "mesh/formats/parsed_mesh.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::size_t records_at_once = 16384;

template <class Record>
std::function<void(std::int64_t, std::span<Record>)> reader_of(
    const std::shared_ptr<ScratchFile>& file) {
  return [file](std::int64_t first, std::span<Record> into) {
    file->read(first * static_cast<std::int64_t>(sizeof(Record)), into.data(), into.size_bytes());
  };
}

}  // namespace

ParsedMesh::ParsedMesh(const std::filesystem::path& scratch_folder)
    : node_file_(std::make_shared<ScratchFile>(scratch_folder)),
      tet_file_(std::make_shared<ScratchFile>(scratch_folder)),
      scratch_folder_(scratch_folder) {}

void ParsedMesh::add_node(const Vec3& p) { set_node(next_node_, p); }

void ParsedMesh::set_node(std::int64_t number, const Vec3& p) {
  if (number != next_node_ || last_nodes_.size() == records_at_once) flush_nodes();
  last_nodes_.push_back(p);
  next_node_ = number + 1;
  nodes_ = std::max(nodes_, next_node_);
}

void ParsedMesh::flush_nodes() {
  node_file_->write((next_node_ - std::ssize(last_nodes_)) * std::int64_t{sizeof(Vec3)},
                    last_nodes_.data(), last_nodes_.size() * sizeof(Vec3));
  last_nodes_.clear();
}

void ParsedMesh::add_tet(const Nodes& nodes, std::int32_t region, std::int32_t subdomain) {
  if (last_tets_.size() == records_at_once) flush_tets();
  last_tets_.push_back(nodes);
  add_tets(mesh_.runs, {1, region, subdomain});
  ++tets_;
}

void ParsedMesh::flush_tets() {
  tet_file_->append(last_tets_.data(), last_tets_.size() * sizeof(Nodes));
  last_tets_.clear();
}

void ParsedMesh::add_cell(ElementType type, std::span<const std::int64_t> nodes,
                          std::int32_t region, std::int32_t subdomain) {
  TF_CHECK(is_cell(type) && nodes.size() == nodes_of(type));
  if (type == ElementType::tet) {
    add_tet({nodes[0], nodes[1], nodes[2], nodes[3]}, region, subdomain);
    return;
  }
  Cells& cells = cells_[type];
  if (cells.last_nodes.size() >= records_at_once) flush_cells(type);
  cells.last_nodes.insert(cells.last_nodes.end(), nodes.begin(), nodes.end());
  add_tets(mesh_.cells[type].runs, {1, region, subdomain});
}

void ParsedMesh::add_face(ElementType type, std::span<const std::int64_t> nodes,
                          std::int32_t patch) {
  TF_CHECK(!is_cell(type) && nodes.size() == nodes_of(type));
  if (type == ElementType::triangle) {
    add_triangle({nodes[0], nodes[1], nodes[2]}, patch);
  } else {
    mesh_.quads.push_back({{nodes[0], nodes[1], nodes[2], nodes[3]}, patch});
  }
}

void ParsedMesh::flush_cells(ElementType type) {
  Cells& cells = cells_[type];
  if (!cells.file) cells.file = std::make_shared<ScratchFile>(scratch_folder_);
  cells.file->append(cells.last_nodes.data(), cells.last_nodes.size() * sizeof(std::int64_t));
  cells.last_nodes.clear();
}

ListedMesh ParsedMesh::take() {
  flush_nodes();
  flush_tets();
  mesh_.nodes = nodes_;
  mesh_.read_nodes = reader_of<Vec3>(node_file_);
  mesh_.read_tets = reader_of<Nodes>(tet_file_);
  for (const ElementType type : cell_block_types) {
    if (mesh_.cells[type].runs.empty()) continue;
    flush_cells(type);
    const auto bytes = static_cast<std::int64_t>(nodes_of(type) * sizeof(std::int64_t));
    mesh_.cells[type].read = [file = cells_[type].file, bytes](std::int64_t first,
                                                               std::span<std::int64_t> into) {
      file->read(first * bytes, into.data(), into.size_bytes());
    };
  }
  return std::move(mesh_);
}

}  // namespace tetfarm
