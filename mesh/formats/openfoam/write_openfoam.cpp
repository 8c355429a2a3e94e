#include "mesh/formats/openfoam/write_openfoam.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/openfoam/foam_files.h"
#include "mesh/formats/openfoam/seam_faces.h"
#include "mesh/formats/plain_names.h"

namespace tetfarm {
namespace {

/// A face with the cell or cells that have it; nodes turn round the way out of the owner.
struct FoamFace {
  std::array<std::int64_t, 3> nodes{};
  std::int64_t owner = 0;
  std::int64_t neighbour = -1;
};

/// The lists of faces, in the making.
class FaceLists {
 public:
  FaceLists(const std::filesystem::path& folder, const NumberText& style, std::int64_t faces,
            std::int64_t inner, const std::string& note)
      : style_(style),
        faces_(folder, {"faces", "faceList", foam_face_bytes(style), ""}, faces),
        owner_(folder, {"owner", "labelList", foam_label_bytes(style), note}, faces),
        neighbour_(folder, {"neighbour", "labelList", foam_label_bytes(style), note}, inner) {}

  void write(std::int64_t first, const std::vector<FoamFace>& faces) {
    NumberText nodes = style_;
    NumberText owners = style_;
    NumberText neighbours = style_;
    for (const FoamFace& face : faces) {
      put_foam_face(nodes, face.nodes);
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
  FoamList faces_;
  FoamList owner_;
  FoamList neighbour_;
};

std::string note_of(std::int64_t points, std::int64_t cells, std::int64_t faces,
                    std::int64_t inner) {
  return "nPoints: " + std::to_string(points) + " nCells: " + std::to_string(cells) +
         " nFaces: " + std::to_string(faces) + " nInternalFaces: " + std::to_string(inner);
}

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
  std::vector<bool> is_shared(part.faces.size(), false);
  for (const SeamFace& seam : seams) {
    if (seam.face >= 0) is_shared[static_cast<std::size_t>(seam.face)] = true;
  }
  std::vector<std::vector<FoamFace>> faces(patches);
  for (const OuterFace& outer : cells.outer) {
    if (outer.face < 0 || is_shared[static_cast<std::size_t>(outer.face)]) continue;
    const auto patch = part.patch_of_face[static_cast<std::size_t>(outer.face)];
    faces[static_cast<std::size_t>(patch)].push_back(
        {{node(outer.nodes[0]), node(outer.nodes[1]), node(outer.nodes[2])},
         first_cell + outer.owner,
         -1});
  }
  return faces;
}

template <class Node>
std::vector<FoamFace> inner_faces(const CellFaces& cells, std::int64_t first_cell,
                                  const Node& node) {
  std::vector<FoamFace> faces;
  faces.reserve(cells.inner.size());
  for (const InnerFace& face : cells.inner) {
    faces.push_back({{node(face.nodes[0]), node(face.nodes[1]), node(face.nodes[2])},
                     first_cell + face.owner,
                     first_cell + face.neighbour});
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
  for (const RegionRun& run : region_runs(outline)) {
    if (!is_here(run.part)) continue;
    zones.push_back(
        {static_cast<std::size_t>(run.region - 1), run.first_tet - first_cell, run.tets});
  }
  write_foam_zones(folder, names, zones);
}

constexpr std::size_t longest_name = 200;

/// Labels of OpenFOAM have 32 bits unless it was built with more, and number faces too. `outer` are
/// faces of one tet, triangles between two regions among them.
void refuse_more_than_labels(std::int64_t nodes, std::int64_t tets, std::int64_t outer,
                             const std::string& instead) {
  const std::string format = "OpenFOAM's labels";
  require_32_bits(nodes, "points", format, instead);
  require_32_bits(tets, "cells", format, instead);
  require_32_bits(2 * tets + (outer + 1) / 2, "faces", format, instead);
}

}  // namespace

void write_openfoam(const MeshSource& source, const MeshOutline& outline,
                    const std::filesystem::path& folder) {
  require_tets_alone(outline, "OpenFOAM cases are written of");
  refuse_more_than_labels(outline.nodes, outline.tets, outline.boundary_triangles,
                          "use openfoam-decomposed");
  const std::filesystem::path mesh = folder / "constant" / "polyMesh";
  make_folders(mesh);
  TF_CHECK(outline.parts.size() == source.size());
  SeamFaces seams(source, outline, mesh);
  const std::vector<std::string> names = plain_names(outline.patch_names, longest_name);
  std::vector<FoamPatch> patches;
  std::int64_t on_patches = 0;
  for (const std::string& name : names) patches.push_back({name});
  for (const auto& of_part : seams.faces_of_patch()) {
    for (std::size_t i = 0; i < patches.size(); ++i) patches[i].faces += of_part[i];
  }
  for (const FoamPatch& patch : patches) on_patches += patch.faces;
  const std::int64_t inner = (4 * outline.tets - on_patches) / 2;
  std::int64_t faces = inner;
  for (FoamPatch& patch : patches) {
    patch.first_face = faces;
    faces += patch.faces;
  }
  const NumberText style = NumberText::text(std::max(outline.nodes, outline.tets));
  FoamList points(mesh, {"points", "vectorField", foam_point_bytes(style), ""}, outline.nodes);
  FaceLists lists(mesh, style, faces, inner, note_of(outline.nodes, outline.tets, faces, inner));
  std::vector<std::int64_t> next_of_patch;
  for (const FoamPatch& patch : patches) next_of_patch.push_back(patch.first_face);
  std::int64_t next_inner = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const std::vector<SeamFace> here = seams.next_part();
    const CellFaces cells = cell_faces(part);
    const std::int64_t first_cell = outline.parts[i].first_tet;
    const auto node = [&](std::int32_t v) { return global_node(part, v); };
    write_node_records(
        points.file(), points.first_place(), foam_point_bytes(style), part, style,
        [](NumberText& text, std::int64_t, const Vec3& p) { put_foam_point(text, p); });
    std::vector<FoamFace> inside = inner_faces(cells, first_cell, node);
    for (const SeamFace& seam : here) {
      if (seam.neighbour > seam.part) {
        inside.push_back({seam.nodes, seam.tet, seam.neighbour_tet});
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
    faces.push_back({{local(seam.nodes[0]), local(seam.nodes[1]), local(seam.nodes[2])},
                     seam.tet - first_cell,
                     -1});
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
                     const std::vector<SeamFace>& seams, std::int64_t first_cell,
                     const std::vector<std::string>& names) {
  make_folders(mesh);
  const NumberText style =
      NumberText::text(static_cast<std::int64_t>(std::max(part.nodes.size(), part.tets.size())));
  const CellFaces cells = cell_faces(part);
  const auto node = [](std::int32_t v) -> std::int64_t { return v; };
  const std::vector<FoamFace> inside = inner_faces(cells, 0, node);
  const auto outside = patch_faces(part, cells, seams, names.size(), 0, node);
  std::vector<FoamPatch> patches;
  std::int64_t faces = std::ssize(inside);
  for (std::size_t i = 0; i < names.size(); ++i) {
    patches.push_back({names[i], std::ssize(outside[i]), faces});
    faces += std::ssize(outside[i]);
  }
  const std::vector<FoamFace> between = processor_faces(part, seams, first_cell, faces, patches);
  const std::int64_t first_between = faces;
  faces += std::ssize(between);
  require_32_bits(faces, "faces", "OpenFOAM's labels", "make more, smaller parts");
  write_points(mesh, part, style);
  FaceLists lists(
      mesh, style, faces, std::ssize(inside),
      note_of(std::ssize(part.nodes), std::ssize(part.tets), faces, std::ssize(inside)));
  lists.write(0, inside);
  for (std::size_t i = 0; i < outside.size(); ++i) lists.write(patches[i].first_face, outside[i]);
  lists.write(first_between, between);
  lists.finish();
  write_foam_boundary(mesh, patches);
}

}  // namespace

void write_openfoam_decomposed(const MeshSource& source, const MeshOutline& outline,
                               const std::filesystem::path& folder) {
  require_tets_alone(outline, "OpenFOAM cases are written of");
  for (const PartOutline& part : outline.parts) {
    refuse_more_than_labels(part.nodes, part.tets, part.faces, "make more, smaller parts");
  }
  make_folders(folder);
  SeamFaces seams(source, outline, folder);
  const std::vector<std::string> names = plain_names(outline.patch_names, longest_name);
  const std::vector<std::string> regions = plain_names(outline.region_names, longest_name);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::filesystem::path mesh =
        folder / ("processor" + std::to_string(i)) / "constant" / "polyMesh";
    const NumberedPart part = source.part(i);
    write_processor(mesh, part, seams.next_part(), outline.parts[i].first_tet, names);
    write_zones(mesh, outline, regions, outline.parts[i].first_tet,
                [i](std::size_t run_of) { return run_of == i; });
  }
}

}  // namespace tetfarm
