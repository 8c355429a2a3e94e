/// Draws flat triangles, the nearest in front, each with its edges.
///
/// How: a depth and a colour for several samples in each pixel, averaged at the end. A triangle's
/// edges are darkened by the distance of a sample to them, and fade where triangles are only a few
/// pixels large. What stands before something farther away gets an outline.
#pragma once

#include <array>
#include <vector>

#include "mesh/render/camera.h"
#include "mesh/render/picture.h"

namespace tetfarm {

struct CanvasOptions {
  int width = 1600;
  int height = 1000;
  int samples = 3;          ///< along a pixel's side
  double edge_width = 0.9;  ///< in pixels; 0: no edges
  Colour background{1, 1, 1};
};

/// Memory: 16 bytes a sample. Cost: that of the samples that triangles cover.
class Canvas {
 public:
  explicit Canvas(const CanvasOptions& options);

  /// Corners in pixels, as Camera::project gives them. @pre depths are positive.
  /// @param has_edge whether the edge opposite of each corner is drawn.
  void draw(const std::array<Seen, 3>& corners, const Colour& colour,
            const std::array<bool, 3>& has_edge = {true, true, true});
  /// `outline_depth`: a step in depth larger than this is outlined.
  Picture picture(double outline_depth) const;

 private:
  struct Sample {
    float depth = 0;
    Colour colour;
  };
  float depth_at(int x, int y) const;
  bool is_on_outline(int x, int y, double outline_depth) const;

  CanvasOptions options_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Sample> samples_;  // rows from the top; depth is infinite where nothing is drawn
};

}  // namespace tetfarm
