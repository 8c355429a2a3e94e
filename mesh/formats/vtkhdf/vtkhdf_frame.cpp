#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

#include <algorithm>
#include <array>
#include <limits>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

/// Each has a number for each partition.
constexpr std::array<const char*, 3> arrays_of_counts = {
    "VTKHDF/NumberOfPoints", "VTKHDF/NumberOfCells", "VTKHDF/NumberOfConnectivityIds"};

void add_counts(std::span<const VtkhdfCounts> parts, Hdf5Output& file) {
  std::vector<std::int64_t> points;
  std::vector<std::int64_t> cells;
  std::vector<std::int64_t> ids;
  for (const VtkhdfCounts& part : parts) {
    points.push_back(part.points);
    cells.push_back(cells_of(part));
    ids.push_back(ids_of(part));
  }
  file.add_array(arrays_of_counts[0], points);
  file.add_array(arrays_of_counts[1], cells);
  file.add_array(arrays_of_counts[2], ids);
}

void begin_frame(const VtkhdfNames& names, Hdf5Output& file) {
  for (const char* group : {"VTKHDF", "VTKHDF/PointData", "VTKHDF/CellData", "Tetfarm"}) {
    file.make_group(group);
  }
  file.add_attribute("VTKHDF", "Version", {1, 0});
  file.add_text_attribute("VTKHDF", "Type", "UnstructuredGrid");
  file.add_texts("Tetfarm/patch_names", names.patches);
  if (has_types(names.types)) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < names.patches.size(); ++i) {
      words.emplace_back(word_of(type_of_patch(names.types, i)));
    }
    file.add_texts("Tetfarm/patch_types", words);
  }
  file.add_texts("Tetfarm/region_names",
                 names.regions.empty() ? std::vector<std::string>{"domain"} : names.regions);
}

void add_room_for_cells(const VtkhdfBefore& all, const VtkhdfNames& names, Hdf5Output& file,
                        VtkhdfPlaces& places) {
  const std::string name = "VTKHDF/Connectivity";
  places.connectivity = places.id_size == sizeof(std::int32_t)
                            ? file.room_for<std::int32_t>(name, all.ids)
                            : file.room_for<std::int64_t>(name, all.ids);
  for (const CellMark mark : names.marks) {
    const std::string path = std::string("VTKHDF/CellData/") + name_of(mark);
    places.marks.emplace_back(mark, file.room_for<std::int32_t>(path, all.cells));
  }
}

void add_room_for_points(std::int64_t points, const VtkhdfNames& names, Hdf5Output& file,
                         VtkhdfPlaces& places) {
  places.points = file.room_for<double>("VTKHDF/Points", points, 3);
  places.node_numbers = file.room_for<std::int64_t>("VTKHDF/PointData/GlobalNodeId", points);
  if (!names.has_feet) return;
  const std::string folder = "VTKHDF/PointData/";
  const std::int64_t foot = file.room_for<std::int64_t>(folder + foot_array, points);
  places.feet = {foot, file.room_for<std::int32_t>(folder + depth_array, points)};
}

/// Copies bytes [from, to) of one file to their place in another.
void copy_bytes(const std::filesystem::path& from_path, std::int64_t from, std::int64_t to,
                OutputFile& file) {
  constexpr std::int64_t most = std::int64_t{1} << 20;
  for (std::int64_t next = from; next < to; next += most) {
    const std::int64_t count = std::min(most, to - next);
    file.write(next, read_part_of_file(from_path, static_cast<std::uint64_t>(next),
                                       static_cast<std::size_t>(count)));
  }
}

}  // namespace

bool has_narrow_ids(const VtkhdfCounts& part) {
  return ids_of(part) <= std::numeric_limits<std::int32_t>::max();
}

VtkhdfCellPlaces cell_places(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                             const VtkhdfCounts& counts) {
  std::vector<VtkhdfPlace> marks;
  for (const auto& mark : places.marks) {
    marks.push_back({mark.second + 4 * before.cells, 4 * cells_of(counts)});
  }
  const std::int64_t size = places.id_size;
  return {{places.connectivity + size * before.ids, size * ids_of(counts)}, std::move(marks)};
}

std::vector<VtkhdfPlace> VtkhdfCellPlaces::in_order() const {
  std::vector<VtkhdfPlace> places = {connectivity};
  places.insert(places.end(), marks.begin(), marks.end());
  return places;
}

VtkhdfFrame::VtkhdfFrame(std::filesystem::path scratch, std::span<const VtkhdfCounts> parts,
                         const VtkhdfNames& names)
    : scratch_(std::move(scratch)),
      parts_(parts.begin(), parts.end()),
      before_(before_each(parts)),
      file_(scratch_.string()) {
  const VtkhdfBefore& all = before_.back();
  const bool is_narrow = std::all_of(parts_.begin(), parts_.end(), has_narrow_ids);
  places_.id_size = is_narrow ? sizeof(std::int32_t) : sizeof(std::int64_t);
  begin_frame(names, file_);
  add_counts(parts, file_);
  add_room_for_cells(all, names, file_, places_);
  add_room_for_points(all.points, names, file_, places_);
  packed_ = std::make_unique<PackedCells>(file_, std::ssize(parts_), all, places_.id_size);
}

VtkhdfFrame::~VtkhdfFrame() {
  std::error_code ignored;
  std::filesystem::remove(scratch_, ignored);
}

void VtkhdfFrame::add(const NumberedPart& part) {
  const auto number = static_cast<std::size_t>(part.number);
  packed_->add(part, counts(number), before(number));
}

std::vector<VtkhdfPlace> VtkhdfFrame::rooms() const {
  const VtkhdfBefore& all = before_.back();
  std::vector<VtkhdfPlace> rooms = {{places_.connectivity, places_.id_size * all.ids},
                                    {places_.points, 24 * all.points},
                                    {places_.node_numbers, 8 * all.points}};
  for (const auto& mark : places_.marks) rooms.push_back({mark.second, 4 * all.cells});
  if (places_.feet) {
    rooms.push_back({places_.feet->foot, 8 * all.points});
    rooms.push_back({places_.feet->depth, 4 * all.points});
  }
  std::sort(rooms.begin(), rooms.end(),
            [](const VtkhdfPlace& a, const VtkhdfPlace& b) { return a.offset < b.offset; });
  return rooms;
}

void VtkhdfFrame::finish(OutputFile& file) {
  packed_->finish();
  packed_.reset();  // an array that is open would keep the file open
  file_.close();
  std::int64_t from = std::ssize(hdf5_signature);
  for (const VtkhdfPlace& room : rooms()) {
    copy_bytes(scratch_, from, room.offset, file);
    from = std::max(from, room.offset + room.size);
  }
  copy_bytes(scratch_, from, static_cast<std::int64_t>(size_of_file(scratch_).value()), file);
  remove_file(scratch_);
  file.write(0, hdf5_signature);
}

VtkhdfPlaces places_of_cells(const std::filesystem::path& scratch, std::int64_t partitions,
                             const VtkhdfCounts& all, const VtkhdfNames& names) {
  TF_CHECK(partitions >= 0);
  Hdf5Output file(scratch.string());
  begin_frame(names, file);
  for (const char* counts : arrays_of_counts) file.room_for<std::int64_t>(counts, partitions);
  VtkhdfPlaces places;
  add_room_for_cells({0, cells_of(all), ids_of(all)}, names, file, places);
  file.close();
  remove_file(scratch);
  return places;
}

}  // namespace tetfarm
