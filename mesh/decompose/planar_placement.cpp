#include "mesh/decompose/planar_placement.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "mesh/decompose/inertia_matrix.h"
#include "mesh/decompose/invalid_zones.h"

namespace tetfarm {
namespace {

/// How far the share of the work may leave the wanted one, relative to the smaller side.
constexpr double farthest_quantile = 0.44;
constexpr double imbalance_weight = 3;
constexpr double area_weight = 0.3;
constexpr double largest_area_penalty = 1;
constexpr double zone_weight = 0.2;
/// Less for a plane of the lattice where its cells are even: the mesh beside it is the lattice's.
constexpr double lattice_weight = 0.4;
/// Planes on each side of the wanted share, across one direction.
constexpr int fewest_each_side = 3;
constexpr int most_each_side = 9;
/// A lattice plane may leave the wanted share by this much to hold nodes of larger cells.
constexpr double lattice_window = 0.02;

/// A direction to cut across; of the lattice, its number among lattice_plane_normals().
struct Direction {
  Vec3 normal;
  std::optional<std::size_t> lattice;
};

bool is_near_one_of(const std::vector<Direction>& directions, const Vec3& normal) {
  constexpr double nearly_equal = 0.99;
  return std::any_of(directions.begin(), directions.end(), [&](const Direction& d) {
    return std::fabs(dot(d.normal, normal)) > nearly_equal;
  });
}

std::vector<Direction> cutting_directions(const WorkSamples& work, CutPlanes planes) {
  std::vector<Direction> directions;
  if (planes == CutPlanes::automatic || planes == CutPlanes::axis) {
    for (int axis = 0; axis < 3; ++axis) directions.emplace_back().normal[axis] = 1;
  }
  if (planes == CutPlanes::automatic || planes == CutPlanes::inertia) {
    for (const Vec3& axis : principal_axes(inertia_matrix(work))) {
      if (!is_near_one_of(directions, axis)) directions.push_back({axis, {}});
    }
  }
  if (planes == CutPlanes::automatic || planes == CutPlanes::lattice) {
    const auto normals = lattice_plane_normals();
    for (std::size_t i = 0; i < normals.size(); ++i) directions.push_back({normals[i], i});
  }
  return directions;
}

/// The work along a direction: every sample is spread evenly over the width of its cell.
class WorkProfile {
 public:
  WorkProfile(const WorkSamples& work, const Vec3& direction) : total_(work.total) {
    TF_CHECK(!work.samples.empty() && work.total > 0);
    std::vector<Step> steps;
    steps.reserve(2 * work.samples.size());
    for (const WorkSample& s : work.samples) {
      const double width =
          s.width * (std::fabs(direction.x) + std::fabs(direction.y) + std::fabs(direction.z));
      const double at = dot(s.at, direction);
      const double density = s.work / width;
      steps.push_back({at - 0.5 * width, density, density * s.spacing});
      steps.push_back({at + 0.5 * width, -density, -density * s.spacing});
    }
    std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
      return a.at != b.at ? a.at < b.at : a.density < b.density;
    });
    Piece piece;
    for (const Step& step : steps) {
      piece.below += piece.density * (step.at - piece.from);
      piece.from = step.at;
      piece.density += step.density;
      piece.area += step.area;
      pieces_.push_back(piece);
    }
  }

  /// @pre there is work. A share of 0 or less: where it begins.
  double offset_of(double share) const {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), share * total_,
                         [](double wanted, const Piece& piece) { return wanted < piece.below; });
    const Piece& piece = *(after - 1);
    const double missing = std::max(0.0, share * total_ - piece.below);
    return piece.from + (piece.density > 0 ? missing / piece.density : 0);
  }
  double share_below(double offset) const {
    const Piece& piece = piece_at(offset);
    return std::clamp((piece.below + piece.density * (offset - piece.from)) / total_, 0.0, 1.0);
  }
  /// Of the plane inside the sub-domain, in h^2 (times a constant).
  double area_at(double offset) const { return piece_at(offset).area; }

 private:
  struct Step {
    double at = 0;
    double density = 0;  // change of work per length
    double area = 0;     // change of area / h^2
  };
  /// From an offset to that of the next piece.
  struct Piece {
    double from = 0;
    double below = 0;
    double density = 0;
    double area = 0;
  };

  const Piece& piece_at(double offset) const {
    const auto after =
        std::upper_bound(pieces_.begin() + 1, pieces_.end(), offset,
                         [](double at, const Piece& piece) { return at < piece.from; });
    return *(after - 1);
  }

  double total_;
  std::vector<Piece> pieces_;
};

std::vector<double> shares_to_try(double left_share, int each_side) {
  std::vector<double> shares;
  const double room = farthest_quantile * std::min(left_share, 1 - left_share);
  for (int i = -each_side; i <= each_side; ++i) {
    const double step = static_cast<double>(i) / each_side;
    shares.push_back(left_share + room * step * std::fabs(step));
  }
  return shares;
}

double imbalance(double share, double wanted) {
  return std::fabs(share - wanted) / std::min(wanted, 1 - wanted);
}

/// A plane before its penalty is known.
struct Place {
  PlaneCandidate candidate;
  double area = 0;
  double zones = 0;
  double lattice_share = 0;  // of the cut, where the lattice's faces can be the cut's
};

/// Whether the cells round a node, two on each side, are as large as its own.
bool is_among_even_cells(const WorkSample& sample, const SpacingField& spacing) {
  const double cell = spacing.lattice_cell_edge(sample.at);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-2.0, 2.0}) {
      Vec3 beside = sample.at;
      beside[axis] += side * cell;
      if (spacing.lattice_cell_edge(beside) != cell) return false;
    }
  }
  return true;
}

/// The share of the plane's nodes that lie among even cells, from the samples next to it, without
/// those near the rim, where the cut has nodes of its own. `area` is in h^2.
double lattice_share_of(const CutPlane& plane, double area, const WorkSamples& work,
                        const SpacingField& spacing) {
  constexpr double rim = 3;  // in nodes
  const double nodes_across = std::sqrt(area);
  if (nodes_across <= 2 * rim) return 0;
  int near = 0;
  int even = 0;
  for (const WorkSample& sample : work.samples) {
    if (std::fabs(dot(sample.at, plane.normal) - plane.offset) > 0.5 * sample.width) continue;
    ++near;
    if (is_among_even_cells(sample, spacing)) ++even;
  }
  if (near == 0) return 0;
  const double clear = 1 - 2 * rim / nodes_across;
  return clear * clear * even / near;
}

/// The planes at the wanted shares; of the lattice, the coarsest ones near them.
std::vector<Place> places_across(const Direction& direction, const WorkProfile& profile,
                                 const std::vector<double>& shares, const WorkSamples& work,
                                 const SpacingField& spacing) {
  std::vector<Place> places;
  for (const double share : shares) {
    Place place;
    double offset = profile.offset_of(share);
    place.candidate.left_share = share;
    if (direction.lattice) {
      auto plane = spacing.coarsest_lattice_plane(*direction.lattice,
                                                  profile.offset_of(share - lattice_window),
                                                  profile.offset_of(share + lattice_window));
      const bool is_known =
          plane && !places.empty() && places.back().candidate.lattice->sum == plane->sum;
      if (!plane || is_known) continue;
      offset = plane->offset;
      place.candidate.left_share = profile.share_below(offset);
      place.candidate.lattice = plane;
    }
    place.candidate.plane = make_cut_plane(direction.normal, offset);
    place.area = profile.area_at(offset);
    if (direction.lattice) {
      place.lattice_share = lattice_share_of(
          place.candidate.plane, place.area / SpacingField::elements_per_h3, work, spacing);
    }
    places.push_back(place);
  }
  return places;
}

void add_zones(std::vector<Place>& places, const Vec3& normal, const Subdomain& subdomain,
               const SurfaceTopology& topology) {
  std::vector<double> offsets;
  for (const Place& place : places) offsets.push_back(place.candidate.plane.offset);
  const auto areas = area_in_invalid_zones(subdomain, topology, normal, offsets);
  TF_CHECK(areas.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i].zones = areas[i];
}

double penalty_of(const Place& place, double wanted_share, double smallest_area,
                  double whole_area) {
  const double relative_area = smallest_area > 0 ? place.area / smallest_area : 1;
  return imbalance_weight * imbalance(place.candidate.left_share, wanted_share) +
         std::min(largest_area_penalty, area_weight * std::max(0.0, relative_area - 1)) +
         zone_weight * std::min(1.0, place.zones / whole_area) -
         lattice_weight * place.lattice_share;
}

}  // namespace

std::vector<PlaneCandidate> place_planes(const Subdomain& subdomain,
                                         const SurfaceTopology& topology, const WorkSamples& work,
                                         const SpacingField& spacing,
                                         const PlacementOptions& options) {
  if (work.samples.empty()) return {};
  const std::vector<Direction> directions = cutting_directions(work, options.planes);
  const int each_side = std::clamp(options.most / static_cast<int>(directions.size()) / 2,
                                   fewest_each_side, most_each_side);
  const std::vector<double> shares = shares_to_try(options.left_share, each_side);
  std::vector<Place> places;
  double smallest_area = HUGE_VAL;
  for (const Direction& direction : directions) {
    const WorkProfile profile(work, direction.normal);
    smallest_area = std::min(smallest_area, profile.area_at(profile.offset_of(options.left_share)));
    auto across = places_across(direction, profile, shares, work, spacing);
    add_zones(across, direction.normal, subdomain, topology);
    places.insert(places.end(), across.begin(), across.end());
  }
  const double whole_area = norm2(bounding_box(subdomain.vertices).size());
  std::vector<PlaneCandidate> candidates;
  for (Place& place : places) {
    place.candidate.penalty = penalty_of(place, options.left_share, smallest_area, whole_area);
    candidates.push_back(place.candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.penalty < b.penalty; });
  const auto most = static_cast<std::size_t>(options.most);
  if (candidates.size() > most) candidates.resize(most);
  return candidates;
}

}  // namespace tetfarm
