#include "mesh/layers/line_fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/disjoint_sets.h"
#include "mesh/geometry/predicates.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/layer_proof.h"
#include "mesh/layers/marching_direction.h"

namespace tetfarm {
namespace {

/// Two directions that are as good as opposite have no middle.
constexpr double cos_of_opposite = -0.9995;

/// A single line that is so many times as long as the layers are high still serves a foot at which
/// a sharp edge ends.
constexpr double longest_single = 2;

/// A line leans towards the fan that it continues while it sees its faces at this cosine.
constexpr double seen_when_leaning = 0.5;

/// Where faces turn by more they do not count as one that goes straight on.
constexpr double cos_of_straight = 0.9;

/// The most pieces between two groups.
constexpr std::size_t most_pieces = 8;

/// An edge of a face at a foot: to the next foot, and the face to the right of it, seen from the
/// layers from the foot on.
struct Spoke {
  std::int32_t to = 0;    // vertex
  std::int32_t face = 0;  // of the graph
  int corner = 0;         // of the foot in the face
  bool is_sharp = false;
};

/// A foot with several lines. Its faces are in groups, of which each has one. Where they are a
/// ring, group j, with line j, lies from open spoke j to the next one. At a plane they are a chain
/// from border to border, and group j ends at open spoke j.
struct Fan {
  std::int32_t foot = 0;
  std::vector<Spoke> spokes;      // turning clockwise, seen from the layers; an open one first
  std::vector<std::size_t> open;  // numbers of the spokes between groups
  std::vector<Vec3> lines;        // LayerLine::along: of the groups, then of those between them
  /// Of each open spoke the lines there, from that of the group before it to that of the group
  /// after.
  std::vector<std::vector<std::size_t>> arcs;
  bool is_chain = false;
  bool is_corner = false;  // the arcs go round cells of their own
  std::int32_t first_line = 0;

  std::size_t groups() const { return open.size() + (is_chain ? 1 : 0); }
  std::size_t group_before(std::size_t arc) const {
    return is_chain ? arc : (arc + groups() - 1) % groups();
  }
  std::size_t group_after(std::size_t arc) const { return is_chain ? arc + 1 : arc; }
  /// The number of its first face; of the group after the last, that of all faces.
  std::size_t start_of(std::size_t group) const {
    if (group == groups()) return spokes.size();
    if (!is_chain) return open[group];
    return group == 0 ? 0 : open[group - 1];
  }
  std::vector<Vec3> normals_of(std::size_t group, std::span<const Vec3> normals) const {
    std::vector<Vec3> found;
    for (std::size_t i = start_of(group); i < start_of(group + 1); ++i) {
      found.push_back(normals[at(spokes[i].face)]);
    }
    return found;
  }
  std::int32_t end_of(std::size_t arc) const { return spokes[open[arc]].to; }
  std::optional<std::size_t> arc_at(std::int32_t vertex) const {
    for (std::size_t j = 0; j < open.size(); ++j) {
      if (end_of(j) == vertex) return j;
    }
    return std::nullopt;
  }
};

/// In the middle of two, as long as their mean.
Vec3 between(const Vec3& a, const Vec3& b) {
  return normalized(normalized(a) + normalized(b)) * (0.5 * (norm(a) + norm(b)));
}

/// From one direction to another in so many steps, a power of two.
std::vector<Vec3> arc_of(const Vec3& from, const Vec3& to, std::size_t pieces) {
  std::vector<Vec3> arc = {from, to};
  while (arc.size() <= pieces) {
    std::vector<Vec3> finer;
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      finer.push_back(arc[i]);
      finer.push_back(between(arc[i], arc[i + 1]));
    }
    finer.push_back(to);
    arc = std::move(finer);
  }
  return arc;
}

/// The fewest pieces of which none is wider than the angle of the cosine.
std::size_t pieces_for(Vec3 from, Vec3 to, double cosine) {
  std::size_t pieces = 1;
  while (pieces < most_pieces && dot(normalized(from), normalized(to)) < cosine) {
    to = between(from, to);
    pieces *= 2;
  }
  return pieces;
}

class FanChoice {
 public:
  FanChoice(const SurfaceMesh& surface, const WallGraph& graph, const WallPlanes& planes,
            std::span<const Vec3> normals, std::span<const Vec3> along,
            std::span<const FanWish> wishes)
      : surface_(surface),
        graph_(graph),
        planes_(planes),
        normals_(normals),
        along_(along),
        wishes_(wishes),
        fan_of_line_(graph.feet.size(), -1) {}

  LineFans choose() {
    find_fans();
    while (true) {
      number_lines();
      find_pieces();
      if (!drop_faulty()) break;
    }
    return std::move(made_);
  }

 private:
  std::int32_t line_at(std::int32_t vertex) const { return graph_.vertex2line[at(vertex)]; }

  /// Those of a foot, turning clockwise; none where its faces are not one ring, or at the border of
  /// the wall one chain.
  std::vector<Spoke> spokes_of(std::int32_t line) const {
    const std::int32_t foot = graph_.feet[at(line)];
    std::vector<Spoke> open;
    for (const std::int32_t face : graph_.faces.of(line)) {
      const Triangle& nodes = surface_.triangles[at(graph_.wall[at(face)])];
      const auto corner = std::find(nodes.begin(), nodes.end(), foot) - nodes.begin();
      open.push_back({nodes[at((corner + 1) % 3)], face, static_cast<int>(corner), false});
    }
    const bool is_chain = graph_.at_border[at(line)];
    std::vector<Spoke> in_order = {is_chain ? first_of_chain(open) : open.front()};
    while (in_order.size() < open.size()) {
      const std::int32_t next = third_vertex(in_order.back());
      const auto found = std::find_if(open.begin(), open.end(),
                                      [next](const Spoke& spoke) { return spoke.to == next; });
      if (found == open.end() || found->to == in_order.front().to) return {};
      in_order.push_back(*found);
    }
    if ((third_vertex(in_order.back()) == in_order.front().to) == is_chain) return {};
    return in_order;
  }

  /// The spoke that no other's face leads to.
  Spoke first_of_chain(const std::vector<Spoke>& spokes) const {
    const auto first = std::find_if(spokes.begin(), spokes.end(), [&](const Spoke& spoke) {
      return std::none_of(spokes.begin(), spokes.end(),
                          [&](const Spoke& other) { return third_vertex(other) == spoke.to; });
    });
    return first == spokes.end() ? spokes.front() : *first;
  }

  /// The third vertex of the spoke's face, where the next spoke goes.
  std::int32_t third_vertex(const Spoke& spoke) const {
    return surface_.triangles[at(graph_.wall[at(spoke.face)])][at((spoke.corner + 2) % 3)];
  }

  /// Whether the faces on both sides of a spoke are turned away from each other that much.
  bool is_sharp(const Spoke& before, const Spoke& spoke) const {
    const Vec3& left = normals_[at(before.face)];
    const Vec3& right = normals_[at(spoke.face)];
    const double cosine = std::min(wishes_[at(line_at(spoke.to))].cosine,
                                   wishes_[at(line_at(foot_of(spoke)))].cosine);
    if (dot(left, right) >= cosine) return false;
    const auto place = [this](std::int32_t vertex) { return surface_.vertices[at(vertex)]; };
    return orient3d(place(foot_of(spoke)), place(spoke.to), place(before.to),
                    place(third_vertex(spoke))) < 0;
  }

  std::int32_t foot_of(const Spoke& spoke) const {
    return surface_.triangles[at(graph_.wall[at(spoke.face)])][at(spoke.corner)];
  }

  void find_fans() {
    std::vector<Fan> ends;
    for (std::size_t i = 0; i < graph_.feet.size(); ++i) {
      const auto& [plane, second_plane] = planes_.of_line[i];
      const bool is_beside_more = graph_.at_border[i] && (plane < 0 || second_plane >= 0);
      if (is_beside_more || wishes_[i].cosine <= -1) continue;
      std::optional<Fan> fan = fan_at(static_cast<std::int32_t>(i));
      if (!fan || fan->open.empty()) continue;
      if (fan->groups() == 1) {
        ends.push_back(std::move(*fan));
      } else if (find_groups(*fan)) {
        fan_of_line_[i] = static_cast<std::int32_t>(fans_.size());
        fans_.push_back(std::move(*fan));
      }
    }
    const std::vector<std::size_t> pieces = shared_pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) add_arcs(fans_[i], pieces[i]);
    for (Fan& end : ends) continue_fan(std::move(end));
  }

  /// With its sharp spokes open; nothing where its faces are neither ring nor chain.
  std::optional<Fan> fan_at(std::int32_t line) const {
    Fan fan;
    fan.foot = graph_.feet[at(line)];
    fan.spokes = spokes_of(line);
    if (fan.spokes.empty()) return std::nullopt;
    fan.is_chain = graph_.at_border[at(line)];
    for (std::size_t i = fan.is_chain ? 1 : 0; i < fan.spokes.size(); ++i) {
      const Spoke& before = fan.spokes[(i + fan.spokes.size() - 1) % fan.spokes.size()];
      fan.spokes[i].is_sharp = is_sharp(before, fan.spokes[i]);
    }
    const auto first = std::find_if(fan.spokes.begin(), fan.spokes.end(),
                                    [](const Spoke& spoke) { return spoke.is_sharp; });
    if (!fan.is_chain && first != fan.spokes.end()) {
      std::rotate(fan.spokes.begin(), first, fan.spokes.end());
    }
    for (std::size_t i = 0; i < fan.spokes.size(); ++i) {
      if (fan.spokes[i].is_sharp) fan.open.push_back(i);
    }
    return fan;
  }

  /// Whether each group has a direction, and no two neighbouring ones are opposite.
  bool find_groups(Fan& fan) const {
    const std::size_t line = at(line_at(fan.foot));
    for (std::size_t j = 0; j < fan.groups(); ++j) {
      const std::vector<Vec3> normals = fan.normals_of(j, normals_);
      const Vec3 best =
          planes_.held(line, marching_direction(with_images(normals, planes_, line)).direction);
      const double seen = visibility(best, normals);
      if (seen < least_visibility) return false;
      fan.lines.push_back(best / seen);
    }
    for (std::size_t j = 0; j < fan.open.size(); ++j) {
      const Vec3& before = fan.lines[fan.group_before(j)];
      const Vec3& after = fan.lines[fan.group_after(j)];
      if (dot(normalized(after), normalized(before)) < cos_of_opposite) return false;
    }
    return true;
  }

  /// Fans that sharp edges join have as many pieces in each arc as the widest needs. Returns how
  /// many that are for each.
  std::vector<std::size_t> shared_pieces() const {
    DisjointSets joined(fans_.size());
    std::vector<std::size_t> pieces(fans_.size(), 1);
    for (std::size_t i = 0; i < fans_.size(); ++i) {
      const Fan& fan = fans_[i];
      for (std::size_t j = 0; j < fan.open.size(); ++j) {
        const double cosine = wishes_[at(line_at(fan.foot))].cosine;
        pieces[i] = std::max(pieces[i], pieces_for(fan.lines[fan.group_before(j)],
                                                   fan.lines[fan.group_after(j)], cosine));
        const std::int32_t next = fan_of_line_[at(line_at(fan.end_of(j)))];
        if (next >= 0) joined.join(at(next), i);
      }
    }
    std::vector<std::size_t> most(fans_.size(), 1);
    for (std::size_t i = 0; i < fans_.size(); ++i) {
      std::size_t& widest = most[joined.root(i)];
      widest = std::max(widest, pieces[i]);
    }
    for (std::size_t i = 0; i < fans_.size(); ++i) pieces[i] = most[joined.root(i)];
    return pieces;
  }

  /// Between two groups the arc is the same from both sides.
  void add_arcs(Fan& fan, std::size_t pieces) const {
    fan.is_corner = !fan.is_chain && fan.groups() > 2;
    for (std::size_t j = 0; j < fan.open.size(); ++j) {
      if (j == 1 && !fan.is_chain && !fan.is_corner) {
        fan.arcs.emplace_back(fan.arcs[0].rbegin(), fan.arcs[0].rend());
        continue;
      }
      const std::vector<Vec3> ways =
          arc_of(fan.lines[fan.group_before(j)], fan.lines[fan.group_after(j)], pieces);
      std::vector<std::size_t> arc = {fan.group_before(j)};
      for (std::size_t i = 1; i + 1 < ways.size(); ++i) {
        arc.push_back(fan.lines.size());
        const Vec3 held = planes_.held(at(line_at(fan.foot)), normalized(ways[i]));
        fan.lines.push_back(fan.is_chain ? norm(ways[i]) * held : ways[i]);
      }
      arc.push_back(fan.group_after(j));
      fan.arcs.push_back(std::move(arc));
    }
  }

  /// Where one sharp edge ends at a foot that a single line serves badly, as a trailing edge at a
  /// fuselage, its faces are divided to continue the fan at the other end of that edge.
  void continue_fan(Fan fan) {
    const std::size_t line = at(line_at(fan.foot));
    const bool is_served = along_[line] != Vec3{} && norm(along_[line]) <= longest_single;
    const std::int32_t next = fan_of_line_[at(line_at(fan.end_of(0)))];
    if (is_served || next < 0) return;
    const Fan& other = fans_[at(next)];
    const std::optional<std::size_t> back = other.arc_at(fan.foot);
    if (!back) return;
    std::vector<Vec3> ways;
    for (const std::size_t i : other.arcs[*back]) ways.push_back(normalized(other.lines[i]));
    fan.open = starts_of_groups(fan, ways);
    if (fan.open.empty() || meets_fans(fan) || !find_groups(fan)) return;
    fan.arcs.resize(fan.groups());
    for (std::size_t j = 0; j < fan.groups(); ++j) {
      lean_towards(ways[j], fan.normals_of(j, normals_), fan.lines[j]);
      fan.arcs[0].insert(fan.arcs[0].begin(), j);
      if (j > 0) fan.arcs[j] = {j - 1, j};
    }
    fan_of_line_[line] = static_cast<std::int32_t>(fans_.size());
    fans_.push_back(std::move(fan));
  }

  /// Whether a fan begins where an edge between the groups ends, or has one that ends here.
  bool meets_fans(const Fan& fan) const {
    for (std::size_t j = 1; j < fan.groups(); ++j) {
      if (fan_of_line_[at(line_at(fan.end_of(j)))] >= 0) return true;
    }
    return std::any_of(fan.spokes.begin() + 1, fan.spokes.end(), [&](const Spoke& spoke) {
      const std::int32_t there = fan_of_line_[at(line_at(spoke.to))];
      return there >= 0 && fans_[at(there)].arc_at(fan.foot).has_value();
    });
  }

  /// Turns the line as far towards the way as its faces are seen well.
  static void lean_towards(const Vec3& way, const std::vector<Vec3>& normals, Vec3& line) {
    const Vec3 best = normalized(line);
    for (int eighths = 8; eighths > 0; --eighths) {
      const Vec3 between_both = normalized(eighths / 8.0 * way + (8 - eighths) / 8.0 * best);
      const double seen = visibility(between_both, normals);
      if (seen < seen_when_leaning) continue;
      line = between_both / seen;
      return;
    }
  }

  /// Divides the faces, from the first spoke on, into as many groups as there are ways, so that the
  /// faces lie in the directions of their groups' ways as well as can be; not where they turn, as a
  /// fan cannot open in a concave edge. Empty: they are too few.
  std::vector<std::size_t> starts_of_groups(const Fan& fan, const std::vector<Vec3>& ways) const {
    const std::size_t faces = fan.spokes.size();
    if (faces < ways.size()) return {};
    // best[g][f]: of the first f faces in the first g + 1 groups, and where the last one starts.
    std::vector<std::vector<double>> best(ways.size(), std::vector<double>(faces + 1, -HUGE_VAL));
    std::vector<std::vector<std::size_t>> start(ways.size(),
                                                std::vector<std::size_t>(faces + 1, 0));
    for (std::size_t g = 0; g < ways.size(); ++g) {
      for (std::size_t f = g + 1; f <= faces; ++f) {
        const double fit = dot(way_of_face(fan.spokes[f - 1]), ways[g]);
        double begun = f == 1 ? 0 : -HUGE_VAL;
        if (g > 0 && goes_straight_on(fan, f - 1)) begun = best[g - 1][f - 1];
        const double goes_on = best[g][f - 1];
        best[g][f] = std::max(begun, goes_on) + fit;
        start[g][f] = begun > goes_on ? f - 1 : start[g][f - 1];
      }
    }
    if (best.back()[faces] == -HUGE_VAL) return {};
    std::vector<std::size_t> starts(ways.size());
    std::size_t end = faces;
    for (std::size_t g = ways.size(); g-- > 0;) end = starts[g] = start[g][end];
    return starts;
  }

  /// Whether the faces on both sides of the spoke are nearly in one plane.
  bool goes_straight_on(const Fan& fan, std::size_t spoke) const {
    return dot(normals_[at(fan.spokes[spoke - 1].face)], normals_[at(fan.spokes[spoke].face)]) >=
           cos_of_straight;
  }

  /// From the foot to the middle of the face.
  Vec3 way_of_face(const Spoke& spoke) const {
    const Vec3 foot = surface_.vertices[at(foot_of(spoke))];
    return normalized(normalized(surface_.vertices[at(spoke.to)] - foot) +
                      normalized(surface_.vertices[at(third_vertex(spoke))] - foot));
  }

  void number_lines() {
    made_ = {};
    first_line_.assign(graph_.feet.size(), 0);
    for (std::size_t i = 0; i < graph_.feet.size(); ++i) {
      first_line_[i] = static_cast<std::int32_t>(made_.feet.size());
      const std::int32_t number = fan_of_line_[i];
      if (number < 0) {
        made_.feet.push_back(graph_.feet[i]);
        made_.along.emplace_back();
        continue;
      }
      Fan& fan = fans_[at(number)];
      fan.first_line = first_line_[i];
      made_.feet.insert(made_.feet.end(), fan.lines.size(), fan.foot);
      made_.along.insert(made_.along.end(), fan.lines.begin(), fan.lines.end());
      add_corners(fan);
    }
    std::sort(made_.corners.begin(), made_.corners.end());
    made_.early.assign(made_.feet.size(), false);
  }

  void add_corners(const Fan& fan) {
    std::size_t group = 0;
    for (std::size_t i = 0; i < fan.spokes.size(); ++i) {
      if (i == fan.start_of(group + 1)) ++group;
      if (group == 0) continue;
      const Spoke& spoke = fan.spokes[i];
      made_.corners.push_back({graph_.wall[at(spoke.face)], spoke.corner,
                               fan.first_line + static_cast<std::int32_t>(group)});
    }
  }

  void find_pieces() {
    for (const std::int32_t number : fan_of_line_) {
      if (number < 0) continue;
      const Fan& fan = fans_[at(number)];
      for (std::size_t arc = 0; arc < fan.open.size(); ++arc) add_edge(fan, arc);
      if (fan.is_corner) add_corner(fan);
    }
  }

  static std::int32_t numbered(const Fan& fan, std::size_t line) {
    return fan.first_line + static_cast<std::int32_t>(line);
  }

  /// The pieces along an edge; where both ends have fans, the lower vertex adds them.
  void add_edge(const Fan& fan, std::size_t number) {
    const std::int32_t vertex = fan.end_of(number);
    const std::int32_t beside = graph_.wall[at(fan.spokes[fan.open[number]].face)];
    const std::int32_t other = fan_of_line_[at(line_at(vertex))];
    const std::optional<std::size_t> back =
        other >= 0 ? fans_[at(other)].arc_at(fan.foot) : std::nullopt;
    if (back && vertex < fan.foot) return;
    const std::vector<std::size_t>& arc = fan.arcs[number];
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      FanPiece piece{{numbered(fan, arc[i]), numbered(fan, arc[i + 1])}, {}, beside};
      if (back) {
        const Fan& end = fans_[at(other)];
        const std::vector<std::size_t>& its_arc = end.arcs[*back];
        TF_CHECK(its_arc.size() == arc.size());
        piece.to = {numbered(end, its_arc[arc.size() - 1 - i]),
                    numbered(end, its_arc[arc.size() - 2 - i])};
      } else {
        const std::int32_t single = first_line_[at(line_at(vertex))];
        piece.to = {single, single};
        set_early(fan);
      }
      made_.pieces.push_back(piece);
    }
  }

  void set_early(const Fan& fan) {
    for (std::size_t i = 0; i < fan.lines.size(); ++i) made_.early[at(fan.first_line) + i] = true;
  }

  /// The pieces within a corner: its arcs are a ring, clockwise seen from the layers, from which
  /// triangles are cut one by one.
  void add_corner(const Fan& fan) {
    std::vector<std::int32_t> ring;
    for (const std::vector<std::size_t>& arc : fan.arcs) {
      for (std::size_t i = 0; i + 1 < arc.size(); ++i) ring.push_back(numbered(fan, arc[i]));
    }
    const std::int32_t beside = graph_.wall[at(fan.spokes.front().face)];
    while (ring.size() >= 3) {
      const std::size_t n = ring.size();
      const std::size_t ear = best_ear(ring);
      made_.pieces.push_back(
          {{ring[(ear + n - 1) % n], ring[(ear + 1) % n]}, {ring[ear], ring[ear]}, beside});
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
  }

  /// Of the triangles that turn the right way that beyond which the other directions lie least:
  /// with those of a convex corner, a face of their hull. Where none turns the right way, the
  /// first, whose cell tells that this is no fan.
  std::size_t best_ear(const std::vector<std::int32_t>& ring) const {
    std::vector<Vec3> ways;
    for (const std::int32_t line : ring) ways.push_back(normalized(made_.along[at(line)]));
    const std::size_t n = ring.size();
    std::optional<std::size_t> best;
    double most_below = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& p = ways[(i + n - 1) % n];
      const Vec3& q = ways[i];
      const Vec3& r = ways[(i + 1) % n];
      if (!(orient3d(p, q, r, Vec3{}) > 0)) continue;
      const Vec3 below = normalized(cross(q - p, r - p));
      double least = dot(below, Vec3{} - p);
      for (std::size_t k = 2; k + 1 < n; ++k) {
        least = std::min(least, dot(below, ways[(i + k) % n] - p));
      }
      if (best && least <= most_below) continue;
      best = i;
      most_below = least;
    }
    return best.value_or(0);
  }

  /// Takes fans of pieces that are not sound away: of two ends that with more such pieces, as the
  /// other may be sound without it. Returns whether there were any.
  bool drop_faulty() {
    std::vector<std::array<std::int32_t, 2>> faulty;
    std::map<std::int32_t, int> faults;  // of feet
    for (const FanPiece& piece : made_.pieces) {
      if (is_sound(piece)) continue;
      const std::int32_t from = made_.feet[at(piece.from[0])];
      const std::int32_t to = made_.feet[at(piece.to[0])];
      faulty.push_back({from, fan_of_line_[at(line_at(to))] >= 0 ? to : from});
      ++faults[from];
      ++faults[to];
    }
    for (const auto& [from, to] : faulty) {
      const std::int32_t worse = faults[from] > faults[to] ? from : to;
      fan_of_line_[at(line_at(worse))] = -1;
    }
    return !faulty.empty();
  }

  LayerLine line_for(std::int32_t number, const FanWish& wish) const {
    LayerLine line;
    line.foot = made_.feet[at(number)];
    line.at = surface_.vertices[at(line.foot)];
    const std::int32_t single = line_at(line.foot);
    line.along = line.later =
        fan_of_line_[at(single)] >= 0 ? made_.along[at(number)] : along_[at(single)];
    line.early = made_.early[at(number)];
    line.law = wish.law;
    line.stop = line.along == Vec3{} ? 0 : wish.count;
    return line;
  }

  /// Whether all its cells are positive, where no line bends or has fewer layers.
  bool is_sound(const FanPiece& piece) const {
    const FanWish& wish = wishes_[at(line_at(made_.feet[at(piece.from[0])]))];
    const std::array<LayerLine, 4> made = {
        line_for(piece.from[0], wish), line_for(piece.from[1], wish), line_for(piece.to[0], wish),
        line_for(piece.to[1], wish)};
    PieceLines lines = {&made[0], &made[1], &made[2], &made[3]};
    if (piece.to[0] == piece.to[1]) lines[3] = lines[2];
    if (!has_positive_base(lines)) return false;
    const auto triangles = open_triangles(lines);
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& triangle) {
      const std::array<const LayerLine*, 3> column = {lines[triangle[0]], lines[triangle[1]],
                                                      lines[triangle[2]]};
      const bool all_grow = std::all_of(column.begin(), column.end(),
                                        [](const LayerLine* line) { return line->stop > 0; });
      return !all_grow || 2 * positive_layers(column, 2) >= wish.count;
    });
  }

  const SurfaceMesh& surface_;
  const WallGraph& graph_;
  const WallPlanes& planes_;
  std::span<const Vec3> normals_;
  std::span<const Vec3> along_;
  std::span<const FanWish> wishes_;
  std::vector<std::int32_t> fan_of_line_;  // of each line of the graph; -1: none
  std::vector<Fan> fans_;
  std::vector<std::int32_t> first_line_;  // of each line of the graph, among those made
  LineFans made_;
};

}  // namespace

LineFans line_fans(const SurfaceMesh& surface, const WallGraph& graph, const WallPlanes& planes,
                   std::span<const Vec3> normals, std::span<const Vec3> along,
                   std::span<const FanWish> wishes) {
  TF_CHECK(normals.size() == graph.wall.size() && along.size() == graph.feet.size() &&
           wishes.size() == graph.feet.size());
  return FanChoice(surface, graph, planes, normals, along, wishes).choose();
}

}  // namespace tetfarm
