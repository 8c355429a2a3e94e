#include "mesh/formats/cgns/cgns_source.h"

#include <algorithm>

#include "mesh/core/elements.h"
#include "mesh/formats/cgns/cgns_tree.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/listed_mesh.h"

namespace tetfarm {
namespace {

constexpr std::int64_t at_once = 65536;
constexpr const char* zone = "Base/Zone1";

std::string data_of(const std::string& node) { return std::string(zone) + "/" + node + "/ data"; }

/// The names of the nodes below the zone, in the order in which they were made.
std::vector<std::string> children_of_zone(const std::string& path) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Hdf5Handle group(H5Gopen2(file.get(), zone, H5P_DEFAULT), H5Gclose);
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* kept) -> herr_t {
    static_cast<std::vector<std::string>*>(kept)->emplace_back(name);
    return 0;
  };
  hsize_t place = 0;
  if (H5Literate(group.get(), H5_INDEX_CRT_ORDER, H5_ITER_INC, &place, keep, &names) < 0) {
    place = 0;
    H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_INC, &place, keep, &names);
  }
  return names;
}

/// Numbers of nodes, cells and nodes of the boundary; negative when they are not there.
std::array<std::int64_t, 3> size_of_zone(const std::string& path) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const std::string name = std::string(zone) + "/ data";
  const Hdf5Handle data(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(data.is_open() ? H5Dget_space(data.get()) : -1, H5Sclose);
  std::array<std::int64_t, 3> size = {-1, -1, -1};
  if (!space.is_open() || H5Sget_simple_extent_npoints(space.get()) != std::ssize(size) ||
      H5Dread(data.get(), hdf5_type<std::int64_t>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, size.data()) <
          0) {
    return {-1, -1, -1};
  }
  return size;
}

class Cgns {
 public:
  explicit Cgns(const std::filesystem::path& path) : file_(path.string()), name_(path.string()) {
    if (!file_.has(zone)) file_.fail("is not a CGNS file with the zone Base/Zone1");
    read_size();
    for (const char* axis : {"CoordinateX", "CoordinateY", "CoordinateZ"}) {
      coordinates_.push_back(file_.rows(data_of("GridCoordinates/" + std::string(axis))));
      coordinates_.back().check(0, nodes);
    }
    for (const std::string& name : children_of_zone(name_)) {
      if (file_.has(std::string(zone) + "/" + name + "/ElementConnectivity")) read_section(name);
    }
    if (counted_ == 0) file_.fail("has no section of tets");
    if (counted_ != cells_) file_.fail("does not have one section with all tets");
  }

  void read_nodes(std::int64_t first, std::span<Vec3> into) const {
    std::vector<double> values(into.size());
    for (int axis = 0; axis < 3; ++axis) {
      coordinates_[static_cast<std::size_t>(axis)].read(first, std::ssize(values), values.data());
      for (std::size_t i = 0; i < values.size(); ++i) into[i][axis] = values[i];
    }
  }
  void read_cells(ElementType type, std::int64_t first, std::span<std::int64_t> into) const {
    const auto nodes_of_cell = static_cast<std::int64_t>(nodes_of(type));
    cells_of_type_[type].rows.front().read(nodes_of_cell * first, std::ssize(into), into.data());
    for (std::int64_t& node : into) --node;
    put_in_our_order(type, into);
  }

  bool knows_subdomains() const { return file_.has(data_of("CellData/Subdomain")); }
  std::vector<TetRun> runs(ElementType type) const {
    std::vector<TetRun> runs;
    const std::int64_t cells = cells_of_type_[type].count;
    if (cells == 0) return runs;
    if (!knows_subdomains() || !file_.has(data_of("CellData/Region"))) {
      add_tets(runs, {cells, 1, 0});
      return runs;
    }
    const Hdf5Rows regions = file_.rows(data_of("CellData/Region"));
    const Hdf5Rows subdomains = file_.rows(data_of("CellData/Subdomain"));
    std::vector<std::int32_t> region(static_cast<std::size_t>(std::min(at_once, cells)));
    std::vector<std::int32_t> subdomain(region.size());
    for (std::int64_t first = 0; first < cells; first += at_once) {
      const std::int64_t count = std::min(at_once, cells - first);
      regions.read(cells_of_type_[type].first + first, count, region.data());
      subdomains.read(cells_of_type_[type].first + first, count, subdomain.data());
      for (std::size_t t = 0; t < static_cast<std::size_t>(count); ++t) {
        add_tets(runs, {1, region[t], subdomain[t]});
      }
    }
    return runs;
  }

  std::int64_t nodes = 0;
  std::vector<ListedTriangle> triangles;
  std::vector<ListedQuad> quads;
  std::vector<std::string> patch_names;

 private:
  void read_size() {
    const std::array<std::int64_t, 3> size = size_of_zone(name_);
    if (size[0] < 0 || size[1] < 0) file_.fail("the zone has no size");
    nodes = size[0];
    cells_ = size[1];
  }

  void read_section(const std::string& name) {
    const auto type = file_.list<std::int32_t>(data_of(name));
    const auto range = file_.list<std::int64_t>(data_of(name + "/ElementRange"));
    constexpr std::int64_t most = std::int64_t{1} << 60;
    if (type.empty() || range.size() != 2 || range[0] < 1 || range[1] < range[0] ||
        range[1] > most) {
      file_.fail("the section " + name + " has no type or range");
    }
    const std::optional<ElementType> known = type_of(ElementCodes::cgns, type[0]);
    if (!known) file_.fail("the section " + name + " has elements that are not supported");
    if (is_cell(*known)) {
      add_cells(*known, name, range[0] - 1, range[1] - range[0] + 1);
    } else {
      add_faces(*known, name, range[1] - range[0] + 1);
    }
  }

  /// One section has all cells of its type.
  void add_cells(ElementType type, const std::string& name, std::int64_t first,
                 std::int64_t count) {
    CellsOfType& cells = cells_of_type_[type];
    if (!cells.rows.empty() || count > cells_ - counted_ || first > cells_ - count) {
      file_.fail("does not have one section with all " + std::string(element(type).plural));
    }
    cells.rows.push_back(file_.rows(data_of(name + "/ElementConnectivity")));
    cells.rows.back().check(0, static_cast<std::int64_t>(nodes_of(type)) * count);
    cells.first = first;
    cells.count = count;
    counted_ += count;
  }

  /// A section is a patch, but one of quads may go on with the patch before it.
  void add_faces(ElementType type, const std::string& name, std::int64_t count) {
    const auto nodes_of_face = static_cast<std::int64_t>(nodes_of(type));
    auto numbers =
        file_.slice<std::int64_t>(data_of(name + "/ElementConnectivity"), 0, nodes_of_face * count);
    for (std::int64_t& number : numbers) --number;
    put_in_our_order(type, numbers);
    if (patch_names.empty() || !name.starts_with(cgns_section(type) + "_")) {
      patch_names.push_back(name);
    }
    const auto patch = static_cast<std::int32_t>(patch_names.size()) - 1;
    for (auto next = numbers.begin(); next != numbers.end(); next += nodes_of_face) {
      if (type == ElementType::triangle) {
        triangles.push_back({{next[0], next[1], next[2]}, patch});
      } else {
        quads.push_back({{next[0], next[1], next[2], next[3]}, patch});
      }
    }
  }

  static void put_in_our_order(ElementType type, std::span<std::int64_t> nodes) {
    if (type == ElementType::tet || type == ElementType::triangle) return;
    std::array<std::int64_t, most_element_nodes> theirs{};
    const std::size_t count = nodes_of(type);
    for (std::size_t i = 0; i < nodes.size(); i += count) {
      std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(i), count, theirs.begin());
      take_from_order_of(ElementCodes::cgns, type,
                         std::span<const std::int64_t>(theirs).first(count),
                         nodes.subspan(i, count));
    }
  }

  struct CellsOfType {
    std::vector<Hdf5Rows> rows;  ///< one, when it is open
    std::int64_t first = 0;      ///< among the elements of the zone
    std::int64_t count = 0;
  };

  Hdf5Input file_;
  std::string name_;
  std::vector<Hdf5Rows> coordinates_;
  std::int64_t cells_ = 0;
  std::int64_t counted_ = 0;  ///< in sections
  ByType<CellsOfType> cells_of_type_;
};

}  // namespace

std::unique_ptr<MeshSource> open_cgns(const std::filesystem::path& path,
                                      const std::filesystem::path&) {
  const auto file = std::make_shared<const Cgns>(path);
  ListedMesh mesh;
  mesh.name = path.string();
  mesh.nodes = file->nodes;
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_nodes(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    static_assert(sizeof(ListedMesh::Nodes) == 4 * sizeof(std::int64_t));
    if (into.empty()) return;
    file->read_cells(ElementType::tet, first, {into.data()->data(), 4 * into.size()});
  };
  mesh.runs = file->runs(ElementType::tet);
  for (const ElementType type : cell_block_types) {
    mesh.cells[type].runs = file->runs(type);
    mesh.cells[type].read = [file, type](std::int64_t first, std::span<std::int64_t> into) {
      file->read_cells(type, first, into);
    };
  }
  mesh.triangles = file->triangles;
  mesh.quads = file->quads;
  mesh.patch_names = file->patch_names;
  mesh.knows_subdomains = file->knows_subdomains();
  mesh.takes_threads = hdf5_takes_threads();
  return open_listed(std::move(mesh));
}

}  // namespace tetfarm
