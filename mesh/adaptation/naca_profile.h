/// The symmetric profiles of NACA's four-digit family as true curves, with a sharp or a blunt
/// trailing edge.
///
/// Source: E. N. Jacobs, K. E. Ward, R. M. Pinkerton, NACA report 460 (1933): half the thickness is
/// 5 t (0.2969 √x - 0.1260 x - 0.3516 x² + 0.2843 x³ - 0.1015 x⁴) chords, which leaves a blunt
/// trailing edge; with 0.1036 it is sharp. By s = ±√x, in which the profile is smooth round its
/// nose; s goes evenly with the length between 1,024 samples. Cost: O(log samples) a point.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/adaptation/true_curve.h"

namespace tetfarm {

struct NacaPlace {
  double thickness = 0.12;  ///< in chords
  bool is_sharp = true;
  Vec2 nose;
  double chord = 1;
  Vec2 along{1, 0};  ///< from the nose to the trailing edge, of length 1
};

/// The direction at an angle from the x axis, anticlockwise; exact at multiples of 90 degrees.
Vec2 direction_of_angle(double angle_deg);

/// From the trailing edge round the nose and back, the domain of a flow to its right.
class NacaProfile : public TrueCurve {
 public:
  /// @pre thickness > 0, chord > 0
  explicit NacaProfile(const NacaPlace& place);

  double length() const override { return lengths_.back(); }
  bool is_closed() const override { return false; }
  Vec2 at(double parameter) const override { return point_of_root(root_of(parameter)); }
  Vec2 direction(double parameter) const override;
  double nearest(const Vec2& p) const override { return samples_.nearest(*this, p); }

 private:
  double root_of(double parameter) const;
  Vec2 point_of_root(double root) const;

  NacaPlace place_;
  std::vector<double> lengths_;  ///< from the trailing edge to each sample
  CurveSamples samples_;
};

/// The profile, and where it is blunt the line between its two ends.
std::vector<std::shared_ptr<const TrueCurve>> naca_parts(const NacaPlace& place);

/// "sharp trailing edge, chord 1 from (0, 0), angle 0", for people.
std::string naca_text(const NacaPlace& place);

}  // namespace tetfarm
