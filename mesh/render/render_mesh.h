/// Draws a mesh that lies in a file, sub-domain by sub-domain, into a picture.
///
/// Source: the pictures of the thesis: surfaces coloured by sub-domain (fig. 46), sub-domains moved
/// apart (fig. 49), meshes cut open (fig. 105) and layers in a plane (fig. 99). No display and no
/// graphics library are needed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mesh/assemble/global_mesh.h"
#include "mesh/render/camera.h"
#include "mesh/render/picture.h"

namespace tetfarm {

enum class View {
  surface,   ///< the triangles of the input surface
  exploded,  ///< the sub-domains, moved apart
  cut,       ///< the cells on the far side of a plane, and bodies whole
  slice,     ///< the cells where a plane cuts them
};

/// `layer`: two tones in turn in boundary layers, two others in absorbing ones, one beyond them;
/// of cells, which cuts and slices show.
enum class ColourBy { subdomain, region, patch, layer };

struct RenderOptions {
  View view = View::surface;
  ColourBy colour_by = ColourBy::subdomain;
  int width = 1600;
  int height = 1000;
  int samples = 3;          ///< along a pixel's side
  double edge_width = 0.9;  ///< of the triangles' edges, in pixels; 0: none
  CameraOptions camera;
  /// Patches that are bodies: a surface shows nothing else; a cut shows them whole, in grey, and
  /// looks at them. Empty: if a patch is an outer boundary that Tetfarm made, all others are.
  std::vector<std::string> bodies;
  std::vector<std::string> hidden;    ///< patches that are not drawn
  std::vector<Colour> patch_colours;  ///< by patch; none: those of the palette
  Vec3 cut_normal{0, 1, 0};
  std::optional<double> cut_at;  ///< along the normal; nothing: through the middle
  double explosion = 0.4;        ///< how far apart, as a share of the distance from the middle
};

/// Visits the parts of a mesh one after the other, in the same order each time.
using ForEachPart = std::function<void(const std::function<void(NumberedPart& part)>& visit)>;

/// Goes through the parts twice: to find the view, and to draw.
/// @throws UsageError when an option names a patch that there is not, or nothing would be seen.
/// Memory: one part and the samples. Cost: O(n log n) in the tets of each part.
Picture render_mesh(const ForEachPart& for_each_part, const std::vector<std::string>& patch_names,
                    const RenderOptions& options);

}  // namespace tetfarm
