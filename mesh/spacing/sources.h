/// The mesh-control sources: what a point, line or triangle source asks for at a position, or a box
/// or cylinder.
///
/// Source: thesis 3.2 and figure 15; N. P. Weatherill, O. Hassan (thesis [18]). The thesis gives no
/// formula for the decay, and no meaning without a background. Here, at distance r of the entity:
///   r <= inner:           spacing
///   inner < r <= outer:   spacing * (target / spacing)^((r - inner) / (outer - inner))
///   beyond:               no demand of its own
/// where target is the background, or twice the spacing where there is no background ([18]'s outer
/// radius is the distance of doubling). From where the decay is steeper than the growth, the growth
/// holds. Spacing and radii are those at the nearest point of the entity, linear between its
/// corners.
#pragma once

#include <array>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/spacing/spacing_field.h"

namespace tetfarm {

/// @throws InvalidInput: see make_spacing_field.
void check_sources(const std::vector<Source>& sources);

/// A source with its corners' spacing limited by the growth between them.
struct SourceDemand {
  Source source;
  /// Lower bounds for any point of the entity.
  SourceCorner floor;
  bool varies = false;
};

/// @pre check_sources passed.
SourceDemand source_demand(const Source& source, double growth);

/// The nearest point of an entity as weights of its corners (unused corners weigh 0). Boxes and
/// cylinders have the same parameters everywhere: the first corner's; within them the distance
/// is 0.
struct NearestOnSource {
  std::array<double, 3> weight{};
  double distance = 0;
};
NearestOnSource nearest_on_source(const Source& source, const Vec3& point);

/// The radial law above. `background` 0: none. Grows by at most `growth` per unit of `r`.
double source_law(const SourceCorner& parameters, double r, double background, double growth);

/// `asked`: what a source asks for at a point. `floor`: a lower bound of that within `radius` of
/// the point which, as a function of position, grows by no more than `growth` even where the
/// source's own parameters vary.
struct SourceValue {
  double asked = 0;
  double floor = 0;
};
SourceValue source_value(const SourceDemand& demand, const Vec3& point, double radius,
                         double background, double growth);

}  // namespace tetfarm
