/// The sheet on which a mesh of the plane is drawn: what part of the plane it shows, the frame
/// round that with numbers along it, and what explains the colours beside it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/render/colour_map.h"
#include "mesh/render/plane_canvas.h"

namespace tetfarm {

/// What is seen. Nothing said: all, with a little room round it.
struct PlaneWindow {
  double zoom = 1;
  std::optional<double> across;  ///< instead of zoom: how wide the frame is
  std::optional<Vec2> centre;
  bool shows_all() const { return zoom == 1 && !across && !centre; }
};

/// A rectangle of the plane.
struct PlaneBox {
  Vec2 low;
  Vec2 high;
};

/// One scale for both directions, y upwards.
struct PlaneFrame {
  PixelBox pixels;
  Vec2 low;  ///< the lower left corner in the plane
  double pixels_per_unit = 1;
  double text_height = 0;  ///< of numbers; 0: the picture is too small for any

  Vec2 to_pixel(const Vec2& p) const {
    return {pixels.left + (p.x - low.x) * pixels_per_unit,
            pixels.bottom - (p.y - low.y) * pixels_per_unit};
  }
  Vec2 high() const {
    return {low.x + pixels.width() / pixels_per_unit, low.y + pixels.height() / pixels_per_unit};
  }
};

/// What stands on the right of the frame.
enum class Beside { nothing, colour_bar, legend };

/// The frame in a picture of that size. It fits what is seen; if that is not all, it fills the
/// room that there is. @pre the box of all is finite. @throws UsageError where the part of the
/// plane cannot be told apart by double numbers.
PlaneFrame plane_frame(const PlaneBox& all, const PlaneWindow& window, int width, int height,
                       Beside beside);

/// A line round the frame, and numbers along x and y.
void draw_axes(PlaneCanvas& canvas, const PlaneFrame& frame);

/// The bands with the numbers along them.
void draw_colour_bar(PlaneCanvas& canvas, const PlaneFrame& frame, const FieldLevels& levels);

struct LegendEntry {
  std::string text;
  Colour colour;
  bool is_line = false;  ///< else an area
};
/// As many as have room, from the top; three dots say that there are more.
void draw_legend(PlaneCanvas& canvas, const PlaneFrame& frame,
                 const std::vector<LegendEntry>& entries);

/// What lines, numbers and letters are drawn in.
inline constexpr Colour plane_ink{0.12F, 0.13F, 0.16F};

}  // namespace tetfarm
