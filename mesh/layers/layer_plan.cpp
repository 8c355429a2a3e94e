#include "mesh/layers/layer_plan.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/column_shape.h"
#include "mesh/layers/costly_fans.h"
#include "mesh/layers/first_heights.h"
#include "mesh/layers/layer_proof.h"
#include "mesh/layers/line_fans.h"
#include "mesh/layers/line_lean.h"
#include "mesh/layers/line_room.h"
#include "mesh/layers/marching_direction.h"
#include "mesh/layers/wall_graph.h"
#include "mesh/layers/wall_planes.h"

namespace tetfarm {
namespace {

/// Where lines lose layers because of how they lean, those so many edges round them try the other
/// ways, all of them so many times: what one place gains may leave the next one room.
constexpr int edges_to_lean = 2;
constexpr int rounds_of_leaning = 2;

/// Rounds of the proof in which lines lose no more layers than they must.
constexpr int patient_rounds = 30;

/// Fans so many edges away from where cells fold may be what it costs: the nearest first.
constexpr std::array edges_to_fans = {1, 3};

/// The first height may be less than asked by a hundredth where a line follows a sliver.
constexpr double least_of_first_height = 0.99;

/// A line is made lower so many times before it loses layers.
constexpr int most_lowered = 8;

/// Of the scaled Jacobian of a straight prism, those further up are to keep so much.
constexpr double least_share_of_jacobian = 0.3;

/// For its prisms' shape a line keeps at least this share of its height each time.
constexpr double least_share_of_height = 0.8;

/// Above the first layer a line is at most so many times as long as the layers are high: at the tip
/// of a needle those further up are lower, and no spike.
constexpr double longest_line = 4;

/// From line to line heights rise by at most this share of the distance.
constexpr double steepest_rise = 0.5;

/// The triangles of the patches with layers, and whose request each is.
struct Wall {
  std::vector<std::int32_t> triangles;
  std::vector<std::int32_t> request;  // of each
};

Wall wall_of(const SurfaceMesh& surface, std::span<const LayerRequest> requests) {
  std::vector<std::int32_t> request_of_patch(std::max<std::size_t>(1, surface.patch_names.size()),
                                             -1);
  for (std::size_t r = 0; r < requests.size(); ++r) {
    for (const std::int32_t patch : requests[r].patches) {
      TF_CHECK(at(patch) < request_of_patch.size() && request_of_patch[at(patch)] < 0);
      request_of_patch[at(patch)] = static_cast<std::int32_t>(r);
    }
  }
  Wall wall;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::int32_t request = request_of_patch[at(patch_of(surface, t))];
    if (request < 0) continue;
    wall.triangles.push_back(static_cast<std::int32_t>(t));
    wall.request.push_back(request);
  }
  return wall;
}

/// The way that a line goes above its first layer where it goes straight on.
Vec3 shortened(const Vec3& way) {
  const double length = norm(way);
  return length > longest_line ? longest_line / length * way : way;
}

/// Into the domain, of length 1.
Vec3 inward_normal(const SurfaceMesh& surface, std::int32_t triangle) {
  const Triangle& t = surface.triangles[at(triangle)];
  const Vec3 a = surface.vertices[at(t[0])];
  return normalized(cross(surface.vertices[at(t[2])] - a, surface.vertices[at(t[1])] - a));
}

/// Makes a plan, and keeps what only its making needs.
class Planning {
 public:
  /// @param single feet, ascending, that have no fan.
  Planning(const SurfaceMesh& surface, std::span<const LayerRequest> requests,
           std::span<const std::int32_t> single)
      : surface_(surface), requests_(requests), single_(single), wall_(wall_of(surface, requests)) {
    for (const std::int32_t t : wall_.triangles) normals_.push_back(inward_normal(surface_, t));
    set_graph(wall_graph(surface, wall_.triangles));
    find_requests();
  }

  LayerPlan plan() {
    find_directions();
    find_wishes();
    if (find_fans()) find_wishes();
    begun_ = plan_;
    slivers_ = slivers_of(ground());
    find_lean(Lean::as_neighbours);
    Leans leans(plan_.lines.size(), 0);
    if (const std::optional<UsageError> refusal = grow_by(leans)) throw *refusal;
    for (int round = 0; round < rounds_of_leaning; ++round) try_leans(leans);
    keep_shapes(leans);
    return std::move(plan_);
  }

 private:
  using Leans = std::vector<std::size_t>;                 // of each line, in all_leans
  using Places = std::vector<std::vector<std::int32_t>>;  // the lines of each

  void set_graph(WallGraph graph) {
    graph_ = std::move(graph);
    planes_ = wall_planes(surface_, graph_);
    plan_.vertex2line = graph_.vertex2line;
    plan_.wall = graph_.wall;
    plan_.lines.resize(graph_.feet.size());
    places_.clear();
    for (const std::int32_t foot : graph_.feet) places_.push_back(surface_.vertices[at(foot)]);
  }

  /// Of feet between two requests the lower one decides.
  void find_requests() {
    request_of_foot_.assign(surface_.vertices.size(), std::ssize(requests_));
    for (std::size_t i = 0; i < wall_.triangles.size(); ++i) {
      for (const std::int32_t v : surface_.triangles[at(wall_.triangles[i])]) {
        std::ptrdiff_t& request = request_of_foot_[at(v)];
        request = std::min<std::ptrdiff_t>(request, wall_.request[i]);
      }
    }
  }

  const LayerRequest& request_of(std::size_t line) const {
    return requests_[at(request_of_foot_[at(graph_.feet[line])])];
  }

  bool follows_ways(std::size_t line) const { return !request_of(line).ways.empty(); }

  void find_directions() {
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      line.foot = line.because_of = graph_.feet[i];
      line.at = places_[i];
      line.in_tets = request_of(i).in_tets;
      if (follows_ways(i)) {
        line.along = line.later = request_of(i).ways[at(line.foot)];
        line.of_pml = true;
        TF_CHECK(!graph_.at_border[i] && !(line.along == Vec3{}));
        continue;
      }
      const std::vector<Vec3> normals = normals_at(ground(), i);
      const Vec3 direction =
          planes_.held(i, marching_direction(with_images(normals, planes_, i)).direction);
      const double seen = visibility(direction, normals);
      if (seen >= least_visibility) {
        line.along = direction / seen;
      } else {
        line.reason = StopReason::ridge;
      }
      if (graph_.at_border[i] && !planes_.holds(i)) line.reason = StopReason::border;
    }
  }

  /// Where edges are sharp, lines become several. Returns whether there are such places.
  bool find_fans() {
    std::vector<FanWish> wishes;
    std::vector<Vec3> along;
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      const LayerLine& line = plan_.lines[i];
      const LayerRequest& request = request_of(i);
      along.push_back(line.along);
      const bool is_single =
          follows_ways(i) || std::binary_search(single_.begin(), single_.end(), line.foot);
      wishes.push_back({is_single ? -1 : request.fan_cosine, line.law, line.wanted});
    }
    LineFans fans = line_fans(surface_, graph_, planes_, normals_, along, wishes);
    if (fans.pieces.empty()) return false;
    const std::vector<LayerLine> single = std::move(plan_.lines);
    const std::vector<std::int32_t> single_at = graph_.vertex2line;
    set_graph(with_fans(graph_, fans.feet, fans.corners, fans.pieces));
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      line = single[at(single_at[at(graph_.feet[i])])];
      if (!graph_.is_of_fan(i)) continue;
      line.along = line.later = fans.along[i];
      line.early = fans.early[i];
      line.reason = StopReason::complete;
    }
    plan_.fans = std::move(fans.pieces);
    plan_.fan_corners = std::move(fans.corners);
    return true;
  }

  /// Where lines stop because of how they lean, they try the other ways, one after the other.
  void try_leans(Leans& leans) {
    for (std::size_t way = 1; way < all_leans.size(); ++way) {
      const Places places = places_of_stops();
      if (places.empty()) return;
      while (leans_.size() < all_leans.size()) find_lean(all_leans.at(leans_.size()));
      try_way(way, places, leans);
    }
  }

  /// How lines lean in the next way; those with ways of their own stay.
  void find_lean(Lean lean) {
    std::vector<Vec3> along;
    for (std::size_t i = 0; i < begun_.lines.size(); ++i) {
      along.push_back(follows_ways(i) ? Vec3{} : begun_.lines[i].along);
    }
    leans_.push_back(leaning(ground(), along, lean));
  }

  LineGround ground() const { return {graph_, planes_, normals_, places_}; }

  /// Lets the lines at these places lean so many ways further, where that leaves more layers.
  void try_way(std::size_t way, const Places& places, Leans& leans) {
    const LayerPlan before = plan_;
    if (!grow_by(with_others(leans, places, way))) {
      // Each place for itself: what serves one may cost another layers.
      const Places served = places_served(places, before);
      Leans some = with_others(leans, served, way);
      const bool is_whole = served.size() == places.size() || (!served.empty() && !grow_by(some));
      if (is_whole && missing_of_lines(plan_) < missing_of_lines(before)) {
        leans = std::move(some);
        return;
      }
    }
    plan_ = before;
  }

  /// Gives the lines what layers they can have. Returns why not, where lines that have to have all
  /// cannot.
  std::optional<UsageError> grow_by(const Leans& leans) {
    plan_ = begun_;
    for (std::size_t i = 0; i < leans.size(); ++i) {
      if (follows_ways(i)) continue;
      LayerLine& line = plan_.lines[i];
      line.later = leans_[leans[i]][i];
      if (all_leans.at(leans[i]) == Lean::from_wall) line.along = line.later;
      line.later = shortened(line.later);
    }
    follow_slivers(leans);
    begin_levelling();
    find_rooms();
    fit_heights();
    return prove();
  }

  /// Makes the first layer as high above all faces as was asked for, as the lines are now.
  void begin_levelling() {
    unlevelled_.clear();
    is_held_.clear();
    turns_at_first_.assign(plan_.lines.size(), false);
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      unlevelled_.push_back(plan_.lines[i].along);
      is_held_.push_back(follows_ways(i));
    }
    level_heights();
  }

  void level_heights() {
    std::vector<Vec3> along = unlevelled_;
    level_first_heights(ground(), is_held_, along);
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) plan_.lines[i].along = along[i];
  }

  /// Where prisms lose their shape on the way up, their lines grow less, as long as no layer is
  /// lost.
  void keep_shapes(const Leans& leans) {
    if (poor_layers(shaped_layers()) == 0) return;
    const LayerPlan grown = plan_;
    if (grow_by(leans)) {
      plan_ = grown;
      return;
    }
    LayerPlan best = plan_;
    std::vector<int> shaped = shaped_layers();
    std::int64_t fewest = poor_layers(shaped);
    for (int round = 0; round < most_lowered && lower_for_shape(shaped); ++round) {
      fit_heights();
      if (prove() || missing_of_lines(plan_) > missing_of_lines(best)) break;
      shaped = shaped_layers();
      const std::int64_t poor = poor_layers(shaped);
      if (poor >= fewest) continue;
      fewest = poor;
      best = plan_;
    }
    plan_ = std::move(best);
  }

  std::vector<int> shaped_layers() const {
    return well_shaped_layers(plan_, surface_, least_share_of_jacobian);
  }

  std::int64_t poor_layers(const std::vector<int>& shaped) const {
    std::int64_t poor = 0;
    for (std::size_t i = 0; i < shaped.size(); ++i) poor += plan_.lines[i].stop - shaped[i];
    return poor;
  }

  /// Returns whether a line is to be lower.
  bool lower_for_shape(const std::vector<int>& shaped) {
    bool any_lower = false;
    for (std::size_t i = 0; i < shaped.size(); ++i) {
      const LayerLine& line = plan_.lines[i];
      const bool may_grow_less = !follows_ways(i) && request_of(i).room == RoomRule::ratio;
      if (shaped[i] == line.stop || !may_grow_less) continue;
      const std::vector<double> levels = levels_of(line.law, line.stop);
      const double height = std::max({levels[at(shaped[i])], least_height(line.law, line.stop),
                                      least_share_of_height * levels.back()});
      if (height >= levels.back()) continue;
      rooms_[i] = height;
      any_lower = true;
    }
    return any_lower;
  }

  /// Lets the lines in the middle of slivers go between those at the ends, as high as these, where
  /// that is high enough for the other faces.
  void follow_slivers(const Leans& leans) {
    followed_.clear();
    for (const Sliver& sliver : slivers_) {
      const std::size_t middle = at(sliver.middle);
      const bool is_held = graph_.is_of_fan(middle) || graph_.at_border[middle];
      if (all_leans.at(leans[middle]) != Lean::as_slivers || is_held) continue;
      const LayerLine& from = plan_.lines[at(sliver.ends[0])];
      const LayerLine& to = plan_.lines[at(sliver.ends[1])];
      if (from.along == Vec3{} || to.along == Vec3{}) continue;
      const auto between = [&](const Vec3& a, const Vec3& b) { return a + sliver.share * (b - a); };
      const Vec3 along = between(from.along, to.along);
      if (visibility(along, normals_at(ground(), middle)) < least_of_first_height) continue;
      plan_.lines[middle].along = along;
      plan_.lines[middle].later = between(from.later, to.later);
      followed_.push_back(sliver);
    }
  }

  /// The lines of a sliver turn at the same heights and end together.
  void level_slivers(std::vector<double>& room) const {
    for (const Sliver& sliver : followed_) {
      const double least =
          std::min({room[at(sliver.middle)], room[at(sliver.ends[0])], room[at(sliver.ends[1])]});
      for (const std::int32_t line : {sliver.middle, sliver.ends[0], sliver.ends[1]}) {
        room[at(line)] = least;
      }
    }
  }

  static std::int64_t missing_of_lines(const LayerPlan& plan) {
    std::int64_t missing = 0;
    for (const LayerLine& line : plan.lines) missing += line.wanted - line.stop;
    return missing;
  }

  /// The lines round each one whose cells fold, or whose top crosses something.
  Places places_of_stops() const {
    std::set<std::int32_t> sources;
    for (const LayerLine& line : plan_.lines) {
      if (line.reason != StopReason::fold && line.reason != StopReason::crossing) continue;
      sources.insert(graph_.vertex2line[at(line.because_of)]);
    }
    Places places;
    for (const std::int32_t source : sources) places.push_back(lines_round(source));
    return places;
  }

  std::vector<std::int32_t> lines_round(std::int32_t line) const {
    std::set<std::int32_t> round = {line};
    for (int edge = 0; edge < edges_to_lean; ++edge) {
      const std::set<std::int32_t> before = round;
      for (const std::int32_t near : before) {
        const auto neighbours = graph_.neighbours.of(near);
        round.insert(neighbours.begin(), neighbours.end());
      }
    }
    return {round.begin(), round.end()};
  }

  /// The places that have more layers now.
  Places places_served(const Places& places, const LayerPlan& before) const {
    Places served;
    for (const std::vector<std::int32_t>& place : places) {
      int gained = 0;
      for (const std::int32_t line : place) {
        gained += plan_.lines[at(line)].stop - before.lines[at(line)].stop;
      }
      if (gained > 0) served.push_back(place);
    }
    return served;
  }

  static Leans with_others(Leans leans, const Places& places, std::size_t further) {
    const Leans before = leans;
    for (const std::vector<std::int32_t>& place : places) {
      for (const std::int32_t line : place) {
        leans[at(line)] = (before[at(line)] + further) % all_leans.size();
      }
    }
    return leans;
  }

  double mean_edge(std::size_t line) const {
    const auto neighbours = graph_.neighbours.of(static_cast<std::int32_t>(line));
    double sum = 0;
    std::ptrdiff_t edges = 0;
    for (const std::int32_t n : neighbours) {
      if (graph_.feet[at(n)] == graph_.feet[line]) continue;
      sum += distance(places_[line], places_[at(n)]);
      ++edges;
    }
    return sum / static_cast<double>(edges);
  }

  /// Where the edges decide how many layers there are, neighbours want numbers that differ by no
  /// more than their stops may.
  void find_wishes() {
    std::vector<int> wishes;
    steps_.clear();
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      const LayerRequest& request = request_of(i);
      plan_.lines[i].law = request.law;
      plan_.lines[i].first_wanted = request.law.first;
      steps_.push_back(request.step);
      wishes.push_back(request.count > 0 ? request.count
                                         : layers_until(request.law, isotropic_share * mean_edge(i),
                                                        most_layers));
    }
    limit_steps(graph_, steps_, wishes);
    for (std::size_t i = 0; i < wishes.size(); ++i) plan_.lines[i].wanted = wishes[i];
  }

  /// How high the layers of each line may be, by what can be seen of the surface and the lines.
  void find_rooms() {
    std::vector<double> wanted;
    std::vector<Vec3> along;
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      const LayerLine& line = plan_.lines[i];
      wanted.push_back(total_height(line.law, line.wanted));
      along.push_back(follows_ways(i) ? Vec3{} : line.later);
    }
    rooms_ = free_ways(surface_, graph_, planes_, along, wanted);
    limits_.assign(rooms_.size(), {StopReason::no_room, most_layers, 0});
    const std::vector<double> unfolded = fold_heights(surface_, graph_, along, wanted);
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      if (rooms_[i] >= unfolded[i]) limits_[i].reason = StopReason::fold;
      rooms_[i] = std::min(rooms_[i], unfolded[i]);
    }
  }

  /// Gives the lines layers, from none on, by their rooms and limits and those of their neighbours.
  void fit_heights() {
    std::vector<double> room = rooms_;
    level_slivers(room);
    const std::vector<std::int32_t> sources = limit_slopes(graph_, places_, steepest_rise, room);
    level_slivers(room);
    for (std::size_t i = 0; i < room.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      const auto [along, later] = std::pair(line.along, line.later);
      line = begun_.lines[i];
      line.along = along;
      line.later = later;
      line.bends_from = line.law.first;
      const bool turns_slowly = shortened(along) == along && !turns_at_first_[i];
      line.bends_to = turns_slowly ? room[i] : line.bends_from;
      fit_into(room[i], request_of(i).room, line);
      if (line.stop == line.wanted || line.reason != StopReason::complete) continue;
      const std::size_t source = at(sources[i]);
      line.because_of = graph_.feet[source];
      line.reason = limits_[source].reason;
    }
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      if (line.stop <= limits_[i].stop) continue;
      line.stop = limits_[i].stop;
      line.reason = limits_[i].reason;
      line.because_of = line.foot;
    }
    hold_neighbours();
  }

  /// Gives the line the layers that the room has for it.
  static void fit_into(double room, RoomRule rule, LayerLine& line) {
    if (line.reason != StopReason::complete) return;
    const double total = total_height(line.law, line.wanted);
    line.stop = line.wanted;
    if (total <= room) return;
    const double scaled = line.law.first * (room / total);
    if (rule == RoomRule::scale && scaled > 0) {
      line.law.first = scaled;
      return;
    }
    if (rule == RoomRule::ratio) line.law = fitted(line.law, line.wanted, room);
    const std::vector<double> levels = levels_of(line.law, line.wanted);
    line.stop =
        static_cast<int>(std::upper_bound(levels.begin(), levels.end(), room) - levels.begin()) - 1;
  }

  std::vector<int> stops() const {
    std::vector<int> stops;
    for (const LayerLine& line : plan_.lines) stops.push_back(line.stop);
    return stops;
  }

  /// A line that is to stop for its cells first leaves the way that its first layer has been given
  /// for its height right above that, and then altogether; then it is made straight, where it is
  /// not, and then lower, where this leaves it more layers. Returns why not, where one has to have
  /// all its layers.
  std::optional<UsageError> take_stops(const std::vector<int>& stops, StopReason reason) {
    bool holds_more = false;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      if (stops[i] == line.stop) continue;
      TF_CHECK(stops[i] < line.stop);
      if (follows_ways(i)) return refusal_of(line, reason);
      if (reason == StopReason::fold && line.along != unlevelled_[i]) {
        if (!turns_at_first_[i]) {
          turns_at_first_[i] = true;
        } else {
          is_held_[i] = holds_more = true;
        }
        continue;
      }
      const Vec3 straight = shortened(line.along);
      if (reason == StopReason::fold && line.later != straight) {
        line.later = straight;
        continue;
      }
      limits_[i].reason = reason;
      if (can_be_lower(i, stops[i])) {
        rooms_[i] = levels_of(line.law, stops[i]).back();
        ++limits_[i].lowered;
      } else {
        limits_[i].stop = stops[i];
      }
    }
    if (holds_more) level_heights();
    return std::nullopt;
  }

  /// Whether more layers than so many have room up to the height that they have now.
  bool can_be_lower(std::size_t i, int stop) const {
    const LayerLine& line = plan_.lines[i];
    if (request_of(i).room != RoomRule::ratio || limits_[i].lowered == most_lowered) return false;
    return levels_of(line.law, stop).back() >= least_height(line.law, stop + 1);
  }

  static UsageError refusal_of(const LayerLine& line, StopReason reason) {
    return UsageError(
        std::string("all of them have to be whole, and at ") + text_of(point_of(line, line.stop)) +
            (reason == StopReason::fold ? " their cells would turn over"
                                        : " they would meet other layers, or the surface") +
            "; give fewer or lower layers",
        "absorbing layers");
  }

  void hold_neighbours() {
    std::vector<int> held = stops();
    const std::vector<std::int32_t> sources = limit_steps(graph_, steps_, held);
    for (std::size_t i = 0; i < held.size(); ++i) {
      LayerLine& line = plan_.lines[i];
      if (held[i] == line.stop) continue;
      // What holds it back may be held back itself, but has its reason by now.
      const LayerLine& source = plan_.lines[at(sources[i])];
      line.stop = held[i];
      line.reason = source.reason;
      line.because_of = source.because_of;
    }
  }

  /// Ends: each round but the last takes layers away, or makes lines straight; from some round on
  /// a line that has to stop earlier loses all its layers. Returns as grow_by does.
  std::optional<UsageError> prove() {
    for (int round = 0;; ++round) {
      StopReason reason = StopReason::fold;
      ProofFindings findings = prove_cells(plan_, surface_);
      if (findings.holds) {
        reason = StopReason::crossing;
        findings = prove_top(plan_, surface_, planes_);
      }
      if (findings.holds) return std::nullopt;
      if (round >= patient_rounds) give_up_lines(findings.stops);
      if (auto refusal = take_stops(findings.stops, reason)) return refusal;
      fit_heights();
    }
  }

  void give_up_lines(std::vector<int>& stops) const {
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (stops[i] < plan_.lines[i].stop) stops[i] = 0;
    }
  }

  /// What the proof has found of a line.
  struct Limit {
    StopReason reason = StopReason::no_room;  ///< of its room, or of its stop
    int stop = most_layers;
    int lowered = 0;  ///< so many times
  };

  const SurfaceMesh& surface_;
  std::vector<Vec3> normals_;             // of the wall triangles, inwards
  std::vector<Vec3> places_;              // of the feet
  std::vector<std::vector<Vec3>> leans_;  // in each way so far, of each line LayerLine::later
  std::span<const LayerRequest> requests_;
  std::span<const std::int32_t> single_;
  Wall wall_;
  std::vector<std::ptrdiff_t> request_of_foot_;  // of each vertex of the surface
  std::vector<int> steps_;                       // of each line: LayerRequest::step
  WallGraph graph_;
  WallPlanes planes_;
  std::vector<Sliver> slivers_;
  std::vector<Sliver> followed_;  // those whose middle goes between the ends
  std::vector<double> rooms_;     // of each line
  std::vector<Limit> limits_;     // likewise
  // Of each line LayerLine::along before first heights were levelled, whether it is to stay, and
  // whether it goes on by LayerLine::later right above the first layer.
  std::vector<Vec3> unlevelled_;
  std::vector<bool> is_held_;
  std::vector<bool> turns_at_first_;
  LayerPlan begun_;  // without layers
  LayerPlan plan_;
};

/// Makes the plan anew without the fans near what holds others back, where that leaves more layers;
/// adds the feet to `single`.
void leave_out_fans(const SurfaceMesh& surface, std::span<const LayerRequest> requests, int edges,
                    std::vector<std::int32_t>& single, LayerPlan& plan) {
  const std::vector<CostlyFans> costly = costly_fans(plan, surface, edges);
  if (costly.empty()) return;
  const auto with = [&single](const std::vector<CostlyFans>& places) {
    std::set<std::int32_t> feet(single.begin(), single.end());
    for (const CostlyFans& place : places) feet.insert(place.fans.begin(), place.fans.end());
    return std::vector<std::int32_t>(feet.begin(), feet.end());
  };
  std::vector<std::int32_t> feet = with(costly);
  LayerPlan other = Planning(surface, requests, feet).plan();
  // Each place for itself: what serves one may cost another layers.
  std::vector<CostlyFans> served;
  for (const CostlyFans& place : costly) {
    if (missing_layers_at(other, place.held) < missing_layers_at(plan, place.held)) {
      served.push_back(place);
    }
  }
  if (served.empty()) return;
  if (served.size() < costly.size()) {
    feet = with(served);
    other = Planning(surface, requests, feet).plan();
  }
  if (missing_layers(other) >= missing_layers(plan)) return;
  plan = std::move(other);
  single = std::move(feet);
}

Vec3 point_at(const LayerLine& line, double height) {
  if (height == 0) return line.at;  // to the bit, also where it is a negative zero
  if (height <= line.bends_from) return line.at + height * line.along;
  if (line.bends_to <= line.bends_from) {
    return line.at + line.bends_from * line.along + (height - line.bends_from) * line.later;
  }
  const double way = line.bends_to - line.bends_from;
  const double w = height < line.bends_to ? (height - line.bends_from) / way : 1;
  return line.at + height * (line.along + w * w * (3 - 2 * w) * (line.later - line.along));
}

}  // namespace

const char* name_of(StopReason reason) {
  constexpr std::array<const char*, all_stop_reasons.size()> names = {
      "complete", "border", "ridge", "no room", "fold", "crossing"};
  return names[static_cast<std::size_t>(reason)];
}

Vec3 point_of(const LayerLine& line, int level) {
  TF_CHECK(level >= 0 && level <= line.stop);
  return point_at(line, levels_of(line.law, level).back());
}

std::vector<Vec3> points_of(const LayerLine& line) {
  std::vector<Vec3> points;
  for (const double height : levels_of(line.law, line.stop)) {
    points.push_back(point_at(line, height));
  }
  return points;
}

std::array<std::int32_t, 3> lines_of(const LayerPlan& plan, const SurfaceMesh& surface,
                                     std::int32_t triangle) {
  std::array<std::int32_t, 3> lines{};
  for (std::size_t k = 0; k < 3; ++k) {
    lines[k] = plan.vertex2line[at(surface.triangles[at(triangle)][k])];
    TF_CHECK(lines[k] >= 0);
  }
  auto corner =
      std::lower_bound(plan.fan_corners.begin(), plan.fan_corners.end(), FanCorner{triangle, 0, 0});
  for (; corner != plan.fan_corners.end() && corner->triangle == triangle; ++corner) {
    lines[at(corner->corner)] = corner->line;
  }
  return lines;
}

WallGraph graph_of(const LayerPlan& plan, const SurfaceMesh& surface) {
  WallGraph graph = wall_graph(surface, plan.wall);
  if (plan.fans.empty()) return graph;
  std::vector<std::int32_t> feet;
  for (const LayerLine& line : plan.lines) feet.push_back(line.foot);
  return with_fans(graph, std::move(feet), plan.fan_corners, plan.fans);
}

LayerPlan plan_layers(const SurfaceMesh& surface, std::span<const LayerRequest> requests) {
  TF_CHECK(surface.sides.empty() || region_count(surface) == 1);
  LayerPlan plan = Planning(surface, requests, {}).plan();
  std::vector<std::int32_t> single;
  for (const int edges : edges_to_fans) leave_out_fans(surface, requests, edges, single, plan);
  return plan;
}

}  // namespace tetfarm
