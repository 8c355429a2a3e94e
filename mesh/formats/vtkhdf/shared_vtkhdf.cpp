#include "mesh/formats/vtkhdf/shared_vtkhdf.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/hdf5/hdf5_file.h"

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

SharedVtkhdf::SharedVtkhdf(SharedFile file, std::vector<VtkhdfCounts> parts,
                           const VtkhdfNames& names, ReadWhole read_whole)
    : path_(std::move(file)),
      parts_(std::move(parts)),
      before_(before_each(parts_)),
      read_whole_(std::move(read_whole)),
      places_(write_vtkhdf_frame(path_.scratch, parts_, names)),
      file_(path_.path, OutputFile::Start::as_it_is) {
  write_frame();
}

/// All of the frame that is not room for arrays, but for the signature.
void SharedVtkhdf::write_frame() {
  const VtkhdfBefore& all = before_.back();
  const auto cell_offsets = all.cells + std::ssize(parts_);
  std::vector<std::pair<std::int64_t, std::int64_t>> rooms = {
      {0, std::ssize(hdf5_signature)},       {places_.connectivity, 8 * all.ids},
      {places_.offsets, 8 * cell_offsets},   {places_.types, all.cells},
      {places_.subdomains, 4 * all.cells},   {places_.regions, 4 * all.cells},
      {places_.patches, 4 * all.cells},      {places_.points, 24 * all.points},
      {places_.node_numbers, 8 * all.points}};
  for (const auto& mark : places_.marks) rooms.emplace_back(mark.second, 4 * all.cells);
  if (places_.feet) {
    rooms.emplace_back(places_.feet->foot, 8 * all.points);
    rooms.emplace_back(places_.feet->depth, 4 * all.points);
  }
  std::sort(rooms.begin(), rooms.end());
  const auto size = static_cast<std::int64_t>(size_of_file(path_.scratch).value());
  rooms.emplace_back(size, 0);
  std::int64_t from = 0;
  for (const auto& [place, bytes] : rooms) {
    if (place > from) {
      file_.write(from, read_part_of_file(path_.scratch, static_cast<std::uint64_t>(from),
                                          static_cast<std::size_t>(place - from)));
    }
    from = std::max(from, place + bytes);
  }
  remove_file(path_.scratch);
}

bool SharedVtkhdf::takes(std::size_t part, std::span<const FileRange> cells) {
  const auto wanted =
      cell_places(places_, static_cast<std::int64_t>(part), before_.at(part), parts_.at(part))
          .in_order();
  if (!std::equal(cells.begin(), cells.end(), wanted.begin(), wanted.end(), is_at)) return false;
  for (const FileRange& range : cells) placed_.emplace_back(range, part);
  taken_.insert(part);
  return true;
}

void SharedVtkhdf::add(const NumberedPart& part) {
  const auto number = static_cast<std::size_t>(part.number);
  const VtkhdfCounts& counts = parts_.at(number);
  const bool is_placed = taken_.contains(number);
  const VtkhdfCounts here = vtkhdf_counts(part);
  if (here != counts && !(is_placed && here == without_cells(counts))) {
    throw Error(ExitCode::failed, "a sub-domain has different counts from those announced");
  }
  if (!is_placed) write_vtkhdf_cells(places_, before_[number], part, &file_);
  write_vtkhdf_points(places_, before_[number], part, file_);
}

void SharedVtkhdf::look_at_placed() {
  std::sort(placed_.begin(), placed_.end(),
            [](const auto& a, const auto& b) { return a.first.offset < b.first.offset; });
  std::vector<FileRange> ranges;
  for (const auto& [range, part] : placed_) ranges.push_back(range);
  finished_ = read_through(path_.path, ranges);
}

void SharedVtkhdf::finish() {
  file_.write(0, hdf5_signature);
  look_at_placed();
  std::set<std::size_t> missing;
  for (const std::size_t range : finished_.wrong) missing.insert(placed_[range].second);
  for (const std::size_t part : missing) {
    write_vtkhdf_cells(places_, before_[part], read_whole_(part), &file_);
  }
  if (!missing.empty()) look_at_placed();
  if (!finished_.wrong.empty()) {
    throw Error(ExitCode::failed, "the mesh file does not hold what was written to it");
  }
  file_.finish();
}

}  // namespace tetfarm
