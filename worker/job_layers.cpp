#include "worker/job_layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/check.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/flat_plate.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

static_assert(most_layers_of_job == most_layers);
static_assert(most_height_ratio_of_job == most_height_ratio &&
              1 / most_height_ratio_of_job == least_height_ratio);

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

/// Where it stands, as it was typed.
std::string place_of(const JobLayers& layers) {
  return layers.typed.empty() ? "[[layers]] of " + patches_text(layers.patches)
                              : "--layers '" + layers.typed + "'";
}

[[noreturn]] void refuse_unmatched(const JobLayers& layers, std::string_view glob,
                                   std::span<const std::string> names) {
  throw UsageError(unmatched_glob_text(glob, names),
                   layers.typed.empty() ? "[[layers]] patches" : place_of(layers));
}

/// Which [[layers]] and which of its patterns a patch is matched by.
struct Match {
  std::size_t layers = 0;
  std::string glob;  ///< "": none
};

void find_patches(const JobFile& job, std::span<const std::string> all_names, std::size_t number,
                  std::vector<Match>& match_of_patch) {
  const JobLayers& layers = job.layers[number];
  for (const std::string& glob : layers.patches) {
    const std::span<const std::string> names = names_on_offer(job, all_names, glob);
    bool has_any = false;
    for (std::size_t patch = 0; patch < names.size(); ++patch) {
      if (!matches_glob(glob, names[patch])) continue;
      has_any = true;
      Match& earlier = match_of_patch[patch];
      if (!earlier.glob.empty() && earlier.layers != number) {
        throw UsageError("the patch " + in_quotes(names[patch]) + " is matched by " +
                             in_quotes(glob) + ", and by " + in_quotes(earlier.glob) + " of " +
                             place_of(job.layers[earlier.layers]) +
                             "; a patch has the layers of one of them only",
                         place_of(layers));
      }
      earlier = {number, glob};
    }
    if (!has_any) refuse_unmatched(layers, glob, names);
  }
}

std::vector<Match> matches_of(const JobFile& job, const SurfaceMesh& surface) {
  const std::vector<std::string> names = patch_names_of(surface);
  TF_CHECK(!names.empty());
  std::vector<Match> match_of_patch(names.size());
  for (std::size_t i = 0; i < job.layers.size(); ++i) find_patches(job, names, i, match_of_patch);
  return match_of_patch;
}

/// The triangles of the patches of one [[layers]], and their edges.
struct Footing {
  std::int64_t triangles = 0;
  double median_edge = 0;  ///< the upper one; every triangle counts its three
};

std::vector<Footing> footings_of(const JobFile& job, const SurfaceMesh& surface,
                                 const std::vector<Match>& match_of_patch) {
  std::vector<Footing> footings(job.layers.size());
  std::vector<std::vector<double>> edges(job.layers.size());
  const auto vertices = static_cast<std::int64_t>(surface.vertices.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Match& match = match_of_patch.at(static_cast<std::size_t>(patch_of(surface, t)));
    const Triangle& nodes = surface.triangles[t];
    const bool is_sound = std::all_of(
        nodes.begin(), nodes.end(), [vertices](std::int32_t v) { return v >= 0 && v < vertices; });
    if (match.glob.empty() || !is_sound) continue;
    ++footings[match.layers].triangles;
    for (std::size_t i = 0; i < 3; ++i) {
      edges[match.layers].push_back(
          distance(surface.vertices[static_cast<std::size_t>(nodes.at(i))],
                   surface.vertices[static_cast<std::size_t>(nodes.at((i + 1) % 3))]));
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].empty()) continue;
    const auto middle = edges[i].begin() + static_cast<std::ptrdiff_t>(edges[i].size() / 2);
    std::nth_element(edges[i].begin(), middle, edges[i].end());
    footings[i].median_edge = *middle;
  }
  return footings;
}

HeightLaw law_of(const JobLayers& layers) {
  if (!layers.heights.empty()) return law_of_heights(layers.heights);
  HeightLaw law;
  law.first = layers.y_plus > 0
                  ? flat_plate(layers.y_plus, layers.reynolds, layers.length).first_height
                  : layers.first_height;
  law.growth = layers.growth;
  law.acceleration = layers.acceleration;
  law.cap = std::max(layers.growth, layers.growth_cap);
  law.equal = static_cast<int>(layers.equal);
  return law;
}

RoomRule room_of(const JobLayers& layers) {
  if (layers.room == "stop") return RoomRule::stop;
  if (layers.room == "scale") return RoomRule::scale;
  TF_CHECK(layers.room == "ratio");
  return RoomRule::ratio;
}

/// The layers that the job asks for, 0: until they are as high as the edges.
int count_of(const JobLayers& layers, const HeightLaw& law) {
  if (layers.total_height == 0) return static_cast<int>(layers.count);
  if (law.first > layers.total_height) {
    throw UsageError("the first layer, " + text_of(law.first) +
                         " high, is higher than all of them together are to be, " +
                         text_of(layers.total_height),
                     place_of(layers));
  }
  const int count = layers_within(law, layers.total_height, most_layers);
  if (total_height(law, count) < layers.total_height) {
    throw UsageError(counted(most_layers, "layer") + ", the most that there may be, are only " +
                         text_of(total_height(law, count)) + " high together, and not " +
                         text_of(layers.total_height) +
                         "; give a higher first layer, or more growth",
                     place_of(layers));
  }
  return count;
}

void require_low_first_layer(const JobLayers& layers, const HeightLaw& law,
                             const Footing& footing) {
  if (footing.triangles == 0 || law.first <= footing.median_edge) return;
  const std::string remedy =
      layers.y_plus > 0 ? "give a smaller y_plus, or the length that reynolds is of in the unit of "
                          "the surface"
                        : "give it in the unit of the surface, at most " +
                              text_of(isotropic_share * footing.median_edge);
  throw UsageError("the first layer would be " + text_of(law.first) +
                       " high, which is more than the median edge of these patches, " +
                       text_of(footing.median_edge) + ": " + remedy,
                   place_of(layers));
}

/// The first layer that is as high as the edges; 0: none is.
int isotropic_layer(const HeightLaw& law, const Footing& footing) {
  const double height = isotropic_share * footing.median_edge;
  const int layer = layers_until(law, height, most_layers);
  return height_of_layer(law, layer) >= height ? layer : 0;
}

/// @throws UsageError when the law is of no use on these edges.
void require_use(const JobLayers& layers, const LayerRequest& request, const Footing& footing) {
  require_low_first_layer(layers, request.law, footing);
  if (footing.triangles > 0 && request.count == 0 && isotropic_layer(request.law, footing) == 0) {
    throw UsageError(
        "not even layer " + std::to_string(most_layers) +
            ", the last that there may be, is as high as the edges of these patches, " +
            text_of(footing.median_edge) + "; give more growth, or a count",
        place_of(layers));
  }
  if (!std::isfinite(total_height(request.law, request.count))) {
    throw UsageError("so many layers that grow so fast have no finite height; give fewer",
                     place_of(layers));
  }
}

/// A side of four corners cannot lie beside tets. @throws UsageError where patches meet whose
/// layers are not of the same elements.
void require_same_elements_where_patches_meet(const JobFile& job, const SurfaceMesh& surface,
                                              const std::vector<Match>& match_of_patch) {
  std::vector<const Match*> at_vertex(surface.vertices.size(), nullptr);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Match& match = match_of_patch.at(static_cast<std::size_t>(patch_of(surface, t)));
    if (match.glob.empty()) continue;
    const JobLayers& layers = job.layers[match.layers];
    for (const std::int32_t v : surface.triangles[t]) {
      if (v < 0 || static_cast<std::size_t>(v) >= at_vertex.size()) continue;
      const Match* const other = std::exchange(at_vertex[static_cast<std::size_t>(v)], &match);
      if (other == nullptr || job.layers[other->layers].elements == layers.elements) continue;
      throw UsageError("its layers are of " + layers.elements + ", and meet those of " +
                           job.layers[other->layers].elements + " of " +
                           place_of(job.layers[other->layers]) + " at " +
                           text_of(surface.vertices[static_cast<std::size_t>(v)]) +
                           "; the sides of prisms have no place beside tets: give both the same "
                           "`elements`",
                       place_of(layers));
    }
  }
}

struct Found {
  std::vector<LayerRequest> requests;
  std::vector<Footing> footings;
};

Found find_layers(const JobFile& job, const SurfaceMesh& surface) {
  Found found;
  if (job.layers.empty()) return found;
  const std::vector<Match> match_of_patch = matches_of(job, surface);
  found.footings = footings_of(job, surface, match_of_patch);
  require_same_elements_where_patches_meet(job, surface, match_of_patch);
  for (std::size_t i = 0; i < job.layers.size(); ++i) {
    const JobLayers& layers = job.layers[i];
    LayerRequest request;
    for (std::size_t patch = 0; patch < match_of_patch.size(); ++patch) {
      const bool is_of_these =
          !match_of_patch[patch].glob.empty() && match_of_patch[patch].layers == i;
      if (is_of_these) request.patches.push_back(static_cast<std::int32_t>(patch));
    }
    request.law = law_of(layers);
    if (!(request.law.first > 0 && std::isfinite(request.law.first))) {
      throw UsageError("the first layer has no height that a number can tell", place_of(layers));
    }
    request.count = count_of(layers, request.law);
    request.room = room_of(layers);
    request.step = static_cast<int>(layers.step);
    request.in_tets = layers.elements == "tets";
    if (layers.fan_angle < no_fan_angle) {
      request.fan_cosine = std::cos(layers.fan_angle / 180 * std::numbers::pi);
    }
    require_use(layers, request, found.footings[i]);
    found.requests.push_back(std::move(request));
  }
  return found;
}

}  // namespace

std::vector<LayerRequest> layer_requests_of(const JobFile& job, const SurfaceMesh& surface) {
  return find_layers(job, surface).requests;
}

std::vector<LayerFigures> layer_figures_of(const JobFile& job, const SurfaceMesh& surface) {
  const std::vector<std::string> names = patch_names_of(surface);
  const Found found = find_layers(job, surface);
  std::vector<LayerFigures> all;
  for (std::size_t i = 0; i < found.requests.size(); ++i) {
    const LayerRequest& request = found.requests[i];
    const Footing& footing = found.footings[i];
    LayerFigures figures;
    for (const std::int32_t patch : request.patches) {
      figures.patches.push_back(names[static_cast<std::size_t>(patch)]);
    }
    figures.triangles = footing.triangles;
    figures.median_edge = footing.median_edge;
    figures.first_height = request.law.first;
    figures.in_tets = request.in_tets;
    if (footing.triangles > 0) {
      figures.isotropic_layer = isotropic_layer(request.law, footing);
      figures.layers = request.count > 0 ? request.count : figures.isotropic_layer;
      figures.last_height = height_of_layer(request.law, figures.layers);
      figures.total_height = total_height(request.law, figures.layers);
    }
    all.push_back(std::move(figures));
  }
  return all;
}

}  // namespace tetfarm
