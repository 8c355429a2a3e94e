#include "mesh/formats/openfoam/openfoam_source.h"

#include "base/error.h"
#include "mesh/formats/openfoam/poly_mesh_reader.h"
#include "mesh/formats/openfoam/processor_numbers.h"
#include "mesh/formats/parsed_mesh.h"
#include "mesh/formats/regions_of_faces.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

fs::path mesh_of(const fs::path& folder) { return folder / "constant" / "polyMesh"; }

fs::path processor_of(const fs::path& folder, std::size_t i) {
  return folder / ("processor" + std::to_string(i));
}

template <class Nodes>
std::vector<std::int64_t> widened(const Nodes& nodes) {
  return {nodes.begin(), nodes.end()};
}

ElementType type_of(const FaceNodes<std::int32_t>& face) {
  return face.size() == nodes_of(ElementType::triangle) ? ElementType::triangle : ElementType::quad;
}

std::unique_ptr<MeshSource> open_whole(const fs::path& folder, const fs::path& scratch_folder) {
  PolyMeshReader file(folder, scratch_folder);
  ParsedMesh mesh(scratch_folder);
  mesh.mesh().name = folder.string();
  mesh.mesh().region_names = file.region_names();
  for (const FoamPatch& patch : file.patches()) {
    if (patch.processor >= 0) {
      throw InvalidInput("is one processor of a decomposed case; give the folder of the case",
                         folder.string());
    }
    mesh.mesh().patch_names.push_back(patch.name);
  }
  while (const auto node = file.next_node()) mesh.add_node(*node);
  while (const auto face = file.next_face()) {
    mesh.add_face(type_of(face->nodes), widened(face->nodes),
                  static_cast<std::int32_t>(face->patch));
  }
  while (const auto next = file.next_cell()) {
    mesh.add_cell(next->cell.type, widened(next->cell.all_nodes()), next->region);
  }
  return open_listed(mesh.take());
}

/// What a processor has, with its own numbers.
struct ProcessorMesh {
  NumberedPart part;
  std::vector<std::string> patch_names;
  std::vector<std::string> region_names;
  std::vector<ProcessorPatch> between;
};

/// Which region it bounds is known when the cells are.
void add_boundary_face(const FaceNodes<std::int32_t>& face, std::int32_t patch,
                       NumberedPart& part) {
  if (type_of(face) == ElementType::triangle) {
    part.faces.push_back({face[0], face[1], face[2]});
    part.patch_of_face.push_back(patch);
    return;
  }
  ElementBlock& block = part.blocks[type_of(face)];
  block.nodes.insert(block.nodes.end(), face.begin(), face.end());
  block.regions.push_back(part.region);
  block.patches.push_back(patch);
}

void read_faces(PolyMeshReader& file, ProcessorMesh& mesh) {
  constexpr std::size_t is_between = -1;
  std::vector<std::size_t> number_of_patch;
  std::vector<std::size_t> between_of_patch;
  for (const FoamPatch& patch : file.patches()) {
    const bool is_boundary = patch.processor < 0;
    number_of_patch.push_back(is_boundary ? mesh.patch_names.size() : is_between);
    between_of_patch.push_back(mesh.between.size());
    if (is_boundary) {
      mesh.patch_names.push_back(patch.name);
    } else {
      mesh.between.push_back({patch.neighbour, {}});
    }
  }
  while (const auto face = file.next_face()) {
    const std::size_t patch = number_of_patch[face->patch];
    if (patch == is_between) {
      mesh.between[between_of_patch[face->patch]].faces.push_back(face->nodes);
      continue;
    }
    add_boundary_face(face->nodes, static_cast<std::int32_t>(patch), mesh.part);
  }
}

void read_cells(PolyMeshReader& file, NumberedPart& part) {
  while (const auto next = file.next_cell()) {
    const std::span<const std::int32_t> nodes = next->cell.all_nodes();
    if (next->cell.type == ElementType::tet) {
      part.tets.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
      part.region_of_tet.push_back(next->region);
    } else {
      ElementBlock& block = part.blocks[next->cell.type];
      block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
      block.regions.push_back(next->region);
    }
  }
  set_regions_from_cells(part);
}

ProcessorMesh read_processor(const fs::path& folder, const fs::path& scratch_folder) {
  PolyMeshReader file(folder, scratch_folder);
  ProcessorMesh mesh;
  mesh.region_names = file.region_names();
  while (const auto node = file.next_node()) mesh.part.nodes.push_back(*node);
  read_faces(file, mesh);
  read_cells(file, mesh.part);
  return mesh;
}

class DecomposedSource : public MeshSource {
 public:
  DecomposedSource(const fs::path& folder, const fs::path& scratch_folder)
      : scratch_folder_(scratch_folder), numbers_(folder.string()) {
    for (std::size_t i = 0; fs::exists(processor_of(folder, i)); ++i) {
      folders_.push_back(mesh_of(processor_of(folder, i)));
      const ProcessorMesh mesh = read_processor(folders_[i], scratch_folder_);
      if (i == 0) {
        patch_names_ = mesh.patch_names;
        region_names_ = mesh.region_names;
      } else if (patch_names_ != mesh.patch_names || region_names_ != mesh.region_names) {
        throw InvalidInput("has different patches or cell zones from processor 0",
                           folders_[i].string());
      }
      numbers_.add(std::ssize(mesh.part.nodes), mesh.between);
    }
    numbers_.finish();
  }

  std::size_t size() const override { return folders_.size(); }
  bool takes_threads() const override { return true; }
  NumberedPart part(std::size_t i) const override {
    NumberedPart part = read_processor(folders_.at(i), scratch_folder_).part;
    part.number = static_cast<std::int32_t>(i);
    part.local2global = numbers_.local2global(i);
    return part;
  }
  std::vector<std::string> patch_names() const override { return patch_names_; }
  std::vector<std::string> region_names() const override { return region_names_; }

 private:
  fs::path scratch_folder_;
  std::vector<fs::path> folders_;
  ProcessorNumbers numbers_;
  std::vector<std::string> patch_names_;
  std::vector<std::string> region_names_;
};

}  // namespace

bool is_openfoam_case(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(mesh_of(folder), ignored) ||
         fs::is_directory(mesh_of(processor_of(folder, 0)), ignored);
}

std::unique_ptr<MeshSource> open_openfoam(const fs::path& folder, const fs::path& scratch_folder) {
  if (fs::is_directory(mesh_of(folder))) return open_whole(mesh_of(folder), scratch_folder);
  return std::make_unique<DecomposedSource>(folder, scratch_folder);
}

}  // namespace tetfarm
