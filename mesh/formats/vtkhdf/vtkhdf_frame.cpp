#include "mesh/formats/vtkhdf/vtkhdf_frame.h"

#include <array>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {
namespace {

/// Each has a number for each partition.
constexpr std::array<const char*, 3> arrays_of_counts = {
    "VTKHDF/NumberOfPoints", "VTKHDF/NumberOfCells", "VTKHDF/NumberOfConnectivityIds"};

std::int64_t cells_of(const VtkhdfCounts& part) {
  std::int64_t cells = part.tets + part.faces;
  for_each_block(part.others, [&](ElementType, std::int64_t count) { cells += count; });
  return cells;
}

std::int64_t ids_of(const VtkhdfCounts& part) {
  std::int64_t ids = 4 * part.tets + 3 * part.faces;
  for_each_block(part.others, [&](ElementType type, std::int64_t count) {
    ids += static_cast<std::int64_t>(nodes_of(type)) * count;
  });
  return ids;
}

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
  file.add_texts("Tetfarm/region_names",
                 names.regions.empty() ? std::vector<std::string>{"domain"} : names.regions);
}

/// `all` is what `partitions` have together.
VtkhdfPlaces add_room(std::int64_t partitions, const VtkhdfBefore& all, const VtkhdfNames& names,
                      Hdf5Output& file) {
  TF_CHECK(partitions >= 0);
  VtkhdfPlaces places;
  places.connectivity = file.room_for<std::int64_t>("VTKHDF/Connectivity", all.ids);
  places.offsets = file.room_for<std::int64_t>("VTKHDF/Offsets", all.cells + partitions);
  places.types = file.room_for<std::uint8_t>("VTKHDF/Types", all.cells);
  places.subdomains = file.room_for<std::int32_t>("VTKHDF/CellData/subdomain", all.cells);
  places.regions = file.room_for<std::int32_t>("VTKHDF/CellData/region", all.cells);
  places.patches = file.room_for<std::int32_t>("VTKHDF/CellData/patch", all.cells);
  for (const CellMark mark : names.marks) {
    const std::string name = std::string("VTKHDF/CellData/") + name_of(mark);
    places.marks.emplace_back(mark, file.room_for<std::int32_t>(name, all.cells));
  }
  places.points = file.room_for<double>("VTKHDF/Points", all.points, 3);
  places.node_numbers = file.room_for<std::int64_t>("VTKHDF/PointData/GlobalNodeId", all.points);
  if (names.has_feet) {
    const std::string folder = "VTKHDF/PointData/";
    const std::int64_t foot = file.room_for<std::int64_t>(folder + foot_array, all.points);
    places.feet = {foot, file.room_for<std::int32_t>(folder + depth_array, all.points)};
  }
  return places;
}

}  // namespace

VtkhdfCounts vtkhdf_counts(const NumberedPart& part) {
  return {std::ssize(part.nodes), std::ssize(part.tets), std::ssize(part.faces),
          counts_of(part.blocks)};
}

std::vector<VtkhdfBefore> before_each(std::span<const VtkhdfCounts> parts) {
  std::vector<VtkhdfBefore> all(1);
  for (const VtkhdfCounts& part : parts) {
    const VtkhdfBefore& last = all.back();
    all.push_back(
        {last.points + part.points, last.cells + cells_of(part), last.ids + ids_of(part)});
  }
  return all;
}

VtkhdfCellPlaces cell_places(const VtkhdfPlaces& places, std::int64_t number,
                             const VtkhdfBefore& before, const VtkhdfCounts& counts) {
  const std::int64_t cells = cells_of(counts);
  const auto words_of_cells = [&](std::int64_t array) {
    return VtkhdfPlace{array + 4 * before.cells, 4 * cells};
  };
  std::vector<VtkhdfPlace> marks;
  for (const auto& mark : places.marks) marks.push_back(words_of_cells(mark.second));
  return {.connectivity = {places.connectivity + 8 * before.ids, 8 * ids_of(counts)},
          // A partition has one offset more than cells.
          .offsets = {places.offsets + 8 * (before.cells + number), 8 * (cells + 1)},
          .types = {places.types + before.cells, cells},
          .subdomains = words_of_cells(places.subdomains),
          .regions = words_of_cells(places.regions),
          .patches = words_of_cells(places.patches),
          .marks = std::move(marks)};
}

std::vector<VtkhdfPlace> VtkhdfCellPlaces::in_order() const {
  std::vector<VtkhdfPlace> places = {connectivity, offsets, types, subdomains, regions, patches};
  places.insert(places.end(), marks.begin(), marks.end());
  return places;
}

VtkhdfPlaces write_vtkhdf_frame(const std::filesystem::path& path,
                                std::span<const VtkhdfCounts> parts, const VtkhdfNames& names) {
  Hdf5Output file(path.string());
  begin_frame(names, file);
  add_counts(parts, file);
  const VtkhdfPlaces places = add_room(std::ssize(parts), before_each(parts).back(), names, file);
  file.close();
  return places;
}

VtkhdfPlaces places_of_cells(const std::filesystem::path& scratch, std::int64_t partitions,
                             const VtkhdfCounts& all, const VtkhdfNames& names) {
  Hdf5Output file(scratch.string());
  begin_frame(names, file);
  for (const char* counts : arrays_of_counts) file.room_for<std::int64_t>(counts, partitions);
  const VtkhdfPlaces places = add_room(partitions, {0, cells_of(all), ids_of(all)}, names, file);
  file.close();
  remove_file(scratch);
  return places;
}

}  // namespace tetfarm
