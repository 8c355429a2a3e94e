#include "mesh/formats/cgns/cgns_source.h"

#include <algorithm>

#include "mesh/core/elements.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/listed_mesh.h"

namespace tetfarm {
namespace {

constexpr std::int32_t tri_3 = code_of(ElementCodes::cgns, ElementType::triangle);
constexpr std::int32_t tetra_4 = code_of(ElementCodes::cgns, ElementType::tet);
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
    if (tets_.empty()) file_.fail("has no section of tets");
  }

  void read_nodes(std::int64_t first, std::span<Vec3> into) const {
    std::vector<double> values(into.size());
    for (int axis = 0; axis < 3; ++axis) {
      coordinates_[static_cast<std::size_t>(axis)].read(first, std::ssize(values), values.data());
      for (std::size_t i = 0; i < values.size(); ++i) into[i][axis] = values[i];
    }
  }
  void read_tets(std::int64_t first, std::span<ListedMesh::Nodes> into) const {
    static_assert(sizeof(ListedMesh::Nodes) == 4 * sizeof(std::int64_t));
    tets_.front().read(4 * first, 4 * std::ssize(into), into.data()->data());
    for (ListedMesh::Nodes& nodes_of_tet : into) {
      for (std::int64_t& node : nodes_of_tet) --node;
    }
  }

  bool knows_subdomains() const { return file_.has(data_of("CellData/Subdomain")); }
  std::vector<TetRun> runs() const {
    std::vector<TetRun> runs;
    if (!knows_subdomains() || !file_.has(data_of("CellData/Region"))) {
      add_tets(runs, {tets, 1, 0});
      return runs;
    }
    const Hdf5Rows regions = file_.rows(data_of("CellData/Region"));
    const Hdf5Rows subdomains = file_.rows(data_of("CellData/Subdomain"));
    std::vector<std::int32_t> region(static_cast<std::size_t>(std::min(at_once, tets)));
    std::vector<std::int32_t> subdomain(region.size());
    for (std::int64_t first = 0; first < tets; first += at_once) {
      const std::int64_t count = std::min(at_once, tets - first);
      regions.read(first, count, region.data());
      subdomains.read(first, count, subdomain.data());
      for (std::size_t t = 0; t < static_cast<std::size_t>(count); ++t) {
        add_tets(runs, {1, region[t], subdomain[t]});
      }
    }
    return runs;
  }

  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::vector<ListedTriangle> triangles;
  std::vector<std::string> patch_names;

 private:
  void read_size() {
    const std::array<std::int64_t, 3> size = size_of_zone(name_);
    if (size[0] < 0 || size[1] < 0) file_.fail("the zone has no size");
    nodes = size[0];
    tets = size[1];
  }

  void read_section(const std::string& name) {
    const auto type = file_.list<std::int32_t>(data_of(name));
    const auto range = file_.list<std::int64_t>(data_of(name + "/ElementRange"));
    constexpr std::int64_t most = std::int64_t{1} << 60;
    if (type.empty() || range.size() != 2 || range[0] < 1 || range[1] < range[0] ||
        range[1] > most) {
      file_.fail("the section " + name + " has no type or range");
    }
    const std::int64_t count = range[1] - range[0] + 1;
    Hdf5Rows connectivity = file_.rows(data_of(name + "/ElementConnectivity"));
    if (type[0] == tetra_4) {
      if (!tets_.empty() || count != tets) file_.fail("does not have one section with all tets");
      connectivity.check(0, 4 * count);
      tets_.push_back(std::move(connectivity));
    } else if (type[0] == tri_3) {
      const auto numbers =
          file_.slice<std::int64_t>(data_of(name + "/ElementConnectivity"), 0, 3 * count);
      const auto patch = static_cast<std::int32_t>(patch_names.size());
      for (std::size_t i = 0; i < numbers.size(); i += 3) {
        triangles.push_back({{numbers[i] - 1, numbers[i + 1] - 1, numbers[i + 2] - 1}, patch});
      }
      patch_names.push_back(name);
    } else {
      file_.fail("the section " + name + " has elements other than triangles and tets");
    }
  }

  Hdf5Input file_;
  std::string name_;
  std::vector<Hdf5Rows> coordinates_;
  std::vector<Hdf5Rows> tets_;  ///< one, when it is open
};

}  // namespace

std::unique_ptr<MeshSource> open_cgns(const std::filesystem::path& path) {
  const auto file = std::make_shared<const Cgns>(path);
  ListedMesh mesh;
  mesh.name = path.string();
  mesh.nodes = file->nodes;
  mesh.read_nodes = [file](std::int64_t first, std::span<Vec3> into) {
    file->read_nodes(first, into);
  };
  mesh.read_tets = [file](std::int64_t first, std::span<ListedMesh::Nodes> into) {
    file->read_tets(first, into);
  };
  mesh.runs = file->runs();
  mesh.triangles = file->triangles;
  mesh.patch_names = file->patch_names;
  mesh.knows_subdomains = file->knows_subdomains();
  mesh.takes_threads = hdf5_takes_threads();
  return open_listed(std::move(mesh));
}

}  // namespace tetfarm
