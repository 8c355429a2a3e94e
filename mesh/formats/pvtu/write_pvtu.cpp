#include "mesh/formats/pvtu/write_pvtu.h"

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/assemble/output_file.h"
#include "mesh/core/elements.h"

namespace tetfarm {
namespace {

constexpr std::uint8_t vtk_triangle = code_of(ElementCodes::vtk, ElementType::triangle);
constexpr std::uint8_t vtk_tetra = code_of(ElementCodes::vtk, ElementType::tet);
constexpr std::int32_t no_patch = -1;

/// An array's description, and its place in the file.
struct Array {
  const char* type;
  const char* name;
  int components;
};

constexpr Array points = {"Float64", "Points", 3};
constexpr Array node_number = {"Int64", "GlobalNodeId", 1};
constexpr std::array<Array, 3> cells = {
    {{"Int64", "connectivity", 1}, {"Int64", "offsets", 1}, {"UInt8", "types", 1}}};
constexpr std::array<Array, 3> cell_data = {
    {{"Int32", "subdomain", 1}, {"Int32", "region", 1}, {"Int32", "patch", 1}}};

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

void write_arrays(const NumberedPart& part, AppendedData data) {
  const std::size_t count = part.tets.size() + part.faces.size();
  std::vector<std::int64_t> numbers;
  numbers.reserve(4 * part.tets.size() + 3 * part.faces.size());
  for (const Tet& tet : part.tets) numbers.insert(numbers.end(), tet.begin(), tet.end());
  for (const Triangle& face : part.faces) numbers.insert(numbers.end(), face.begin(), face.end());
  data.add(part.nodes);
  data.add(part.local2global);
  data.add(numbers);
  numbers.clear();
  std::int64_t end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    end += i < part.tets.size() ? 4 : 3;
    numbers.push_back(end);
  }
  data.add(numbers);
  std::vector<std::uint8_t> types(part.tets.size(), vtk_tetra);
  types.resize(count, vtk_triangle);
  data.add(types);
  data.add(std::vector<std::int32_t>(count, part.number));
  data.add(regions_of_cells(part));
  std::vector<std::int32_t> patches(part.tets.size(), no_patch);
  patches.insert(patches.end(), part.patch_of_face.begin(), part.patch_of_face.end());
  data.add(patches);
}

void write_piece(const NumberedPart& part, const std::filesystem::path& path) {
  const VtuLayout layout =
      vtu_layout(std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces));
  std::size_t next = 0;
  const auto array = [&](const Array& what) {
    return described("DataArray", what) + " format=\"appended\" offset=\"" +
           std::to_string(layout.arrays[next++].offset) + "\"/>\n";
  };
  std::string text = head("UnstructuredGrid") + "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                     std::to_string(part.nodes.size()) + "\" NumberOfCells=\"" +
                     std::to_string(part.tets.size() + part.faces.size()) + "\">\n<Points>\n";
  text += array(points);
  text += "</Points>\n<PointData>\n";
  text += array(node_number);
  text += "</PointData>\n<Cells>\n";
  for (const Array& what : cells) text += array(what);
  text += "</Cells>\n<CellData>\n";
  for (const Array& what : cell_data) text += array(what);
  text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  OutputFile file(path);
  file.write(0, text);
  write_arrays(part, {file, std::ssize(text), layout});
  // The line's end belongs there: meshio looks for the last one to find the end of the data.
  file.write(std::ssize(text) + layout.bytes, std::string_view("\n</AppendedData>\n</VTKFile>\n"));
  file.finish();
}

}  // namespace

VtuLayout vtu_layout(std::int64_t points, std::int64_t tets, std::int64_t triangles) {
  const std::int64_t cells_of_piece = tets + triangles;
  VtuLayout layout;
  std::size_t next = 0;
  for (const std::int64_t bytes :
       {24 * points, 8 * points, 8 * (4 * tets + 3 * triangles), 8 * cells_of_piece, cells_of_piece,
        4 * cells_of_piece, 4 * cells_of_piece, 4 * cells_of_piece}) {
    layout.arrays[next++] = {layout.bytes, bytes};
    layout.bytes += VtuLayout::length_bytes + bytes;
  }
  return layout;
}

void write_pvtu(const MeshSource& source, const MeshOutline&, const std::filesystem::path& path) {
  static_assert(sizeof(Vec3) == 24);
  const std::string stem = path.stem().string();
  make_folders(path.parent_path() / stem);
  std::string text = head("PUnstructuredGrid") +
                     "<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n" +
                     described("PDataArray", points) + "/>\n</PPoints>\n<PPointData>\n" +
                     described("PDataArray", node_number) + "/>\n</PPointData>\n<PCellData>\n";
  for (const Array& what : cell_data) text += described("PDataArray", what) + "/>\n";
  text += "</PCellData>\n";
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::string piece = stem + "/" + stem + "_" + std::to_string(i) + ".vtu";
    write_piece(source.part(i), path.parent_path() / piece);
    text += "<Piece Source=\"" + piece + "\"/>\n";
  }
  write_file_atomically(path, text + "</PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace tetfarm
