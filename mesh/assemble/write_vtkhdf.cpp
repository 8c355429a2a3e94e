#include "mesh/assemble/write_vtkhdf.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "mesh/assemble/output_file.h"

namespace tetfarm {
namespace {

constexpr std::uint8_t vtk_triangle = 5;
constexpr std::uint8_t vtk_tetra = 10;
constexpr std::int32_t no_patch = -1;
/// What is written at once: it stays in the processor's caches until then.
constexpr std::size_t values_of_block = 65536;

/// Writes values one after the other, in blocks.
template <class T>
class Row {
 public:
  Row(OutputFile& file, std::int64_t place) : file_(file), place_(place) {
    values_.reserve(values_of_block);
  }
  ~Row() = default;
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  void add(T value) {
    values_.push_back(value);
    if (values_.size() == values_of_block) store();
  }
  void add(std::size_t count, T value) {
    while (count > 0) {
      const std::size_t here = std::min(count, values_of_block - values_.size());
      values_.resize(values_.size() + here, value);
      if (values_.size() == values_of_block) store();
      count -= here;
    }
  }
  template <class Element>
  void add_nodes(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
      for (const std::int32_t v : element) add(v);
    }
  }
  void store() {
    file_.write(place_, values_);
    place_ += static_cast<std::int64_t>(values_.size() * sizeof(T));
    values_.clear();
  }

 private:
  OutputFile& file_;
  std::int64_t place_;
  std::vector<T> values_;
};

class VtkhdfWriter : public GlobalMeshWriter {
 public:
  VtkhdfWriter(const std::filesystem::path& path, std::span<const VtkhdfCounts> parts,
               const std::vector<std::string>& patch_names,
               const std::vector<std::string>& region_names)
      : parts_(parts.begin(), parts.end()),
        before_(before_each(parts)),
        places_(write_vtkhdf_frame(path, parts, patch_names, region_names)),
        file_(path, OutputFile::Start::as_it_is) {
    // HDF5 knows its files by their first eight bytes: until the last is written it is none.
    file_.write(0, std::string(signature.size(), '\0'));
  }

  void add(const NumberedPart& part) override {
    const auto number = static_cast<std::size_t>(part.number);
    const VtkhdfCounts& counts = parts_.at(number);
    if (std::ssize(part.nodes) != counts.points || std::ssize(part.tets) != counts.tets ||
        std::ssize(part.faces) != counts.faces) {
      throw Error(ExitCode::failed, "a sub-domain has other counts than were announced");
    }
    write_elements(part, before_[number]);
    write_cell_data(part, before_[number]);
    write_nodes(part, before_[number]);
  }

  void finish() override {
    file_.write(0, signature);
    file_.finish();
  }

 private:
  static constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";

  template <class T>
  Row<T> row(std::int64_t place, std::int64_t before) {
    return Row<T>(file_, place + before * static_cast<std::int64_t>(sizeof(T)));
  }

  void write_elements(const NumberedPart& part, const VtkhdfBefore& before) {
    Row<std::int64_t> ids = row<std::int64_t>(places_.connectivity, before.ids);
    ids.add_nodes(part.tets);
    ids.add_nodes(part.faces);
    ids.store();
    // A partition has one offset more than cells.
    Row<std::int64_t> offsets = row<std::int64_t>(places_.offsets, before.cells + part.number);
    std::int64_t offset = 0;
    offsets.add(offset);
    for (std::size_t i = 0; i < part.tets.size(); ++i) offsets.add(offset += 4);
    for (std::size_t i = 0; i < part.faces.size(); ++i) offsets.add(offset += 3);
    offsets.store();
    Row<std::uint8_t> types = row<std::uint8_t>(places_.types, before.cells);
    types.add(part.tets.size(), vtk_tetra);
    types.add(part.faces.size(), vtk_triangle);
    types.store();
  }

  void write_cell_data(const NumberedPart& part, const VtkhdfBefore& before) {
    const std::size_t tets = part.tets.size();
    const std::size_t faces = part.faces.size();
    Row<std::int32_t> subdomains = row<std::int32_t>(places_.subdomains, before.cells);
    subdomains.add(tets + faces, part.number);
    subdomains.store();
    Row<std::int32_t> regions = row<std::int32_t>(places_.regions, before.cells);
    if (part.region_of_tet.empty()) {
      regions.add(tets + faces, part.region);
    } else {
      for (const std::int32_t region : part.region_of_tet) regions.add(region);
      for (const std::int32_t region : part.region_of_face) regions.add(region);
    }
    regions.store();
    Row<std::int32_t> patches = row<std::int32_t>(places_.patches, before.cells);
    patches.add(tets, no_patch);
    for (const std::int32_t patch : part.patch_of_face) patches.add(patch);
    patches.store();
  }

  void write_nodes(const NumberedPart& part, const VtkhdfBefore& before) {
    constexpr std::int64_t bytes_of_point = 24;
    static_assert(sizeof(Vec3) == bytes_of_point);
    file_.write(places_.points + before.points * bytes_of_point, part.nodes);
    file_.write(places_.node_numbers + before.points * 8, part.local2global);
  }

  std::vector<VtkhdfCounts> parts_;
  std::vector<VtkhdfBefore> before_;
  VtkhdfPlaces places_;
  OutputFile file_;
};

}  // namespace

std::unique_ptr<GlobalMeshWriter> write_vtkhdf(const std::filesystem::path& path,
                                               std::span<const VtkhdfCounts> parts,
                                               const std::vector<std::string>& patch_names,
                                               const std::vector<std::string>& region_names) {
  return std::make_unique<VtkhdfWriter>(path, parts, patch_names, region_names);
}

}  // namespace tetfarm
