/// Draws in the plane: triangles side by side, then lines over them, all without steps at their
/// rims.
///
/// How: a triangle is shaded at several samples in each pixel, and a sample on the edge of two
/// triangles belongs to exactly one of them, so that no sample has to be kept. Lines cover a pixel
/// by their distance to its middle. Coordinates are pixels, x from the left and y from the top;
/// the middle of the first pixel is (0.5, 0.5).
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mesh/geometry/predicates.h"
#include "mesh/render/picture.h"

namespace tetfarm {

/// Pixels from left to right and from top to bottom, without those at right and at bottom.
struct PixelBox {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// A straight line of some width, in pixels.
struct Stroke {
  Vec2 from;
  Vec2 to;
  double width = 1;
};

/// Memory: 20 bytes a pixel.
class PlaneCanvas {
 public:
  /// @pre all are positive. `samples`: along a pixel's side.
  PlaneCanvas(int width, int height, int samples);

  /// From now on nothing is drawn outside of the box.
  void clip_to(const PixelBox& box);
  void clip_to_all() { clip_to({0, 0, width_, height_}); }

  /// The colour at a point of a triangle by its barycentric coordinates.
  using Shade = std::function<Colour(const std::array<double, 3>& shares)>;
  /// Corners either way round. What several triangles cover has the mean of their colours.
  /// Cost: that of the samples covered, and of the rows of samples.
  void fill(const std::array<Vec2, 3>& corners, const Shade& shade);

  /// Lines whose shares of a pixel add up, as those of a mesh do: where they are denser than the
  /// pixels they become an even tone.
  void draw_mesh_lines(std::span<const Stroke> strokes, const Colour& colour, float opacity = 1);
  /// Pieces of one line with round ends and joints, however short they are.
  void draw_line(std::span<const Stroke> strokes, const Colour& colour, float opacity = 1);

  /// The background, white, shows where nothing is drawn.
  Picture picture() const;

 private:
  struct Pixel {
    Colour sum;        // of the colours by their shares
    float weight = 0;  // the sum of the shares
  };
  template <class Cover>
  void cover_along(const Stroke& stroke, const Cover& cover);
  void blend_cover(const Colour& colour, float opacity);
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  int samples_;
  PixelBox clip_;
  std::vector<Pixel> pixels_;
  std::vector<float> cover_;  // of each pixel by the lines being drawn; 0 between two calls
  PixelBox covered_;          // where it may differ from 0
};

}  // namespace tetfarm
