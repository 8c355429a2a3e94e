#include "mesh/formats/openfoam/openfoam_source.h"

#include <algorithm>

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

template <class To, std::size_t N>
std::array<To, N> widened(const std::array<std::int32_t, N>& nodes) {
  std::array<To, N> result;
  std::copy(nodes.begin(), nodes.end(), result.begin());
  return result;
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
  while (const auto triangle = file.next_triangle()) {
    mesh.add_triangle(widened<std::int64_t>(triangle->nodes),
                      static_cast<std::int32_t>(triangle->patch));
  }
  while (const auto tet = file.next_tet()) {
    mesh.add_tet(widened<std::int64_t>(tet->nodes), tet->region);
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

void read_triangles(PolyMeshReader& file, ProcessorMesh& mesh) {
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
  while (const auto triangle = file.next_triangle()) {
    const std::size_t patch = number_of_patch[triangle->patch];
    if (patch == is_between) {
      mesh.between[between_of_patch[triangle->patch]].faces.push_back(triangle->nodes);
      continue;
    }
    mesh.part.faces.push_back(triangle->nodes);
    mesh.part.patch_of_face.push_back(static_cast<std::int32_t>(patch));
  }
}

void read_tets(PolyMeshReader& file, NumberedPart& part) {
  while (const auto tet = file.next_tet()) {
    part.tets.push_back(tet->nodes);
    part.region_of_tet.push_back(tet->region);
  }
  const auto& regions = part.region_of_tet;
  if (!regions.empty()) part.region = regions.front();
  if (std::all_of(regions.begin(), regions.end(), [&](auto r) { return r == part.region; })) {
    part.region_of_tet.clear();
  } else {
    set_regions_of_faces(part);
  }
}

ProcessorMesh read_processor(const fs::path& folder, const fs::path& scratch_folder) {
  PolyMeshReader file(folder, scratch_folder);
  ProcessorMesh mesh;
  mesh.region_names = file.region_names();
  while (const auto node = file.next_node()) mesh.part.nodes.push_back(*node);
  read_triangles(file, mesh);
  read_tets(file, mesh.part);
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
