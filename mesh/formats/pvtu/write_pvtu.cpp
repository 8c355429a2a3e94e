#include "mesh/formats/pvtu/write_pvtu.h"

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/assemble/output_file.h"
#include "mesh/core/element_block.h"

namespace tetfarm {
namespace {

constexpr std::int32_t no_patch = -1;

/// An array's description, and its place in the file.
struct Array {
  const char* type;
  const char* name;
  int components;
};

constexpr Array points = {"Float64", "Points", 3};
constexpr Array node_number = {"Int64", "GlobalNodeId", 1};
constexpr std::array<Array, 2> feet_of_nodes = {
    {{"Int64", foot_array, 1}, {"Int32", depth_array, 1}}};
constexpr std::array<Array, 3> cells = {
    {{"Int64", "connectivity", 1}, {"Int64", "offsets", 1}, {"UInt8", "types", 1}}};
constexpr std::array<Array, 3> cell_data = {
    {{"Int32", "subdomain", 1}, {"Int32", "region", 1}, {"Int32", "patch", 1}}};

/// What the pieces have besides what all have.
struct MoreArrays {
  std::vector<CellMark> marks;
  bool has_feet = false;
};

std::vector<Array> point_data_with(bool has_feet) {
  std::vector<Array> arrays = {node_number};
  if (has_feet) arrays.insert(arrays.end(), feet_of_nodes.begin(), feet_of_nodes.end());
  return arrays;
}

std::vector<Array> cell_data_with(const std::vector<CellMark>& marks) {
  std::vector<Array> arrays(cell_data.begin(), cell_data.end());
  for (const CellMark mark : marks) arrays.push_back({"Int32", name_of(mark), 1});
  return arrays;
}

std::string described(const char* tag, const Array& array) {
  return std::string("<") + tag + " type=\"" + array.type + "\" Name=\"" + array.name +
         "\" NumberOfComponents=\"" + std::to_string(array.components) + "\"";
}

std::string head(const char* type) {
  return std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"") + type +
         "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
}

/// Writes the arrays of a piece at their places, each behind its length.
class AppendedData {
 public:
  AppendedData(OutputFile& file, std::int64_t first, const VtuLayout& layout)
      : file_(file), first_(first), layout_(layout) {}
  template <class T>
  void add(const std::vector<T>& values) {
    const VtuLayout::Place& here = layout_.arrays[next_++];
    TF_CHECK(here.bytes == static_cast<std::int64_t>(values.size() * sizeof(T)));
    file_.write(first_ + here.offset, std::vector<std::int64_t>{here.bytes});
    file_.write(first_ + here.offset + VtuLayout::length_bytes, values);
  }

 private:
  OutputFile& file_;
  std::int64_t first_;
  const VtuLayout& layout_;
  std::size_t next_ = 0;
};

/// In VTK's order.
void append_nodes(ElementType type, const ElementBlock& block, std::vector<std::int64_t>& nodes) {
  const std::size_t count = nodes_of(type);
  for (std::size_t i = 0; i < block.size(); ++i) {
    nodes.resize(nodes.size() + count);
    put_in_order_of(ElementCodes::vtk, type, block.element(type, i), std::span(nodes).last(count));
  }
}

/// Tets, other cells, triangles, quads: calls visit(type, how many).
template <class Visit>
void for_each_type(const NumberedPart& part, const Visit& visit) {
  visit(ElementType::tet, part.tets.size());
  for (const ElementType type : cell_block_types) visit(type, part.blocks[type].size());
  visit(ElementType::triangle, part.faces.size());
  for (const ElementType type : face_block_types) visit(type, part.blocks[type].size());
}

std::int64_t connected_nodes(const NumberedPart& part) {
  std::size_t nodes = 0;
  for_each_type(part,
                [&](ElementType type, std::size_t count) { nodes += nodes_of(type) * count; });
  return static_cast<std::int64_t>(nodes);
}

std::vector<std::int32_t> mark_of_cells(const NumberedPart& part, CellMark mark,
                                        std::size_t count) {
  std::vector<std::int32_t> values = part.marks[mark];
  TF_CHECK(values.empty() || std::ssize(values) == cells_of(part));
  values.resize(count, 0);
  return values;
}

NodeFeet feet_of_all(const NumberedPart& part) {
  if (!part.feet.empty()) return part.feet;
  return {std::vector<std::int64_t>(part.nodes.size(), no_foot),
          std::vector<std::int32_t>(part.nodes.size(), no_foot)};
}

void write_point_arrays(const NumberedPart& part, bool has_feet, AppendedData& data) {
  data.add(part.nodes);
  data.add(part.local2global);
  if (!has_feet) return;
  const NodeFeet feet = feet_of_all(part);
  data.add(feet.foot);
  data.add(feet.depth);
}

void write_arrays(const NumberedPart& part, const MoreArrays& more, AppendedData data) {
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  const auto cells_of_part = static_cast<std::size_t>(cells_of(part));
  const std::size_t count = cells_of_part + static_cast<std::size_t>(boundary_faces_of(part));
  std::vector<std::int64_t> numbers;
  numbers.reserve(static_cast<std::size_t>(connected_nodes(part)));
  for (const Tet& tet : part.tets) numbers.insert(numbers.end(), tet.begin(), tet.end());
  for (const ElementType type : cell_block_types) append_nodes(type, part.blocks[type], numbers);
  for (const Triangle& face : part.faces) numbers.insert(numbers.end(), face.begin(), face.end());
  for (const ElementType type : face_block_types) append_nodes(type, part.blocks[type], numbers);
  write_point_arrays(part, more.has_feet, data);
  data.add(numbers);
  numbers.clear();
  std::vector<std::uint8_t> types;
  std::int64_t end = 0;
  for_each_type(part, [&](ElementType type, std::size_t of_type) {
    for (std::size_t i = 0; i < of_type; ++i) {
      numbers.push_back(end += static_cast<std::int64_t>(nodes_of(type)));
    }
    types.resize(types.size() + of_type,
                 static_cast<std::uint8_t>(code_of(ElementCodes::vtk, type)));
  });
  data.add(numbers);
  data.add(types);
  data.add(std::vector<std::int32_t>(count, part.number));
  std::vector<std::int32_t> regions = regions_of_cells(part);
  const std::vector<std::int32_t> of_boundary = regions_of_boundary(part);
  regions.insert(regions.end(), of_boundary.begin(), of_boundary.end());
  data.add(regions);
  std::vector<std::int32_t> patches(cells_of_part, no_patch);
  patches.insert(patches.end(), part.patch_of_face.begin(), part.patch_of_face.end());
  for (const ElementType type : face_block_types) {
    const std::vector<std::int32_t>& of_type = part.blocks[type].patches;
    patches.insert(patches.end(), of_type.begin(), of_type.end());
  }
  data.add(patches);
  for (const CellMark mark : more.marks) data.add(mark_of_cells(part, mark, count));
}

void write_piece(const NumberedPart& part, const MoreArrays& more,
                 const std::filesystem::path& path) {
  const std::int64_t cells_of_piece = cells_of(part) + boundary_faces_of(part);
  const VtuLayout layout = vtu_layout(std::ssize(part.nodes), cells_of_piece, connected_nodes(part),
                                      more.marks.size(), more.has_feet);
  std::size_t next = 0;
  const auto array = [&](const Array& what) {
    return described("DataArray", what) + " format=\"appended\" offset=\"" +
           std::to_string(layout.arrays[next++].offset) + "\"/>\n";
  };
  std::string text = head("UnstructuredGrid") + "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                     std::to_string(part.nodes.size()) + "\" NumberOfCells=\"" +
                     std::to_string(cells_of_piece) + "\">\n<Points>\n";
  text += array(points);
  text += "</Points>\n<PointData>\n";
  for (const Array& what : point_data_with(more.has_feet)) text += array(what);
  text += "</PointData>\n<Cells>\n";
  for (const Array& what : cells) text += array(what);
  text += "</Cells>\n<CellData>\n";
  for (const Array& what : cell_data_with(more.marks)) text += array(what);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  OutputFile file(path);
  file.write(0, text);
  write_arrays(part, more, {file, std::ssize(text), layout});
  // The line's end belongs there: meshio looks for the last one to find the end of the data.
  file.write(std::ssize(text) + layout.bytes, std::string_view("\n</AppendedData>\n</VTKFile>\n"));
  file.finish();
}

}  // namespace

VtuLayout vtu_layout(std::int64_t points, std::int64_t cells_of_piece, std::int64_t cell_nodes,
                     std::size_t marks, bool has_feet) {
  VtuLayout layout;
  std::vector<std::int64_t> sizes = {24 * points, 8 * points};
  if (has_feet) sizes.insert(sizes.end(), {8 * points, 4 * points});
  sizes.insert(sizes.end(), {8 * cell_nodes, 8 * cells_of_piece, cells_of_piece});
  sizes.resize(sizes.size() + cell_data.size() + marks, 4 * cells_of_piece);
  for (const std::int64_t bytes : sizes) {
    layout.arrays.push_back({layout.bytes, bytes});
    layout.bytes += VtuLayout::length_bytes + bytes;
  }
  return layout;
}

void write_pvtu(const MeshSource& source, const MeshOutline&, const std::filesystem::path& path) {
  static_assert(sizeof(Vec3) == 24);
  const std::string stem = path.stem().string();
  if (stem == path.filename()) {
    throw UsageError("give the file an ending: the pieces go into a folder of its name without it",
                     path.string());
  }
  make_folders(path.parent_path() / stem);
  const MoreArrays more = {source.cell_marks(), source.has_feet()};
  std::string text = head("PUnstructuredGrid") +
                     "<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n" +
                     described("PDataArray", points) + "/>\n</PPoints>\n<PPointData>\n";
  for (const Array& what : point_data_with(more.has_feet)) {
    text += described("PDataArray", what) + "/>\n";
  }
  text += "</PPointData>\n<PCellData>\n";
  for (const Array& what : cell_data_with(more.marks)) {
    text += described("PDataArray", what) + "/>\n";
  }
  text += "</PCellData>\n";
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::string piece = stem + "/" + stem + "_" + std::to_string(i) + ".vtu";
    write_piece(source.part(i), more, path.parent_path() / piece);
    text += "<Piece Source=\"" + piece + "\"/>\n";
  }
  write_file_atomically(path, text + "</PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace tetfarm
