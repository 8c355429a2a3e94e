#include "mesh/assemble/write_vtkhdf.h"

#include "mesh/assemble/hdf5_file.h"

namespace tetfarm {
namespace {

constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_tetra = 10;
constexpr std::int32_t no_patch = -1;

/// The cells of a part: tets first, then boundary triangles.
struct Cells {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<std::int32_t> patches;
};

Cells cells_of(const NumberedPart& part) {
  const std::size_t count = part.tets.size() + part.faces.size();
  Cells cells;
  cells.connectivity.reserve(part.tets.size() * 4 + part.faces.size() * 3);
  for (const Tet& tet : part.tets) {
    for (const std::int32_t v : tet) cells.connectivity.push_back(v);
  }
  for (const Triangle& face : part.faces) {
    for (const std::int32_t v : face) cells.connectivity.push_back(v);
  }
  cells.offsets.resize(count + 1);
  for (std::size_t i = 1; i <= count; ++i) {
    cells.offsets[i] = cells.offsets[i - 1] + (i <= part.tets.size() ? 4 : 3);
  }
  cells.types.assign(part.tets.size(), vtk_tetra);
  cells.types.resize(count, vtk_triangle);
  cells.patches.assign(part.tets.size(), no_patch);
  cells.patches.insert(cells.patches.end(), part.patch_of_face.begin(), part.patch_of_face.end());
  return cells;
}

class VtkhdfWriter : public GlobalMeshWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& path, const std::vector<std::string>& patch_names,
               const std::vector<std::string>& region_names)
      : file_(path.string()) {
    file_.make_group("VTKHDF");
    file_.add_attribute("VTKHDF", "Version", {1, 0});
    file_.add_text_attribute("VTKHDF", "Type", "UnstructuredGrid");
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds",
                             "Connectivity", "Offsets"}) {
      file_.make_array<std::int64_t>("VTKHDF/" + std::string(name));
    }
    file_.make_array<double>("VTKHDF/Points", 3);
    file_.make_array<std::uint8_t>("VTKHDF/Types");
    file_.make_group("VTKHDF/PointData");
    file_.make_array<std::int64_t>("VTKHDF/PointData/GlobalNodeId");
    file_.make_group("VTKHDF/CellData");
    file_.make_array<std::int32_t>("VTKHDF/CellData/subdomain");
    file_.make_array<std::int32_t>("VTKHDF/CellData/region");
    file_.make_array<std::int32_t>("VTKHDF/CellData/patch");
    file_.make_group("Tetfarm");
    file_.add_texts("Tetfarm/patch_names", patch_names);
    file_.add_texts("Tetfarm/region_names",
                    region_names.empty() ? std::vector<std::string>{"domain"} : region_names);
  }

  void add(const NumberedPart& part) override {
    const Cells cells = cells_of(part);
    using Count = std::vector<std::int64_t>;
    file_.append("VTKHDF/NumberOfPoints", Count{std::ssize(part.nodes)});
    file_.append("VTKHDF/NumberOfCells", Count{std::ssize(cells.types)});
    file_.append("VTKHDF/NumberOfConnectivityIds", Count{std::ssize(cells.connectivity)});
    std::vector<double> coordinates;
    coordinates.reserve(part.nodes.size() * 3);
    for (const Vec3& p : part.nodes) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    file_.append("VTKHDF/Points", coordinates);
    file_.append("VTKHDF/Connectivity", cells.connectivity);
    file_.append("VTKHDF/Offsets", cells.offsets);
    file_.append("VTKHDF/Types", cells.types);
    file_.append("VTKHDF/PointData/GlobalNodeId", part.local2global);
    file_.append("VTKHDF/CellData/subdomain",
                 std::vector<std::int32_t>(cells.types.size(), part.number));
    file_.append("VTKHDF/CellData/region", regions_of_cells(part));
    file_.append("VTKHDF/CellData/patch", cells.patches);
  }

  void finish() override { file_.close(); }

 private:
  Hdf5Output file_;
};

}  // namespace

std::unique_ptr<GlobalMeshWriter> write_vtkhdf(const std::filesystem::path& path,
                                               const std::vector<std::string>& patch_names,
                                               const std::vector<std::string>& region_names) {
  return std::make_unique<VtkhdfWriter>(path, patch_names, region_names);
}

}  // namespace tetfarm
