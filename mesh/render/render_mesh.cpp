#include "mesh/render/render_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/render/canvas.h"
#include "mesh/render/palette.h"
#include "mesh/render/part_faces.h"
#include "mesh/render/plane_section.h"

namespace tetfarm {
namespace {

/// Of each patch whether it is among those named. @throws UsageError for an unknown name.
std::vector<bool> chosen_patches(const std::vector<std::string>& names,
                                 const std::vector<std::string>& patch_names,
                                 const std::string& option) {
  std::vector<bool> is_chosen(patch_names.size(), false);
  for (const std::string& name : names) {
    const auto found = std::find(patch_names.begin(), patch_names.end(), name);
    if (found == patch_names.end()) {
      std::string known;
      for (const std::string& patch : patch_names) known += (known.empty() ? "" : ", ") + patch;
      throw UsageError("no patch \"" + name + "\"; the patches are " + known, option);
    }
    is_chosen[static_cast<std::size_t>(found - patch_names.begin())] = true;
  }
  return is_chosen;
}

bool is_outer_boundary(const std::string& patch) { return patch.starts_with("outer_"); }

std::vector<bool> body_patches(const RenderOptions& options,
                               const std::vector<std::string>& patch_names) {
  if (!options.bodies.empty()) return chosen_patches(options.bodies, patch_names, "--body");
  std::vector<bool> is_body(patch_names.size(), false);
  if (std::none_of(patch_names.begin(), patch_names.end(), is_outer_boundary)) return is_body;
  for (std::size_t i = 0; i < patch_names.size(); ++i) {
    is_body[i] = !is_outer_boundary(patch_names[i]);
  }
  return is_body;
}

/// The points that lie farthest out in eight directions of the picture: what is between them is as
/// large in the picture as all of it.
class Outermost {
 public:
  explicit Outermost(const ViewAxes& axes) {
    for (const double across : {-1, 0, 1}) {
      for (const double up : {-1, 0, 1}) {
        if (across == 0 && up == 0) continue;
        directions_.push_back(across * axes.right + up * axes.up);
      }
    }
    points_.resize(directions_.size());
  }
  void add(const Vec3& p) {
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const bool is_farther = dot(p - points_[i], directions_[i]) > 0;
      if (is_empty_ || is_farther) points_[i] = p;
    }
    is_empty_ = false;
  }
  /// Moved, each of them.
  void append_to(std::vector<Vec3>& points, const Vec3& move) const {
    if (is_empty_) return;
    for (const Vec3& p : points_) points.push_back(p + move);
  }

 private:
  std::vector<Vec3> directions_;
  std::vector<Vec3> points_;
  bool is_empty_ = true;
};

/// What the first pass finds of each part.
struct PartExtent {
  Box3 box;
  Outermost points;
};

class MeshRenderer {
 public:
  MeshRenderer(const std::vector<std::string>& patch_names, const RenderOptions& options)
      : options_(options),
        is_body_(body_patches(options, patch_names)),
        is_hidden_(chosen_patches(options.hidden, patch_names, "--hide")),
        has_bodies_(std::find(is_body_.begin(), is_body_.end(), true) != is_body_.end()),
        axes_(view_axes(options.camera)),
        body_points_(axes_),
        canvas_({options.width, options.height, options.samples, options.edge_width, {1, 1, 1}}) {}

  Picture render(const ForEachPart& for_each_part) {
    for_each_part([this](const NumberedPart& part) { measure(part); });
    if (all_.empty()) throw UsageError("there is nothing to draw", "render");
    look();
    for_each_part([this](const NumberedPart& part) { draw(part); });
    if (options_.view == View::slice && !has_drawn_) {
      throw UsageError("the plane lies beside the mesh", "--at");
    }
    return canvas_.picture(outline_depth_);
  }

 private:
  bool is_in(const std::vector<bool>& patches, std::int32_t patch) const {
    return patch >= 0 && static_cast<std::size_t>(patch) < patches.size() &&
           patches[static_cast<std::size_t>(patch)];
  }

  void measure(const NumberedPart& part) {
    PartExtent& extent = parts_.emplace_back(PartExtent{{}, Outermost(axes_)});
    for (const Vec3& p : part.nodes) {
      extent.box.add(p);
      extent.points.add(p);
    }
    if (!part.nodes.empty()) all_.add(extent.box);
    for (const ShownFace& face : surface_faces(part)) {
      if (!is_in(is_body_, face.patch)) continue;
      for (const std::int32_t v : face.nodes) {
        bodies_.add(part.nodes[static_cast<std::size_t>(v)]);
        body_points_.add(part.nodes[static_cast<std::size_t>(v)]);
      }
    }
  }

  /// Places camera, plane and parts.
  void look() {
    const bool looks_at_bodies = has_bodies_ && options_.view != View::exploded;
    if (looks_at_bodies && bodies_.empty()) {
      throw UsageError("no triangle belongs to these patches", "--body");
    }
    Box3 all;
    std::vector<Vec3> focus;
    for (const PartExtent& part : parts_) {
      const bool moves = options_.view == View::exploded && !part.box.empty();
      const Vec3 move = moves ? options_.explosion * (part.box.centre() - all_.centre()) : Vec3{};
      moves_.push_back(move);
      if (!part.box.empty()) all.add(Box3{part.box.low + move, part.box.high + move});
      if (!looks_at_bodies) part.points.append_to(focus, move);
    }
    if (looks_at_bodies) focus = body_focus();
    camera_.emplace(all, focus, options_.camera, options_.width, options_.height);
    const Box3 seen = looks_at_bodies ? bodies_ : all;
    outline_depth_ = 0.015 * norm(seen.size());
    normal_ = normalized(options_.cut_normal);
    at_ = options_.cut_at.value_or(dot(normal_, seen.centre()));
    if (dot(normal_, options_.camera.from) < 0) {
      normal_ = -normal_;
      at_ = -at_;
    }
    key_light_ = normalized(-0.45 * axes_.right + 0.75 * axes_.up - axes_.ahead);
  }

  /// The bodies; of a cut, the mesh round them is to be seen too.
  std::vector<Vec3> body_focus() const {
    std::vector<Vec3> focus;
    body_points_.append_to(focus, Vec3{});
    if (options_.view != View::cut && options_.view != View::slice) return focus;
    const double more = 0.12 * norm(bodies_.size());
    std::vector<Vec3> widened;
    for (const Vec3& p : focus) {
      for (const Vec3& way : {axes_.right, axes_.up}) {
        widened.push_back(p + more * way);
        widened.push_back(p - more * way);
      }
    }
    return widened;
  }

  void draw(const NumberedPart& part) {
    switch (options_.view) {
      case View::surface:
        return draw_faces(part, surface_faces(part), Vec3{}, [this](const ShownFace& face) {
          return !has_bodies_ || is_in(is_body_, face.patch);
        });
      case View::exploded:
        return draw_faces(
            part,
            outer_faces(part, std::vector<bool>(static_cast<std::size_t>(cells_of(part)), true)),
            moves_[drawn_++], [](const ShownFace&) { return true; });
      case View::cut:
        return draw_cut(part);
      case View::slice:
        return draw_slice(part);
    }
  }

  /// Each polygon as triangles round its first corner.
  void draw_slice(const NumberedPart& part) {
    const std::vector<std::int32_t> regions = regions_of_cells(part);
    for (const CellSection& section : plane_section(part, normal_, at_)) {
      ShownFace face;
      face.cell = section.cell;
      face.region = regions[static_cast<std::size_t>(section.cell)];
      const Colour colour = colour_of(part, face);
      std::vector<Seen> seen;
      for (const Vec3& p : section.corners) seen.push_back(camera_->project(p));
      for (std::size_t i = 1; i + 1 < seen.size(); ++i) {
        canvas_.draw({seen[0], seen[i], seen[i + 1]}, colour, {true, i + 2 == seen.size(), i == 1});
      }
      has_drawn_ = has_drawn_ || seen.size() > 2;
    }
  }

  void draw_cut(const NumberedPart& part) {
    std::vector<bool> is_kept;
    for (const Tet& tet : part.tets) {
      Vec3 sum;
      for (const std::int32_t v : tet) sum += part.nodes[static_cast<std::size_t>(v)];
      is_kept.push_back(dot(normal_, 0.25 * sum) < at_);
    }
    for_each_block_cell(
        part.blocks, [&](ElementType, std::span<const std::int32_t> nodes, std::int32_t) {
          Vec3 sum;
          for (const std::int32_t v : nodes) sum += part.nodes[static_cast<std::size_t>(v)];
          is_kept.push_back(dot(normal_, sum / static_cast<double>(nodes.size())) < at_);
        });
    draw_faces(part, outer_faces(part, is_kept), Vec3{},
               [this](const ShownFace& face) { return !is_in(is_body_, face.patch); });
    draw_faces(part, surface_faces(part), Vec3{},
               [this](const ShownFace& face) { return is_in(is_body_, face.patch); });
  }

  template <class IsShown>
  void draw_faces(const NumberedPart& part, const std::vector<ShownFace>& faces, const Vec3& move,
                  const IsShown& is_shown) {
    for (const ShownFace& face : faces) {
      if (is_in(is_hidden_, face.patch) || !is_shown(face)) continue;
      std::array<Vec3, 3> points;
      std::array<Seen, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        points[i] = part.nodes[static_cast<std::size_t>(face.nodes[i])] + move;
        corners[i] = camera_->project(points[i]);
      }
      canvas_.draw(corners, lit(colour_of(part, face), points));
    }
  }

  Colour colour_of(const NumberedPart& part, const ShownFace& face) const {
    if (options_.view == View::cut && is_in(is_body_, face.patch)) return neutral_grey;
    switch (options_.colour_by) {
      case ColourBy::subdomain:
        return palette_colour(part.number);
      case ColourBy::region:
        return palette_colour(face.region - 1);
      case ColourBy::layer:
        return colour_of_layer(part, face.cell);
      case ColourBy::patch:
        return colour_of_patch(face.patch);
    }
    return neutral_grey;
  }

  Colour colour_of_patch(std::int32_t patch) const {
    if (patch < 0) return neutral_grey;
    if (options_.patch_colours.empty()) return palette_colour(patch);
    return options_.patch_colours.at(static_cast<std::size_t>(patch));
  }

  static Colour colour_of_layer(const NumberedPart& part, std::int64_t cell) {
    const auto mark_of = [&](CellMark mark) {
      const std::vector<std::int32_t>& marks = part.marks[mark];
      return marks.empty() || cell < 0 ? 0 : marks[static_cast<std::size_t>(cell)];
    };
    const std::int32_t layer = mark_of(CellMark::layer);
    if (layer > 0) return layer_colour(layer, false);
    const std::int32_t depth = mark_of(CellMark::pml_depth);
    return depth > 0 ? layer_colour(depth, true) : beyond_layers;
  }

  /// Flat light from the eye, from above and from everywhere, on either side.
  Colour lit(const Colour& colour, const std::array<Vec3, 3>& points) const {
    const Vec3 across = cross(points[1] - points[0], points[2] - points[0]);
    const double length = norm(across);
    if (!(length > 0)) return colour;
    Vec3 normal = across / length;
    if (dot(normal, camera_->eye() - points[0]) < 0) normal = -normal;
    const double light = 0.50 + 0.36 * std::max(0.0, dot(normal, key_light_)) +
                         0.24 * std::max(0.0, -dot(normal, axes_.ahead));
    const auto level = static_cast<float>(light);
    return {std::min(1.0F, colour.red * level), std::min(1.0F, colour.green * level),
            std::min(1.0F, colour.blue * level)};
  }

  const RenderOptions& options_;
  std::vector<bool> is_body_;
  std::vector<bool> is_hidden_;
  bool has_bodies_;
  ViewAxes axes_;
  Box3 all_;
  Box3 bodies_;
  Outermost body_points_;
  std::vector<PartExtent> parts_;
  Canvas canvas_;
  std::vector<Vec3> moves_;  // of each part
  std::size_t drawn_ = 0;
  bool has_drawn_ = false;  // anything of a slice
  std::optional<Camera> camera_;
  Vec3 normal_;  // of the cut, towards the eye
  double at_ = 0;
  Vec3 key_light_;
  double outline_depth_ = 0;
};

}  // namespace

Picture render_mesh(const ForEachPart& for_each_part, const std::vector<std::string>& patch_names,
                    const RenderOptions& options) {
  return MeshRenderer(patch_names, options).render(for_each_part);
}

}  // namespace tetfarm
