#include "mesh/formats/vtkhdf/shared_vtkhdf.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {
namespace {

VtkhdfCounts without_cells(VtkhdfCounts counts) {
  counts.tets = 0;
  for (const ElementType type : cell_block_types) counts.others[type] = 0;
  return counts;
}

bool is_at(const FileRange& range, const VtkhdfPlace& place) {
  return range.offset == place.offset && range.size == place.size;
}

}  // namespace

std::vector<FileRange> place_cells(const SharedFile& file, const NumberedPart& part,
                                   const LeafNumbering& numbering, const VtkhdfNames& names) {
  TF_CHECK(part.number == numbering.number);
  if (!has_narrow_ids(vtkhdf_counts(part))) return {};
  const MeshTotals& whole = numbering.whole;
  const VtkhdfPlaces places = places_of_cells(file.scratch, whole.subdomains,
                                              {0, whole.tets, whole.faces, whole.others}, names);
  const VtkhdfCounts others = {0, numbering.first_tet, numbering.first_face.value(),
                               numbering.first_other};
  const VtkhdfBefore before = before_each({&others, 1}).back();
  if (file.path.empty()) return write_vtkhdf_cells(places, before, part, nullptr);
  OutputFile output(file.path, OutputFile::Start::as_it_is);
  return write_vtkhdf_cells(places, before, part, &output);
}

SharedVtkhdf::SharedVtkhdf(SharedFile file, std::span<const VtkhdfCounts> parts,
                           const VtkhdfNames& names, ReadWhole read_whole)
    : path_(std::move(file.path)),
      read_whole_(std::move(read_whole)),
      frame_(std::move(file.scratch), parts, names),
      file_(path_, OutputFile::Start::as_it_is) {}

bool SharedVtkhdf::takes(std::size_t part, std::span<const FileRange> cells) {
  const std::vector<VtkhdfPlace> wanted =
      cell_places(frame_.places(), frame_.before(part), frame_.counts(part)).in_order();
  if (!std::equal(cells.begin(), cells.end(), wanted.begin(), wanted.end(), is_at)) return false;
  for (const FileRange& range : cells) placed_.emplace_back(range, part);
  taken_.insert(part);
  return true;
}

void SharedVtkhdf::add(const NumberedPart& part) {
  const auto number = static_cast<std::size_t>(part.number);
  const VtkhdfCounts& counts = frame_.counts(number);
  const bool is_placed = taken_.contains(number);
  const VtkhdfCounts here = vtkhdf_counts(part);
  if (here != counts && !(is_placed && here == without_cells(counts))) {
    throw Error(ExitCode::failed, "a sub-domain has different counts from those announced");
  }
  frame_.add(part);
  if (!is_placed) write_vtkhdf_cells(frame_.places(), frame_.before(number), part, &file_);
  write_vtkhdf_points(frame_.places(), frame_.before(number), part, file_);
}

void SharedVtkhdf::look_at_placed() {
  std::sort(placed_.begin(), placed_.end(),
            [](const auto& a, const auto& b) { return a.first.offset < b.first.offset; });
  std::vector<FileRange> ranges;
  for (const auto& [range, part] : placed_) ranges.push_back(range);
  finished_ = read_through(path_, ranges);
}

void SharedVtkhdf::finish() {
  frame_.finish(file_);
  look_at_placed();
  std::set<std::size_t> missing;
  for (const std::size_t range : finished_.wrong) missing.insert(placed_[range].second);
  for (const std::size_t part : missing) {
    write_vtkhdf_cells(frame_.places(), frame_.before(part), read_whole_(part), &file_);
  }
  if (!missing.empty()) look_at_placed();
  if (!finished_.wrong.empty()) {
    throw Error(ExitCode::failed, "the mesh file does not hold what was written to it");
  }
  file_.finish();
}

}  // namespace tetfarm
