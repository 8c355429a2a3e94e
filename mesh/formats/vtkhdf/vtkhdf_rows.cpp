#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/core/elements.h"

namespace tetfarm {
namespace {

constexpr std::uint8_t vtk_triangle = code_of(ElementCodes::vtk, ElementType::triangle);
constexpr std::uint8_t vtk_tetra = code_of(ElementCodes::vtk, ElementType::tet);
constexpr std::int32_t no_patch = -1;
/// What is written at once: it stays in the processor's caches until then.
constexpr std::size_t values_of_block = 65536;

/// Writes values one after the other, in blocks.
template <class T>
class Row {
 public:
  Row(OutputFile* file, const VtkhdfPlace& place)
      : file_(file), place_(place), next_(place.offset) {
    values_.reserve(values_of_block);
  }

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
  FileRange finish() {
    store();
    TF_CHECK(next_ == place_.offset + place_.size);
    return {place_.offset, place_.size, hasher_.finish()};
  }

 private:
  void store() {
    const std::size_t bytes = values_.size() * sizeof(T);
    hasher_.add(values_.data(), bytes);
    if (file_ != nullptr) file_->write(next_, values_);
    next_ += static_cast<std::int64_t>(bytes);
    values_.clear();
  }

  OutputFile* file_;
  VtkhdfPlace place_;
  std::int64_t next_;
  Hasher hasher_;
  std::vector<T> values_;
};

VtkhdfCounts counts_of(const NumberedPart& part) {
  return {std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces)};
}

FileRange write_offsets(const VtkhdfPlace& place, const NumberedPart& part, OutputFile* file) {
  Row<std::int64_t> offsets(file, place);
  std::int64_t offset = 0;
  offsets.add(offset);
  for (std::size_t i = 0; i < part.tets.size(); ++i) offsets.add(offset += 4);
  for (std::size_t i = 0; i < part.faces.size(); ++i) offsets.add(offset += 3);
  return offsets.finish();
}

FileRange write_regions(const VtkhdfPlace& place, const NumberedPart& part, OutputFile* file) {
  Row<std::int32_t> regions(file, place);
  if (part.region_of_tet.empty()) {
    regions.add(part.tets.size() + part.faces.size(), part.region);
  } else {
    TF_CHECK(part.region_of_tet.size() == part.tets.size());
    TF_CHECK(part.region_of_face.size() == part.faces.size());
    for (const std::int32_t region : part.region_of_tet) regions.add(region);
    for (const std::int32_t region : part.region_of_face) regions.add(region);
  }
  return regions.finish();
}

}  // namespace

std::vector<FileRange> write_vtkhdf_cells(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                                          const NumberedPart& part, OutputFile* file) {
  const VtkhdfCellPlaces here = cell_places(places, part.number, before, counts_of(part));
  Row<std::int64_t> ids(file, here.connectivity);
  ids.add_nodes(part.tets);
  ids.add_nodes(part.faces);
  std::vector<FileRange> written = {ids.finish()};
  written.push_back(write_offsets(here.offsets, part, file));
  Row<std::uint8_t> types(file, here.types);
  types.add(part.tets.size(), vtk_tetra);
  types.add(part.faces.size(), vtk_triangle);
  written.push_back(types.finish());
  Row<std::int32_t> subdomains(file, here.subdomains);
  subdomains.add(part.tets.size() + part.faces.size(), part.number);
  written.push_back(subdomains.finish());
  written.push_back(write_regions(here.regions, part, file));
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  Row<std::int32_t> patches(file, here.patches);
  patches.add(part.tets.size(), no_patch);
  for (const std::int32_t patch : part.patch_of_face) patches.add(patch);
  written.push_back(patches.finish());
  return written;
}

void write_vtkhdf_points(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                         const NumberedPart& part, OutputFile& file) {
  constexpr std::int64_t bytes_of_point = 24;
  static_assert(sizeof(Vec3) == bytes_of_point);
  TF_CHECK(part.local2global.size() == part.nodes.size());
  file.write(places.points + before.points * bytes_of_point, part.nodes);
  file.write(places.node_numbers + before.points * 8, part.local2global);
}

}  // namespace tetfarm
