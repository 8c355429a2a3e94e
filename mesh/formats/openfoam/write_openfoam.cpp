#include "mesh/formats/openfoam/write_openfoam.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/openfoam/foam_files.h"
#include "mesh/formats/openfoam/seam_faces.h"
#include "mesh/formats/plain_names.h"

namespace tetfarm {
namespace {

/// A face with the cell or cells that have it; nodes turn round the way out of the owner.
struct FoamFace {
  FaceNodes<std::int64_t> nodes;
  std::int64_t owner = 0;
  std::int64_t neighbour = -1;
};

/// Of all cells: those that two of them share count twice.
std::int64_t faces_of(const ElementCounts& elements) {
  std::int64_t faces = 0;
  for (const ElementType type : all_element_types) {
    faces += elements[type] * std::ssize(element(type).faces);
  }
  return faces;
}

/// Of the face that has most.
std::size_t most_corners_of(const ElementCounts& elements) {
  std::size_t most = nodes_of(ElementType::triangle);
  for (const ElementType type : all_element_types) {
    if (elements[type] == 0) continue;
    for (const ElementFace& face : element(type).faces) most = std::max(most, nodes_of(face.type));
  }
  return most;
}

/// How many there are, and what numbers and records have to have room for.
struct FoamCounts {
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::int64_t faces = 0;
  std::int64_t inner = 0;
  std::size_t most_corners = 3;

  NumberText style() const { return NumberText::text(std::max(points, cells)); }
  std::string note() const {
    return "nPoints: " + std::to_string(points) + " nCells: " + std::to_string(cells) +
           " nFaces: " + std::to_string(faces) + " nInternalFaces: " + std::to_string(inner);
  }
};

/// The lists of faces, in the making.
class FaceLists {
 public:
  FaceLists(const std::filesystem::path& folder, const FoamCounts& counts)
      : style_(counts.style()),
        most_corners_(counts.most_corners),
        faces_(folder, {"faces", "faceList", foam_face_bytes(style_, most_corners_), ""},
               counts.faces),
        owner_(folder, {"owner", "labelList", foam_label_bytes(style_), counts.note()},
               counts.faces),
        neighbour_(folder, {"neighbour", "labelList", foam_label_bytes(style_), counts.note()},
                   counts.inner) {}

  void write(std::int64_t first, const std::vector<FoamFace>& faces) {
    NumberText nodes = style_;
    NumberText owners = style_;
    NumberText neighbours = style_;
    for (const FoamFace& face : faces) {
      put_foam_face(nodes, face.nodes, most_corners_);
      put_foam_label(owners, face.owner);
      if (face.neighbour >= 0) put_foam_label(neighbours, face.neighbour);
    }
    faces_.write(first, nodes.bytes());
    owner_.write(first, owners.bytes());
    if (neighbours.size() > 0) neighbour_.write(first, neighbours.bytes());
  }
  void finish() {
    for (FoamList* list : {&faces_, &owner_, &neighbour_}) list->finish();
  }

 private:
  NumberText style_;
  std::size_t most_corners_;
  FoamList faces_;
  FoamList owner_;
  FoamList neighbour_;
};

void sort_upper_triangular(std::vector<FoamFace>& faces) {
  std::sort(faces.begin(), faces.end(), [](const FoamFace& a, const FoamFace& b) {
    return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
  });
}

/// The faces of a part on each patch that no other part has; `node` numbers nodes, cells are
/// counted from `first_cell`.
template <class Node>
std::vector<std::vector<FoamFace>> patch_faces(const NumberedPart& part, const CellFaces& cells,
                                               const std::vector<SeamFace>& seams,
                                               std::size_t patches, std::int64_t first_cell,
                                               const Node& node) {
  const std::vector<std::int32_t> patch_of_face = patches_of_boundary(part);
  std::vector<bool> is_shared(patch_of_face.size(), false);
  for (const SeamFace& seam : seams) {
    if (seam.face >= 0) is_shared[static_cast<std::size_t>(seam.face)] = true;
  }
  std::vector<std::vector<FoamFace>> faces(patches);
  for (const OuterFace& outer : cells.outer) {
    if (outer.face < 0 || is_shared[static_cast<std::size_t>(outer.face)]) continue;
    const auto patch = patch_of_face[static_cast<std::size_t>(outer.face)];
    faces[static_cast<std::size_t>(patch)].push_back(
        {outer.nodes.renumbered(node), first_cell + outer.owner, -1});
  }
  return faces;
}

template <class Node>
std::vector<FoamFace> inner_faces(const CellFaces& cells, std::int64_t first_cell,
                                  const Node& node) {
  std::vector<FoamFace> faces;
  faces.reserve(cells.inner.size());
  for (const InnerFace& face : cells.inner) {
    faces.push_back(
        {face.nodes.renumbered(node), first_cell + face.owner, first_cell + face.neighbour});
  }
  return faces;
}

/// Every zone is written, on every processor too. `is_here` tells which parts the cells are of,
/// which are counted from `first_cell`.
template <class IsHere>
void write_zones(const std::filesystem::path& folder, const MeshOutline& outline,
                 const std::vector<std::string>& names, std::int64_t first_cell,
                 const IsHere& is_here) {
  if (names.size() < 2) return;
  std::vector<FoamZoneRun> zones;
  for (std::size_t i = 0; i < outline.parts.size(); ++i) {
    if (!is_here(i)) continue;
    const PartOutline& part = outline.parts[i];
    std::int64_t next = part.first_cell - first_cell;
    const auto add = [&](const std::vector<std::int64_t>& cells_of_region) {
      for (std::size_t region = 0; region < cells_of_region.size(); ++region) {
        zones.push_back({region, next, cells_of_region[region]});
        next += cells_of_region[region];
      }
    };
    add(part.tets_of_region);
    for (const ElementType type : cell_block_types) add(part.blocks[type].of_group);
  }
  write_foam_zones(folder, names, zones);
}

constexpr std::size_t longest_name = 200;

/// Without faces.
std::vector<FoamPatch> typed_patches(const std::vector<std::string>& names,
                                     const MeshOutline& outline) {
  std::vector<FoamPatch> patches;
  for (std::size_t i = 0; i < names.size(); ++i) {
    patches.push_back({names[i]});
    patches.back().type = foam_type(type_of_patch(outline.patch_types, i));
  }
  return patches;
}

/// Labels of OpenFOAM have 32 bits unless it was built with more, and number faces too. Boundary
/// faces are of one cell, also those between two regions.
void refuse_more_than_labels(std::int64_t nodes, const ElementCounts& elements,
                             const std::string& instead) {
  const std::string format = "OpenFOAM's labels";
  require_32_bits(nodes, "points", format, instead);
  require_32_bits(count_cells(elements), "cells", format, instead);
  require_32_bits((faces_of(elements) + count_faces(elements) + 1) / 2, "faces", format, instead);
}

}  // namespace

void write_openfoam(const MeshSource& source, const MeshOutline& outline,
                    const std::filesystem::path& folder) {
  refuse_more_than_labels(outline.nodes, outline.elements(), "use openfoam-decomposed");
  const std::filesystem::path mesh = folder / "constant" / "polyMesh";
  make_folders(mesh);
  TF_CHECK(outline.parts.size() == source.size());
  SeamFaces seams(source, outline, mesh);
  const std::vector<std::string> names = plain_names(outline.patch_names, longest_name);
  std::vector<FoamPatch> patches = typed_patches(names, outline);
  std::int64_t on_patches = 0;
  for (const auto& of_part : seams.faces_of_patch()) {
    for (std::size_t i = 0; i < patches.size(); ++i) patches[i].faces += of_part[i];
  }
  for (const FoamPatch& patch : patches) on_patches += patch.faces;
  const ElementCounts elements = outline.elements();
  FoamCounts counts{outline.nodes, outline.cells(), 0, (faces_of(elements) - on_patches) / 2,
                    most_corners_of(elements)};
  counts.faces = counts.inner;
  for (FoamPatch& patch : patches) {
    patch.first_face = counts.faces;
    counts.faces += patch.faces;
  }
  const NumberText style = counts.style();
  FoamList points(mesh, {"points", "vectorField", foam_point_bytes(style), ""}, outline.nodes);
  FaceLists lists(mesh, counts);
  std::vector<std::int64_t> next_of_patch;
  for (const FoamPatch& patch : patches) next_of_patch.push_back(patch.first_face);
  std::int64_t next_inner = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const std::vector<SeamFace> here = seams.next_part();
    const CellFaces cells = cell_faces(part);
    const std::int64_t first_cell = outline.parts[i].first_cell;
    const auto node = [&](std::int32_t v) { return global_node(part, v); };
    write_node_records(
        points.file(), points.first_place(), foam_point_bytes(style), part, style,
        [](NumberText& text, std::int64_t, const Vec3& p) { put_foam_point(text, p); });
    std::vector<FoamFace> inside = inner_faces(cells, first_cell, node);
    for (const SeamFace& seam : here) {
      if (seam.neighbour > seam.part) {
        inside.push_back({seam.nodes, seam.cell, seam.neighbour_cell});
      }
    }
    sort_upper_triangular(inside);
    lists.write(next_inner, inside);
    next_inner += std::ssize(inside);
    const auto outside = patch_faces(part, cells, here, patches.size(), first_cell, node);
    for (std::size_t patch = 0; patch < patches.size(); ++patch) {
      lists.write(next_of_patch[patch], outside[patch]);
      next_of_patch[patch] += std::ssize(outside[patch]);
    }
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    TF_CHECK(next_of_patch[i] == patches[i].first_face + patches[i].faces);
  }
  points.finish();
  lists.finish();
  write_zones(mesh, outline, plain_names(outline.region_names, longest_name), 0,
              [](std::size_t) { return true; });
  write_foam_boundary(mesh, patches);
  write_foam_system(folder, 0);
}

namespace {

/// The faces towards other processors, and their patches behind `patches`.
std::vector<FoamFace> processor_faces(const NumberedPart& part, const std::vector<SeamFace>& seams,
                                      std::int64_t first_cell, std::int64_t first_face,
                                      std::vector<FoamPatch>& patches) {
  std::vector<std::int32_t> by_number(part.nodes.size());
  std::iota(by_number.begin(), by_number.end(), 0);
  const auto number = [&](std::int32_t v) { return global_node(part, v); };
  std::sort(by_number.begin(), by_number.end(),
            [&](std::int32_t a, std::int32_t b) { return number(a) < number(b); });
  const auto local = [&](std::int64_t global) -> std::int64_t {
    return *std::lower_bound(
        by_number.begin(), by_number.end(), global,
        [&](std::int32_t v, std::int64_t wanted) { return number(v) < wanted; });
  };
  std::vector<FoamFace> faces;
  for (const SeamFace& seam : seams) {
    if (patches.empty() || patches.back().neighbour != seam.neighbour) {
      patches.push_back(
          {"procBoundary" + std::to_string(seam.part) + "to" + std::to_string(seam.neighbour), 0,
           first_face + std::ssize(faces), seam.part, seam.neighbour});
    }
    ++patches.back().faces;
    faces.push_back({seam.nodes.renumbered(local), seam.cell - first_cell, -1});
  }
  return faces;
}

void write_points(const std::filesystem::path& mesh, const NumberedPart& part,
                  const NumberText& style) {
  FoamList points(mesh, {"points", "vectorField", foam_point_bytes(style), ""},
                  std::ssize(part.nodes));
  NumberText text = style;
  for (const Vec3& p : part.nodes) put_foam_point(text, p);
  points.append(text.bytes());
  points.finish();
}

void write_processor(const std::filesystem::path& mesh, const NumberedPart& part,
                     const PartOutline& outline, const std::vector<SeamFace>& seams,
                     std::vector<FoamPatch> patches) {
  make_folders(mesh);
  const CellFaces cells = cell_faces(part);
  const auto node = [](std::int32_t v) -> std::int64_t { return v; };
  const std::vector<FoamFace> inside = inner_faces(cells, 0, node);
  const auto outside = patch_faces(part, cells, seams, patches.size(), 0, node);
  FoamCounts counts{outline.nodes, count_cells(outline.elements()), std::ssize(inside),
                    std::ssize(inside), most_corners_of(outline.elements())};
  for (std::size_t i = 0; i < patches.size(); ++i) {
    patches[i].faces = std::ssize(outside[i]);
    patches[i].first_face = counts.faces;
    counts.faces += std::ssize(outside[i]);
  }
  const std::int64_t first_between = counts.faces;
  const std::vector<FoamFace> between =
      processor_faces(part, seams, outline.first_cell, first_between, patches);
  counts.faces += std::ssize(between);
  require_32_bits(counts.faces, "faces", "OpenFOAM's labels", "make more, smaller parts");
  write_points(mesh, part, counts.style());
  FaceLists lists(mesh, counts);
  lists.write(0, inside);
  for (std::size_t i = 0; i < outside.size(); ++i) lists.write(patches[i].first_face, outside[i]);
  lists.write(first_between, between);
  lists.finish();
  write_foam_boundary(mesh, patches);
}

}  // namespace

void write_openfoam_decomposed(const MeshSource& source, const MeshOutline& outline,
                               const std::filesystem::path& folder) {
  for (const PartOutline& part : outline.parts) {
    refuse_more_than_labels(part.nodes, part.elements(), "make more, smaller parts");
  }
  make_folders(folder);
  SeamFaces seams(source, outline, folder);
  const std::vector<FoamPatch> patches =
      typed_patches(plain_names(outline.patch_names, longest_name), outline);
  const std::vector<std::string> regions = plain_names(outline.region_names, longest_name);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::filesystem::path mesh =
        folder / ("processor" + std::to_string(i)) / "constant" / "polyMesh";
    const NumberedPart part = source.part(i);
    write_processor(mesh, part, outline.parts[i], seams.next_part(), patches);
    write_zones(mesh, outline, regions, outline.parts[i].first_cell,
                [i](std::size_t run_of) { return run_of == i; });
  }
  write_foam_system(folder, source.size());
}

}  // namespace tetfarm
