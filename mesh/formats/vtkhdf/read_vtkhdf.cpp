#include "mesh/formats/vtkhdf/read_vtkhdf.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/vtkhdf/vtkhdf_cells.h"

namespace tetfarm {
namespace {

/// More than any real mesh has: a wrong number must not fill the memory.
constexpr std::int32_t most_regions = 1'000'000;

std::vector<VtkhdfPartition> partitions_of(const Hdf5Input& file) {
  const auto points = file.list<std::int64_t>("VTKHDF/NumberOfPoints");
  const auto cells = file.list<std::int64_t>("VTKHDF/NumberOfCells");
  const auto ids = file.list<std::int64_t>("VTKHDF/NumberOfConnectivityIds");
  if (cells.size() != points.size() || ids.size() != points.size()) {
    file.fail("the numbers of points and of cells have different numbers of partitions");
  }
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  std::vector<VtkhdfPartition> partitions;
  VtkhdfPartition next;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const std::int64_t count :
         {points[i], cells[i], ids[i] / std::int64_t{most_element_nodes}}) {
      if (count < 0 || count > most) file.fail("a partition has a wrong number of points or cells");
    }
    next.points = points[i];
    next.cells = cells[i];
    next.ids = ids[i];
    partitions.push_back(next);
    next.first_point += next.points;
    next.first_cell += next.cells;
    next.first_id += next.ids;
    ++next.number;
  }
  return partitions;
}

/// Which of the arrays that tell more a file has.
struct KnownArrays {
  bool node_numbers = false;
  bool patches = false;
  bool regions = false;
  std::vector<CellMark> marks;
  bool feet = false;
};

std::string path_of(CellMark mark) { return std::string("VTKHDF/CellData/") + name_of(mark); }
std::string path_of_points(const char* array) { return std::string("VTKHDF/PointData/") + array; }

Hdf5Input open_mesh(const std::filesystem::path& path) {
  Hdf5Input file(path.string());
  if (!file.has("VTKHDF") || file.text_attribute("VTKHDF", "Type") != "UnstructuredGrid") {
    file.fail("is not a VTKHDF file of type UnstructuredGrid");
  }
  return file;
}

KnownArrays known_arrays(const Hdf5Input& file) {
  KnownArrays known{file.has("VTKHDF/PointData/GlobalNodeId"),
                    file.has("VTKHDF/CellData/patch"),
                    file.has("VTKHDF/CellData/region"),
                    {},
                    false};
  if (!file.has("Tetfarm")) return known;  // what others call so may be anything
  std::copy_if(all_cell_marks.begin(), all_cell_marks.end(), std::back_inserter(known.marks),
               [&file](CellMark mark) { return file.has(path_of(mark)); });
  known.feet = known.node_numbers && file.has(path_of_points(foot_array)) &&
               file.has(path_of_points(depth_array));
  return known;
}

void read_points(const Hdf5Input& file, const VtkhdfPartition& here, const KnownArrays& known,
                 NumberedPart& part) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const Hdf5Rows points = file.rows("VTKHDF/Points", 3);
  points.check(here.first_point, here.points);
  part.nodes.resize(at(here.points));
  points.read<double>(here.first_point, here.points, &part.nodes.data()->x);
  if (known.node_numbers) {
    part.local2global =
        file.slice<std::int64_t>("VTKHDF/PointData/GlobalNodeId", here.first_point, here.points);
  } else {
    for (std::int64_t i = 0; i < here.points; ++i) part.local2global.push_back(i);
  }
  if (!known.feet) return;
  part.feet.foot =
      file.slice<std::int64_t>(path_of_points(foot_array), here.first_point, here.points);
  part.feet.depth =
      file.slice<std::int32_t>(path_of_points(depth_array), here.first_point, here.points);
}

/// A partition lies in one region, or says it of each cell. Blocks have it of each element.
void read_regions(const Hdf5Input& file, const VtkhdfPartition& here, NumberedPart& part) {
  if (here.cells == 0) return;
  const Hdf5Rows rows = file.rows("VTKHDF/CellData/region");
  std::vector<std::int32_t> regions(at(std::min(here.cells, vtkhdf_cells_of_block)));
  std::int32_t least = most_regions;
  std::int32_t most = 1;
  for (std::int64_t first = 0; first < here.cells; first += vtkhdf_cells_of_block) {
    regions.resize(at(std::min(vtkhdf_cells_of_block, here.cells - first)));
    rows.read(here.first_cell + first, std::ssize(regions), regions.data());
    for (const std::int32_t region : regions) {
      least = std::min(least, region);
      most = std::max(most, region);
    }
  }
  if (least < 1 || most > most_regions) {
    file.fail("a cell has the region " + std::to_string(least < 1 ? least : most));
  }
  part.region = least;
  if (least == most) return;
  const auto types = file.slice<std::uint8_t>("VTKHDF/Types", here.first_cell, here.cells);
  regions = file.slice<std::int32_t>("VTKHDF/CellData/region", here.first_cell, here.cells);
  for (std::size_t cell = 0; cell < regions.size(); ++cell) {
    const auto type = type_of(ElementCodes::vtk, types[cell]);
    if (type == ElementType::tet) {
      part.region_of_tet.push_back(regions[cell]);
    } else if (!type || type == ElementType::triangle) {
      part.region_of_face.push_back(regions[cell]);
    } else {
      part.blocks[*type].regions.push_back(regions[cell]);
    }
  }
}

/// Those of the partition where cells do not say it.
void complete_regions(const ElementCounts& counts, NumberedPart& part) {
  for_each_block(part.blocks, [&](ElementType type, ElementBlock& block) {
    block.regions.resize(at(counts[type]), part.region);
  });
}

/// All but the nodes of the elements.
CountedPart count_part(const Hdf5Input& file, const VtkhdfPartition& here,
                       const KnownArrays& known) {
  CountedPart counted;
  NumberedPart& part = counted.part;
  part.number = static_cast<std::int32_t>(here.number);
  if (known.regions) read_regions(file, here, part);
  read_points(file, here, known, part);
  VtkhdfCells cells(file, here);
  const ElementCounts counts = cells.count();
  counted.tets = counts[ElementType::tet];
  counted.faces = counts[ElementType::triangle];
  complete_regions(counts, part);
  cells.read_patches(known.patches, counts, part);
  return counted;
}

/// The file may have its cells in any order, and boundary faces between them.
void read_marks(const Hdf5Input& file, const VtkhdfPartition& here,
                const std::vector<CellMark>& marks, NumberedPart& part) {
  if (marks.empty()) return;
  const auto types = file.slice<std::uint8_t>("VTKHDF/Types", here.first_cell, here.cells);
  for (const CellMark mark : marks) {
    const auto values = file.slice<std::int32_t>(path_of(mark), here.first_cell, here.cells);
    ByType<std::vector<std::int32_t>> of_type;
    for (std::size_t cell = 0; cell < types.size(); ++cell) {
      if (const auto type = type_of(ElementCodes::vtk, types[cell])) {
        of_type[*type].push_back(values[cell]);
      }
    }
    std::vector<std::int32_t>& of_cells = part.marks[mark];
    of_cells = std::move(of_type[ElementType::tet]);
    for (const ElementType type : cell_block_types) {
      of_cells.insert(of_cells.end(), of_type[type].begin(), of_type[type].end());
    }
  }
}

NumberedPart read_part(const Hdf5Input& file, const VtkhdfPartition& here,
                       const KnownArrays& known) {
  CountedPart counted = count_part(file, here, known);
  counted.part.tets.reserve(at(counted.tets));
  counted.part.faces.reserve(at(counted.faces));
  VtkhdfCells(file, here).read_nodes(counted.part);
  read_marks(file, here, known.marks, counted.part);
  return std::move(counted.part);
}

template <class Element>
Element with_global_nodes(Element element, const NumberedPart& part) {
  for (std::int32_t& v : element) v = static_cast<std::int32_t>(part.local2global[at(v)]);
  return element;
}

void join(const Hdf5Input& file, const NumberedPart& part, GlobalMesh& mesh) {
  if (has_elements(part.blocks)) file.fail("has cells other than tets and triangles");
  std::vector<Vec3>& nodes = mesh.mesh.nodes;
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    const std::int64_t number = part.local2global[i];
    if (number < 0 || number >= std::ssize(nodes)) file.fail("a GlobalNodeId is out of range");
    nodes[at(number)] = part.nodes[i];
  }
  for (const Tet& tet : part.tets) mesh.mesh.tets.push_back(with_global_nodes(tet, part));
  mesh.subdomain_of_tet.resize(mesh.mesh.tets.size(), part.number);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    mesh.region_of_tet.push_back(part.region_of(t));
  }
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    mesh.boundary.push_back(with_global_nodes(part.faces[i], part));
    mesh.patch_of_triangle.push_back(part.patch_of_face[i]);
    mesh.region_of_triangle.push_back(part.region_of_boundary(i));
  }
}

std::int64_t node_count(const Hdf5Input& file, const std::vector<VtkhdfPartition>& partitions,
                        bool has_numbers) {
  if (!has_numbers) {
    if (partitions.size() != 1)
      file.fail("has several partitions, but no GlobalNodeId to join them by");
    return partitions.front().points;
  }
  std::int64_t most = -1;
  std::int64_t points = 0;
  for (const VtkhdfPartition& here : partitions) {
    points += here.points;
    for (const std::int64_t number :
         file.slice<std::int64_t>("VTKHDF/PointData/GlobalNodeId", here.first_point, here.points)) {
      most = std::max(most, number);
    }
  }
  if (most >= points || most >= std::numeric_limits<std::int32_t>::max()) {
    file.fail("a GlobalNodeId is out of range");
  }
  return most + 1;
}

}  // namespace

struct VtkhdfParts::Content {
  explicit Content(const std::filesystem::path& path)
      : file(open_mesh(path)), known(known_arrays(file)), partitions(partitions_of(file)) {}

  std::vector<std::string> texts(const char* name) const {
    return file.has(name) ? file.texts(name) : std::vector<std::string>{};
  }

  Hdf5Input file;
  KnownArrays known;
  std::vector<VtkhdfPartition> partitions;
};

VtkhdfParts::VtkhdfParts(const std::filesystem::path& path)
    : content_(std::make_unique<const Content>(path)) {}
VtkhdfParts::~VtkhdfParts() = default;

std::size_t VtkhdfParts::size() const { return content_->partitions.size(); }
bool VtkhdfParts::has_node_numbers() const { return content_->known.node_numbers; }
void VtkhdfParts::fail(const std::string& what) const { content_->file.fail(what); }

const std::vector<CellMark>& VtkhdfParts::cell_marks() const { return content_->known.marks; }
bool VtkhdfParts::has_feet() const { return content_->known.feet; }

NumberedPart VtkhdfParts::part(std::size_t i) const {
  return read_part(content_->file, content_->partitions.at(i), content_->known);
}

CountedPart VtkhdfParts::count(std::size_t i) const {
  return count_part(content_->file, content_->partitions.at(i), content_->known);
}

std::vector<std::string> VtkhdfParts::patch_names() const {
  return content_->texts("Tetfarm/patch_names");
}

std::vector<PatchType> VtkhdfParts::patch_types() const {
  std::vector<PatchType> types;
  for (const std::string& word : content_->texts("Tetfarm/patch_types")) {
    types.push_back(patch_type_of(word).value_or(PatchType::unspecified));
  }
  return types;
}

std::vector<std::string> VtkhdfParts::region_names() const {
  return content_->texts("Tetfarm/region_names");
}

GlobalMesh read_vtkhdf(const std::filesystem::path& path) {
  const Hdf5Input file = open_mesh(path);
  const KnownArrays known = known_arrays(file);
  const std::vector<VtkhdfPartition> partitions = partitions_of(file);
  GlobalMesh mesh;
  if (partitions.empty()) file.fail("has no partitions");
  mesh.mesh.nodes.resize(at(node_count(file, partitions, known.node_numbers)));
  mesh.mesh.boundary_nodes = static_cast<std::int32_t>(mesh.mesh.nodes.size());
  mesh.subdomains = static_cast<std::int32_t>(partitions.size());
  for (const VtkhdfPartition& here : partitions) join(file, read_part(file, here, known), mesh);
  if (file.has("Tetfarm/patch_names")) mesh.patch_names = file.texts("Tetfarm/patch_names");
  if (file.has("Tetfarm/region_names")) mesh.region_names = file.texts("Tetfarm/region_names");
  return mesh;
}

}  // namespace tetfarm
