#include "worker/job_pml.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/pml_blocks.h"
#include "mesh/layers/pml_inset.h"
#include "mesh/layers/pml_offset.h"
#include "worker/job_layers.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

std::string pml_place(const JobPml& pml) {
  return pml.typed.empty() ? "[[pml]] patches" : "--pml '" + pml.typed + "'";
}

[[noreturn]] void refuse_unknown_patch(const JobPml& pml, std::string_view glob,
                                       const std::vector<std::string>& names) {
  throw UsageError(unmatched_glob_text(glob, names), pml_place(pml));
}

/// The name "outer" is short for that of the boundary that the job puts round a body.
bool names_patch(const JobFile& job, std::string_view glob, const std::vector<std::string>& names,
                 std::size_t patch) {
  const std::size_t own = names.size() - std::min(added_patches(job), names.size());
  const bool is_plane = job.symmetry && patch + 1 == names.size();
  if (is_plane) return glob.starts_with("symmetry") && matches_glob(glob, names[patch]);
  const bool is_added = patch >= own;
  if (is_added && glob == "outer") return true;
  return matches_glob(glob, names[patch]) && (!is_added || glob.starts_with("outer"));
}

void require_no_other_layers(const JobFile& job, const SurfaceMesh& surface,
                             const std::vector<std::string>& names,
                             const std::vector<std::int32_t>& patches) {
  for (const LayerRequest& request : layer_requests_of(job, surface)) {
    for (const std::int32_t patch : request.patches) {
      if (!std::binary_search(patches.begin(), patches.end(), patch)) continue;
      throw UsageError("the patch \"" + names[static_cast<std::size_t>(patch)] +
                           "\" is to have boundary layers as well; a patch has one kind of layers",
                       pml_place(*job.pml));
    }
  }
}

std::vector<Triangle> triangles_on(const SurfaceMesh& surface,
                                   const std::vector<std::int32_t>& patches) {
  std::vector<Triangle> found;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (std::binary_search(patches.begin(), patches.end(), patch_of(surface, t))) {
      found.push_back(surface.triangles[t]);
    }
  }
  return found;
}

/// The upper one; every triangle counts its three.
double median_edge_of(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<double> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back(distance(vertices[static_cast<std::size_t>(t.at(i))],
                               vertices[static_cast<std::size_t>(t.at((i + 1) % 3))]));
    }
  }
  TF_CHECK(!edges.empty());
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  return *middle;
}

LayerRequest request_of_pml(const JobPml& pml, std::vector<std::int32_t> patches, double height) {
  LayerRequest request;
  request.patches = std::move(patches);
  request.law = {.first = height, .growth = 1, .acceleration = 1, .cap = 1, .equal = 1};
  request.count = static_cast<int>(pml.layers);
  request.in_tets = pml.elements == "tets";
  return request;
}

PmlFigures figures_of(const LayerRequest& request, const SurfaceMesh& surface,
                      std::size_t triangles) {
  constexpr std::int64_t tets_of_each = 3;
  PmlFigures figures;
  const std::vector<std::string> names = patch_names_of(surface);
  for (const std::int32_t patch : request.patches) {
    figures.patches.push_back(names[static_cast<std::size_t>(patch)]);
  }
  figures.layers = request.count;
  figures.height = request.law.first;
  figures.thickness = total_height(request.law, request.count);
  figures.triangles = static_cast<std::int64_t>(triangles);
  const std::int64_t prisms = figures.triangles * figures.layers;
  (request.in_tets ? figures.tets : figures.prisms) =
      request.in_tets ? tets_of_each * prisms : prisms;
  return figures;
}

}  // namespace

std::vector<std::int32_t> pml_patches_of(const JobFile& job, const SurfaceMesh& surface) {
  TF_CHECK(job.pml.has_value());
  const std::vector<std::string> names = patch_names_of(surface);
  std::vector<std::int32_t> patches;
  for (const std::string& glob : job.pml->patches) {
    const std::size_t before = patches.size();
    for (std::size_t patch = 0; patch < names.size(); ++patch) {
      if (names_patch(job, glob, names, patch)) patches.push_back(static_cast<std::int32_t>(patch));
    }
    if (patches.size() == before) refuse_unknown_patch(*job.pml, glob, names);
  }
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  require_no_other_layers(job, surface, names, patches);
  return patches;
}

namespace {

/// What grows, before it is known where.
PmlBlock block_of_layers(const JobFile& job, const SurfaceMesh& surface) {
  const std::vector<std::int32_t> patches = pml_patches_of(job, surface);
  const JobPml& pml = *job.pml;
  const std::vector<Triangle> triangles = triangles_on(surface, patches);
  if (triangles.empty()) throw UsageError("these patches have no triangles", pml_place(pml));
  const double height = pml.height > 0 ? pml.height : median_edge_of(surface.vertices, triangles);
  PmlBlock block;
  block.request = request_of_pml(pml, patches, height);
  block.figures = figures_of(block.request, surface, triangles.size());
  if (!std::isfinite(block.figures.thickness)) {
    throw UsageError("so many layers that are so high have no finite height", pml_place(pml));
  }
  return block;
}

}  // namespace

bool has_pml_blocks(const JobFile& job) { return job.pml && job.pml->corners == "block"; }

PmlBlocksRequest request_of_blocks(const PmlBlock& block) {
  return {block.request.patches, block.request.law, block.request.count};
}

PmlBlock pml_blocks_of(const JobFile& job, const SurfaceMesh& surface) {
  TF_CHECK(has_pml_blocks(job));
  PmlBlock block = block_of_layers(job, surface);
  const PmlBlocksRequest request = request_of_blocks(block);
  require_pml_blocks(surface, request, layer_requests_of(job, surface));
  const PmlBlockCounts counts = counts_of_pml_blocks(surface, request);
  block.figures.triangles = counts.outer_triangles;
  block.figures.tets = counts.tets;
  return block;
}

PmlBlock pml_block_of(const JobFile& job, const SurfaceMesh& surface) {
  PmlBlock block = block_of_layers(job, surface);
  const JobPml& pml = *job.pml;
  const std::vector<std::int32_t>& patches = block.request.patches;
  if (pml.side == "inside") {
    block.surface = surface;
    block.request.ways = pml_ways_inwards(surface, patches, block.figures.thickness);
    return block;
  }
  const std::vector<Vec3> outwards = pml_directions(surface, patches);
  block.surface = moved_outwards(surface, outwards, block.figures.thickness);
  for (const Vec3& way : outwards) block.request.ways.push_back(-way);
  return block;
}

}  // namespace tetfarm
