#include "mesh/cosmetics/small_polyhedron_reconnection.h"

#include <algorithm>
#include <bit>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/sorted_face.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

namespace {

/// Nodes of the cavity by their place in its list.
constexpr std::size_t node_limit = 12;
constexpr std::size_t triples = 220;  // of 12
constexpr std::size_t quadruples = 495;
constexpr std::size_t most_open = 64;
constexpr double volume_slack = 1e-9;

using Node = std::uint8_t;
/// A tet is wanted at this face: (face, apex) is positive.
using Face = std::array<Node, 3>;

std::size_t number_of_triple(std::size_t a, std::size_t b, std::size_t c) {
  return c * (c - 1) * (c - 2) / 6 + b * (b - 1) / 2 + a;
}

/// A face by its nodes in rising order, and whether that takes an odd permutation.
struct NumberedFace {
  std::size_t number;
  bool odd;
};
NumberedFace numbered(Face face) {
  const bool odd = sort_face(face);
  return {number_of_triple(face[0], face[1], face[2]), odd};
}

/// The tets and nodes of a cavity.
struct Cavity {
  std::vector<std::int32_t> tets;
  std::vector<std::int32_t> nodes;

  bool has(std::int32_t node) const {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  }
};

void take_tet(WorkMesh& work, Cavity& cavity, std::int32_t t) {
  cavity.tets.push_back(t);
  work.marks.add(t);
  for (const std::int32_t v : work.tet(t)) {
    if (!cavity.has(v)) cavity.nodes.push_back(v);
  }
}

double measure_of(const WorkMesh& work, std::int32_t t, const ReconnectionOptions& options) {
  if (!options.measure) return work.quality_of(t);
  const auto& [a, b, c, d] = work.tet(t);
  return options.measure(work.point(a), work.point(b), work.point(c), work.point(d));
}

/// Grows round t: first by tets that bring no new node, then by the worst ones; tets worse than t
/// stay out, as they would be what the new tets are judged against.
Cavity grown_cavity(WorkMesh& work, std::int32_t t, const ReconnectionOptions& options) {
  Cavity cavity;
  const double least = measure_of(work, t, options);
  work.marks.clear();
  take_tet(work, cavity, t);
  while (cavity.tets.size() < options.most_tets) {
    std::int32_t best = -1;
    double key_of_best = HUGE_VAL;
    for (const std::int32_t inside : cavity.tets) {
      for (int face = 0; face < 4; ++face) {
        const FaceHandle across = work.across(inside, face);
        if (across == no_face || work.marks.has(tet_of(across))) continue;
        const double across_measure = measure_of(work, tet_of(across), options);
        if (across_measure < least) continue;
        const bool is_new = !cavity.has(work.tet(tet_of(across))[at(face_of(across))]);
        if (is_new && cavity.nodes.size() == options.most_nodes) continue;
        const double key = across_measure + (is_new ? 2 : 0);
        if (key < key_of_best || (key == key_of_best && tet_of(across) < best)) {
          key_of_best = key;
          best = tet_of(across);
        }
      }
    }
    if (best < 0) break;
    take_tet(work, cavity, best);
  }
  return cavity;
}

/// What is still to be filled.
struct Front {
  enum State : std::int8_t { unused, open_even, open_odd, closed };

  std::array<Face, most_open> open;
  std::size_t count = 0;
  std::array<State, triples> state{};

  static State open_state(bool odd) { return odd ? open_odd : open_even; }
  bool add_open(const Face& face) {
    const NumberedFace sorted = numbered(face);
    if (count == most_open || state[sorted.number] != unused) return false;
    state[sorted.number] = open_state(sorted.odd);
    open[count++] = face;
    return true;
  }
  void close(std::size_t number) {
    state[number] = closed;
    for (std::size_t i = 0; i < count; ++i) {
      if (numbered(open[i]).number != number) continue;
      open[i] = open[--count];
      return;
    }
  }
  /// Puts a tet on an open face; false when one of its other faces has its two tets already.
  bool place(const Face& base, Node apex) {
    const auto [x, y, z] = base;
    close(numbered(base).number);
    for (const Face& beyond : {Face{x, y, apex}, Face{y, z, apex}, Face{z, x, apex}}) {
      const NumberedFace sorted = numbered(beyond);
      const State now = state[sorted.number];
      if (now == unused) {
        if (!add_open(beyond)) return false;
      } else if (now == open_state(!sorted.odd)) {
        close(sorted.number);
      } else {
        return false;
      }
    }
    return true;
  }
};

class Search {
 public:
  Search(const WorkMesh& work, const Cavity& cavity, const ReconnectionOptions& options,
         double least)
      : options_(options), node_count_(cavity.nodes.size()), best_worst_(least) {
    for (std::size_t i = 0; i < node_count_; ++i) points_[i] = work.point(cavity.nodes[i]);
    shapes_.fill({0, 0, false});
    apexes_.fill({0, false});
  }

  void run(const Front& front, double volume6) {
    volume_left_slack_ = volume_slack * volume6;
    fill(front, 1, volume6);
  }

  const std::vector<std::array<Node, 4>>& best() const { return best_; }
  double best_worst() const { return best_worst_; }

 private:
  struct Shape {
    double quality;
    double volume6;
    bool known;
  };
  struct Apexes {
    std::uint16_t nodes;
    bool known;
  };

  bool is_over() const { return steps_ >= options_.most_steps || best_worst_ >= options_.enough; }

  /// The measure; negative for an inverted tet.
  double judge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) const {
    if (!options_.measure) return quality(a, b, c, p);
    return tet_volume(a, b, c, p) < 0 ? -options_.measure(b, a, c, p)
                                      : options_.measure(a, b, c, p);
  }

  /// The tet (face, apex): negative figures when it is inverted.
  Shape shape_of(const Face& face, Node apex) {
    std::array<Node, 4> n = {face[0], face[1], face[2], apex};
    bool odd = false;
    for (std::size_t end = 3; end > 0; --end) {
      for (std::size_t i = 0; i < end; ++i) {
        if (n[i] < n[i + 1]) continue;
        std::swap(n[i], n[i + 1]);
        odd = !odd;
      }
    }
    const std::size_t d = n[3];
    const std::size_t number =
        d * (d - 1) * (d - 2) * (d - 3) / 24 + number_of_triple(n[0], n[1], n[2]);
    Shape& shape = shapes_[number];
    if (!shape.known) {
      const Vec3& a = points_[n[0]];
      const Vec3& b = points_[n[1]];
      const Vec3& c = points_[n[2]];
      const Vec3& p = points_[n[3]];
      shape = {judge(a, b, c, p), 6 * tet_volume(a, b, c, p), true};
    }
    return odd ? Shape{-shape.quality, -shape.volume6, true} : shape;
  }

  /// The nodes that make a tet with the face better than what is to be beaten (when first asked).
  std::uint16_t apexes_of(const Face& face) {
    const NumberedFace sorted = numbered(face);
    Apexes& apexes = apexes_[2 * sorted.number + (sorted.odd ? 1 : 0)];
    if (apexes.known) return apexes.nodes;
    apexes.known = true;
    for (Node v = 0; v < node_count_; ++v) {
      if (v == face[0] || v == face[1] || v == face[2]) continue;
      if (shape_of(face, v).quality > best_worst_) {
        apexes.nodes = static_cast<std::uint16_t>(apexes.nodes | 1U << v);
      }
    }
    return apexes.nodes;
  }

  /// The face with the fewest apexes: what must be is done first.
  std::size_t hardest(const Front& front) {
    std::size_t hardest = 0;
    int fewest = 100;
    for (std::size_t i = 0; i < front.count; ++i) {
      const int apexes = std::popcount(apexes_of(front.open[i]));
      if (apexes >= fewest) continue;
      fewest = apexes;
      hardest = i;
    }
    return hardest;
  }

  void fill(const Front& front, double worst, double volume_left) {
    if (front.count == 0) {
      best_ = placed_;
      best_worst_ = worst;
      return;
    }
    const Face face = front.open[hardest(front)];
    for (unsigned left = apexes_of(face); left != 0; left &= left - 1) {
      const auto apex = static_cast<Node>(std::countr_zero(left));
      const Shape shape = shape_of(face, apex);
      if (shape.quality <= best_worst_ || shape.volume6 > volume_left + volume_left_slack_) {
        continue;
      }
      if (is_over()) return;
      ++steps_;
      Front next = front;
      if (!next.place(face, apex)) continue;
      placed_.push_back({face[0], face[1], face[2], apex});
      fill(next, std::min(worst, shape.quality), volume_left - shape.volume6);
      placed_.pop_back();
    }
  }

  const ReconnectionOptions& options_;
  std::size_t node_count_;
  std::array<Vec3, node_limit> points_;
  std::array<Shape, quadruples> shapes_;
  std::array<Apexes, 2 * triples> apexes_;
  std::vector<std::array<Node, 4>> placed_;
  std::vector<std::array<Node, 4>> best_;
  double best_worst_;
  double volume_left_slack_ = 0;
  int steps_ = 0;
};

/// The outer faces of the marked cavity as its inside sees them. Nothing when a fixed node lies
/// wholly inside, or there are too many.
std::optional<Front> outer_front(const WorkMesh& work, const Cavity& cavity) {
  Front front;
  std::array<bool, node_limit> is_outer{};
  const auto place_of = [&cavity](std::int32_t v) {
    return static_cast<Node>(std::find(cavity.nodes.begin(), cavity.nodes.end(), v) -
                             cavity.nodes.begin());
  };
  for (const std::int32_t t : cavity.tets) {
    for (int face = 0; face < 4; ++face) {
      const FaceHandle across = work.across(t, face);
      if (across != no_face && work.marks.has(tet_of(across))) continue;
      const auto& local = tet_face_nodes[at(face)];
      Face seen;
      for (std::size_t i = 0; i < 3; ++i) {
        seen[i] = place_of(work.tet(t)[at(local[2 - i])]);
        is_outer[seen[i]] = true;
      }
      if (!front.add_open(seen)) return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < cavity.nodes.size(); ++i) {
    if (!is_outer[i] && !work.may_move(cavity.nodes[i])) return std::nullopt;
  }
  return front;
}

double volume6_of(const WorkMesh& work, const std::vector<std::int32_t>& tets) {
  double sum = 0;
  for (const std::int32_t t : tets) {
    const auto& [a, b, c, d] = work.tet(t);
    sum += 6 * tet_volume(work.point(a), work.point(b), work.point(c), work.point(d));
  }
  return sum;
}

}  // namespace

std::optional<Replacement> find_reconnection(WorkMesh& work, std::int32_t t,
                                             const ReconnectionOptions& options) {
  TF_CHECK(options.most_nodes <= node_limit);
  const Cavity cavity = grown_cavity(work, t, options);
  const std::optional<Front> front = outer_front(work, cavity);
  if (!front) return std::nullopt;
  double before = 1;
  for (const std::int32_t inside : cavity.tets) {
    before = std::min(before, measure_of(work, inside, options));
  }
  Search search(work, cavity, options, least_worth(before, work.gain));
  search.run(*front, volume6_of(work, cavity.tets));
  if (search.best().empty()) return std::nullopt;
  Replacement replacement{cavity.tets, {}, before, search.best_worst(), std::nullopt};
  for (const auto& tet : search.best()) {
    replacement.new_tets.push_back(
        {cavity.nodes[tet[0]], cavity.nodes[tet[1]], cavity.nodes[tet[2]], cavity.nodes[tet[3]]});
  }
  return replacement;
}

}  // namespace tetfarm::cosmetics
