#include "mesh/filling/sweep_points.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/hilbert_order.h"

namespace tetfarm {
namespace {

struct Candidate {
  Vec3 place;
  double spacing = 0;
  /// Squared distance to the nearest node of its tet, in spacings.
  double room = 0;
  std::int32_t tet = -1;
  Tet nodes{};  // of the tet when it was judged
};

class Sweeps {
 public:
  Sweeps(TetComplex& complex, std::vector<std::uint8_t>& constrained, const SpacingField& spacing,
         const SweepOptions& options)
      : complex_(complex),
        constrained_(constrained),
        spacing_(spacing),
        options_(options),
        insertion_(complex, &constrained) {}

  SweepReport run(const std::vector<std::uint8_t>& inside) {
    TF_CHECK(inside.size() == complex_.nodes.size());
    open_ = inside;
    SweepReport report;
    for (;;) {
      const auto first = static_cast<std::int32_t>(complex_.points.size());
      const std::int64_t added = sweep();
      if (added == 0) return report;
      ++report.sweeps;
      report.points += added;
      // Every tet that the sweep made has one of its points, and so lies inside.
      open_.resize(complex_.nodes.size());
      std::ranges::transform(complex_.nodes, open_.begin(), [first](const Tet& n) {
        return static_cast<std::uint8_t>(*std::ranges::max_element(n) >= first ? 1 : 0);
      });
    }
  }

 private:
  std::int64_t sweep() {
    const std::vector<Candidate> candidates = gather();
    std::int64_t added = 0;
    constexpr int tell_every = 1 << 12;
    options_.progress.begin(WorkStage::points, candidates.size(), tell_every);
    options_.progress.next_pass();
    for (const std::int32_t i : largest_first(candidates)) {
      if (insert(candidates[at(i)])) ++added;
      options_.progress.add();
    }
    return added;
  }

  std::vector<Candidate> gather() const {
    std::vector<Candidate> candidates;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(open_.size()); ++t) {
      if (open_[at(t)] == 0 || !complex_.is_live(t)) continue;
      const Candidate candidate = candidate_of(t);
      if (candidate.room >= options_.own_clearance * options_.own_clearance) {
        candidates.push_back(candidate);
      }
    }
    return candidates;
  }

  Candidate candidate_of(std::int32_t tet) const {
    const Tet& n = complex_.nodes[at(tet)];
    const Vec3 centroid = 0.25 * ((point(n[0]) + point(n[1])) + (point(n[2]) + point(n[3])));
    double nearest2 = norm2(point(n[0]) - centroid);
    for (const std::int32_t v : n) nearest2 = std::min(nearest2, norm2(point(v) - centroid));
    const double h = spacing_.at(centroid);
    return {.place = centroid, .spacing = h, .room = nearest2 / (h * h), .tet = tet, .nodes = n};
  }

  static std::vector<std::int32_t> largest_first(const std::vector<Candidate>& candidates) {
    std::vector<Vec3> places;
    places.reserve(candidates.size());
    for (const Candidate& candidate : candidates) places.push_back(candidate.place);
    std::vector<std::int32_t> order = hilbert_order(places);
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      return candidates[at(a)].room > candidates[at(b)].room;
    });
    return order;
  }

  /// A tet whose candidate is refused never gets another: what is too near stays.
  bool insert(const Candidate& candidate) {
    if (complex_.nodes[at(candidate.tet)] != candidate.nodes) return false;
    const auto node = static_cast<std::int32_t>(complex_.points.size());
    complex_.points.push_back(candidate.place);
    complex_.node2tet.push_back(-1);
    if (insertion_.find_cavity(node, candidate.tet) && keeps_clear(candidate)) {
      insertion_.fill();
      return true;
    }
    complex_.points.pop_back();
    complex_.node2tet.pop_back();
    return false;
  }

  bool keeps_clear(const Candidate& candidate) const {
    const double from_nodes = options_.other_clearance * candidate.spacing;
    const double from_faces = options_.face_clearance * candidate.spacing;
    for (const FaceHandle face : insertion_.hull()) {
      const Tet& n = complex_.nodes[at(tet_of(face))];
      const auto& f = tet_face_nodes[at(face_of(face))];
      const std::array<Vec3, 3> x = {point(n[at(f[0])]), point(n[at(f[1])]), point(n[at(f[2])])};
      for (const Vec3& p : x) {
        if (norm2(p - candidate.place) < from_nodes * from_nodes) return false;
      }
      if ((constrained_[at(tet_of(face))] >> face_of(face) & 1) == 0) continue;
      const Vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
      const double height = dot(normal, candidate.place - x[0]);
      if (height * height < from_faces * from_faces * norm2(normal)) return false;
    }
    return true;
  }

  const Vec3& point(std::int32_t v) const { return complex_.points[at(v)]; }

  TetComplex& complex_;
  std::vector<std::uint8_t>& constrained_;
  const SpacingField& spacing_;
  const SweepOptions& options_;
  CavityInsertion insertion_;
  std::vector<std::uint8_t> open_;  // of a tet: inside, and to be judged in the next sweep
};

}  // namespace

SweepReport sweep_points(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                         const std::vector<std::uint8_t>& inside, const SpacingField& spacing,
                         const SweepOptions& options) {
  return Sweeps(complex, constrained, spacing, options).run(inside);
}

}  // namespace tetfarm
