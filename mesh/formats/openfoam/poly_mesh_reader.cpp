#include "mesh/formats/openfoam/poly_mesh_reader.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/formats/count_limit.h"

namespace tetfarm {
namespace {

// What a record takes at least: "(0 0 0)", "3(0 1 2)", "0".
constexpr std::int64_t point_bytes = 7;
constexpr std::int64_t face_bytes = 8;
constexpr std::int64_t label_bytes = 1;

FoamPatch read_patch(FoamText& text) {
  FoamPatch patch;
  patch.name = text.token();
  bool is_between = false;
  patch.faces = patch.first_face = -1;
  text.read_dictionary([&](std::string_view key, std::string_view value) {
    const auto number = [&] {
      const std::int64_t read = text.to_integer(value);
      if (read < 0 || read > most_of_32_bits) text.fail("the number is out of range");
      return read;
    };
    if (key == "type") is_between = value == "processor";
    if (key == "nFaces") patch.faces = number();
    if (key == "startFace") patch.first_face = number();
    if (key == "myProcNo") patch.processor = static_cast<int>(number());
    if (key == "neighbProcNo") patch.neighbour = static_cast<int>(number());
    return false;
  });
  if (patch.faces < 0 || patch.first_face < 0) {
    text.fail("the patch " + tetfarm::quoted(patch.name) + " has no nFaces or no startFace");
  }
  if (is_between && (patch.processor < 0 || patch.neighbour < 0)) {
    text.fail("the patch " + tetfarm::quoted(patch.name) + " has no myProcNo or no neighbProcNo");
  }
  if (!is_between) patch.processor = patch.neighbour = -1;
  return patch;
}

void add_cell(std::vector<FoamZoneRun>& runs, std::size_t zone, std::int64_t cell) {
  if (!runs.empty() && runs.back().zone == zone && runs.back().first + runs.back().count == cell) {
    ++runs.back().count;
  } else {
    runs.push_back({zone, cell, 1});
  }
}

}  // namespace

std::vector<FoamPatch> read_foam_boundary(const std::filesystem::path& file) {
  FoamText text(file);
  std::vector<FoamPatch> patches;
  for (std::int64_t left = text.begin_list(label_bytes); left > 0; --left) {
    patches.push_back(read_patch(text));
  }
  text.end_list();
  return patches;
}

PolyMeshReader::PolyMeshReader(const std::filesystem::path& folder,
                               const std::filesystem::path& scratch_folder)
    : name_(folder.string()),
      patches_(read_foam_boundary(folder / "boundary")),
      points_(folder / "points"),
      faces_(folder / "faces"),
      owner_(folder / "owner"),
      neighbour_(folder / "neighbour"),
      nodes_(points_.begin_list(point_bytes)),
      all_faces_(faces_.begin_list(face_bytes)),
      sides_(scratch_folder) {
  if (owner_.begin_list(label_bytes) != all_faces_) {
    owner_.fail("the number of owners is not that of the faces, " + std::to_string(all_faces_));
  }
  inner_faces_ = neighbour_.begin_list(label_bytes);
  if (inner_faces_ > all_faces_) neighbour_.fail("there are more neighbours than faces");
  check_patches();
  if (std::filesystem::exists(folder / "cellZones")) read_zones(folder / "cellZones");
}

/// They follow one another behind the faces inside.
void PolyMeshReader::check_patches() {
  std::int64_t next = inner_faces_;
  for (const FoamPatch& patch : patches_) {
    if (patch.first_face != next) {
      throw InvalidInput("the patch " + tetfarm::quoted(patch.name) + " begins with face " +
                             std::to_string(patch.first_face) + ", not " + std::to_string(next),
                         name_ + "/boundary");
    }
    next += patch.faces;
  }
  if (next == all_faces_) return;
  throw InvalidInput(
      "the patches end at face " + std::to_string(next) + " of " + std::to_string(all_faces_),
      name_ + "/boundary");
}

void PolyMeshReader::read_zones(const std::filesystem::path& file) {
  FoamText text(file);
  const std::int64_t zones = text.begin_list(label_bytes);
  for (std::int64_t zone = 0; zone < zones; ++zone) {
    region_names_.emplace_back(text.token());
    text.read_dictionary([&](std::string_view key, std::string_view) {
      if (key != "cellLabels") return false;
      for (std::int64_t left = text.begin_list(label_bytes); left > 0; --left) {
        add_cell(zones_, static_cast<std::size_t>(zone), text.label(most_of_32_bits));
        text.pass();
      }
      text.end_list();
      text.expect(";");
      return true;
    });
  }
  text.end_list();
  std::stable_sort(zones_.begin(), zones_.end(),
                   [](const FoamZoneRun& a, const FoamZoneRun& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < zones_.size(); ++i) {
    const std::int64_t cell = zones_[i].first;
    if (zones_[i - 1].first + zones_[i - 1].count > cell) {
      refuse(static_cast<std::int32_t>(cell), "is in two cell zones");
    }
  }
}

std::optional<Vec3> PolyMeshReader::next_node() {
  if (next_node_ == nodes_) {
    points_.end_list();
    return {};
  }
  ++next_node_;
  Vec3 p;
  points_.expect("(");
  for (int axis = 0; axis < 3; ++axis) p[axis] = points_.coordinate();
  points_.expect(")");
  points_.pass();
  return p;
}

/// The next one, and whose it is.
PolyMeshReader::Face PolyMeshReader::read_face() {
  ++faces_read_;
  owner_of_face_ = owner_.label(most_of_32_bits);
  owner_.pass();
  const std::int64_t corners = faces_.integer();
  if (corners < 3 || corners > std::int64_t{most_face_nodes}) {
    faces_.fail("cell " + std::to_string(owner_of_face_) + " is no " + names_of_cells() +
                ": a face has " + std::to_string(corners) + " corners");
  }
  Face face;
  faces_.expect("(");
  for (std::int64_t k = 0; k < corners; ++k) {
    face.set(static_cast<std::size_t>(k), faces_.label(nodes_));
  }
  faces_.expect(")");
  faces_.pass();
  sides_.push({owner_of_face_, face});
  return face;
}

void PolyMeshReader::read_inner_faces() {
  while (faces_read_ < inner_faces_) {
    const Face face = read_face();
    sides_.push({neighbour_.label(most_of_32_bits), face.turned()});
    neighbour_.pass();
  }
}

std::optional<PolyMeshFace> PolyMeshReader::next_face() {
  read_inner_faces();
  if (faces_read_ == all_faces_) {
    for (FoamText* list : {&faces_, &owner_, &neighbour_}) list->end_list();
    return {};
  }
  const auto ends = [this] {
    return patches_[next_patch_].first_face + patches_[next_patch_].faces;
  };
  while (ends() <= faces_read_) ++next_patch_;
  return PolyMeshFace{next_patch_, read_face()};
}

void PolyMeshReader::refuse(std::int32_t cell, const std::string& what) const {
  throw InvalidInput("cell " + std::to_string(cell) + " " + what, name_);
}

/// Cells come in the order of their numbers.
std::int32_t PolyMeshReader::region_of(std::int32_t cell) {
  if (region_names_.empty()) return 1;
  if (next_zone_ == zones_.size() || cell < zones_[next_zone_].first) {
    refuse(cell, "is in no cell zone");
  }
  const FoamZoneRun& run = zones_[next_zone_];
  if (cell == run.first + run.count - 1) ++next_zone_;
  return static_cast<std::int32_t>(run.zone) + 1;
}

CellOfFaces PolyMeshReader::cell_of(std::int32_t cell, const std::vector<Side>& sides) const {
  std::vector<Face> faces;
  for (const Side& side : sides) faces.push_back(side.nodes);
  if (const std::optional<CellOfFaces> found = cell_of_faces(faces)) return *found;
  std::string why = "its faces do not close";
  if (!has_faces_of_a_cell(faces)) {
    const auto triangles = std::count_if(faces.begin(), faces.end(),
                                         [](const Face& face) { return face.size() == 3; });
    why = "it has " + text_of_count(triangles, ElementType::triangle) + " and " +
          text_of_count(std::ssize(faces) - triangles, ElementType::quad);
  }
  refuse(cell, "is no " + names_of_cells() + ": " + why);
}

std::optional<PolyMeshCell> PolyMeshReader::next_cell() {
  const std::int32_t cell = cells_read_;
  const std::vector<Side> sides =
      sides_.take_while([cell](const Side& side) { return side.cell == cell; });
  if (sides.empty()) {
    Side later;
    if (sides_.next(later))
      refuse(cell, "has no faces, but cell " + std::to_string(later.cell) + " does");
    if (next_zone_ < zones_.size()) {
      refuse(static_cast<std::int32_t>(zones_[next_zone_].first),
             "is in a cell zone, but does not exist");
    }
    return {};
  }
  ++cells_read_;
  return PolyMeshCell{cell_of(cell, sides), region_of(cell)};
}

}  // namespace tetfarm
