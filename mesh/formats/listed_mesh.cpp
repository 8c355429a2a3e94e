#include "mesh/formats/listed_mesh.h"

#include <algorithm>
#include <limits>

#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/local_numbers.h"
#include "mesh/formats/regions_of_faces.h"

namespace tetfarm {
namespace {

using Nodes = ListedMesh::Nodes;
using FaceNodes = std::array<std::int64_t, 3>;

constexpr std::int64_t tets_at_once = 65536;
constexpr std::int32_t most_names = 1'000'000;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

/// The smallest number first, turning the same way round.
FaceNodes smallest_first(FaceNodes face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

struct PartOfList {
  std::int64_t first_tet = 0;
  std::int64_t tets = 0;
  std::vector<TetRun> runs;
  std::vector<std::size_t> triangles;
};

/// The boundary triangles for whose tets is looked.
class UnclaimedTriangles {
 public:
  explicit UnclaimedTriangles(const ListedMesh& mesh) : has_node_(at(mesh.nodes), false) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const FaceNodes& nodes = mesh.triangles[t].nodes;
      for (const std::int64_t node : nodes) has_node_[at(node)] = true;
      by_nodes_.emplace_back(smallest_first(nodes), t);
    }
    std::sort(by_nodes_.begin(), by_nodes_.end());
    is_taken_.resize(by_nodes_.size(), false);
  }

  /// Of each node of the mesh, whether a boundary triangle has it.
  const std::vector<bool>& nodes() const { return has_node_; }

  /// Appends those that the tet has as faces. Of several equal ones the first goes to the first
  /// who asks.
  void give_faces(const Nodes& tet, std::vector<std::size_t>& to) {
    std::array<bool, 4> is_outside{};
    for (std::size_t k = 0; k < 4; ++k) is_outside[k] = has_node_[at(tet[k])];
    if (is_outside[0] + is_outside[1] + is_outside[2] + is_outside[3] < 3) return;
    for (const auto& [i, j, k] : tet_face_nodes) {
      if (is_outside[at(i)] && is_outside[at(j)] && is_outside[at(k)]) {
        give(smallest_first({tet[at(i)], tet[at(j)], tet[at(k)]}), to);
      }
    }
  }

  /// Those that nobody got, ascending.
  std::vector<std::size_t> rest() const {
    std::vector<std::size_t> left;
    for (std::size_t t = 0; t < is_taken_.size(); ++t) {
      if (!is_taken_[t]) left.push_back(t);
    }
    return left;
  }

 private:
  void give(const FaceNodes& face, std::vector<std::size_t>& to) {
    auto found =
        std::lower_bound(by_nodes_.begin(), by_nodes_.end(), std::pair(face, std::size_t{0}));
    for (; found != by_nodes_.end() && found->first == face; ++found) {
      if (is_taken_[found->second]) continue;
      is_taken_[found->second] = true;
      to.push_back(found->second);
      return;
    }
  }

  std::vector<bool> has_node_;
  std::vector<std::pair<FaceNodes, std::size_t>> by_nodes_;  ///< sorted; with its number
  std::vector<bool> is_taken_;                               ///< by its number
};

class ListedSource : public MeshSource {
 public:
  ListedSource(ListedMesh mesh, std::int64_t tets_of_piece) : mesh_(std::move(mesh)) {
    check();
    if (mesh_.knows_subdomains) {
      make_subdomains();
    } else {
      make_pieces(tets_of_piece);
    }
    if (parts_.empty()) fail("has no tets");
    share_out();
  }

  std::size_t size() const override { return parts_.size(); }
  bool knows_subdomains() const override { return mesh_.knows_subdomains; }
  bool takes_threads() const override { return mesh_.takes_threads; }
  std::vector<std::string> complaints() const override { return complaints_; }
  std::vector<std::string> patch_names() const override { return mesh_.patch_names; }
  std::vector<std::string> region_names() const override { return mesh_.region_names; }

  NumberedPart part(std::size_t i) const override {
    const PartOfList& here = parts_.at(i);
    NumberedPart part;
    part.number = static_cast<std::int32_t>(i);
    set_regions(here, part);
    std::vector<Nodes> tets(at(here.tets));
    mesh_.read_tets(here.first_tet, tets);
    LocalNumbers numbers;
    part.tets.resize(tets.size());
    for (std::size_t t = 0; t < tets.size(); ++t) {
      for (std::size_t k = 0; k < 4; ++k) part.tets[t][k] = numbers.of(tets[t][k]);
    }
    tets = {};
    for (const std::size_t t : here.triangles) {
      Triangle& face = part.faces.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) face[k] = numbers.of(mesh_.triangles[t].nodes[k]);
      part.patch_of_face.push_back(mesh_.triangles[t].patch);
    }
    renumber(part, numbers.sort());
    part.local2global = numbers.take();
    read_nodes(part);
    if (!part.region_of_tet.empty()) set_regions_of_faces(part);
    return part;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InvalidInput(what, mesh_.name); }

  void check() const {
    for (const TetRun& run : mesh_.runs) {
      if (run.region < 1 || run.region > most_names) {
        fail("a tet has the region " + std::to_string(run.region));
      }
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const ListedTriangle& triangle = mesh_.triangles[t];
      if (triangle.patch < 0 || triangle.patch >= most_names) {
        fail("boundary triangle " + std::to_string(t) + " has the patch " +
             std::to_string(triangle.patch));
      }
      for (const std::int64_t node : triangle.nodes) {
        if (node < 0 || node >= mesh_.nodes) {
          fail("boundary triangle " + std::to_string(t) + " has node " + std::to_string(node) +
               " of " + std::to_string(mesh_.nodes));
        }
      }
    }
  }

  void make_subdomains() {
    std::int64_t first = 0;
    std::int32_t subdomain = 0;
    for (const TetRun& run : mesh_.runs) {
      if (run.tets == 0) continue;
      if (parts_.empty() || run.subdomain != subdomain) parts_.push_back({first, 0, {}, {}});
      subdomain = run.subdomain;
      PartOfList& part = parts_.back();
      part.tets += run.tets;
      part.runs.push_back(run);
      if (part.tets > std::numeric_limits<std::int32_t>::max()) {
        fail("a sub-domain has more than 2147483647 tets");
      }
      first += run.tets;
    }
  }

  void make_pieces(std::int64_t most) {
    TF_CHECK(most > 0);
    std::int64_t first = 0;
    for (const TetRun& run : mesh_.runs) {
      for (std::int64_t done = 0; done < run.tets; done += most) {
        const TetRun piece{std::min(most, run.tets - done), run.region, 0};
        parts_.push_back({first + done, piece.tets, {piece}, {}});
      }
      first += run.tets;
    }
  }

  /// Gives each part its triangles, and the last one those that no tet has.
  void share_out() {
    TF_CHECK(!parts_.empty());
    UnclaimedTriangles unclaimed(mesh_);
    std::vector<bool> is_used = unclaimed.nodes();
    for (PartOfList& part : parts_) {
      for_each_tet(part, [&](const Nodes& tet) {
        for (const std::int64_t node : tet) is_used[at(node)] = true;
        unclaimed.give_faces(tet, part.triangles);
      });
    }
    const std::vector<std::size_t> rest = unclaimed.rest();
    std::vector<std::size_t>& last = parts_.back().triangles;
    last.insert(last.end(), rest.begin(), rest.end());
    // As the file has them.
    for (PartOfList& part : parts_) std::sort(part.triangles.begin(), part.triangles.end());
    complain_of_unused(is_used);
  }

  void complain_of_unused(const std::vector<bool>& is_used) {
    const auto unused = std::find(is_used.begin(), is_used.end(), false);
    if (unused == is_used.end()) return;
    complaints_.push_back("node " + std::to_string(unused - is_used.begin()) +
                          " is in no tet and no boundary triangle; such nodes: " +
                          std::to_string(std::count(unused, is_used.end(), false)));
  }

  template <class Visit>
  void for_each_tet(const PartOfList& part, const Visit& visit) const {
    std::vector<Nodes> tets;
    for (std::int64_t done = 0; done < part.tets; done += std::ssize(tets)) {
      tets.resize(at(std::min(tets_at_once, part.tets - done)));
      mesh_.read_tets(part.first_tet + done, tets);
      for (std::size_t t = 0; t < tets.size(); ++t) {
        for (const std::int64_t node : tets[t]) {
          if (node >= 0 && node < mesh_.nodes) continue;
          fail("tet " + std::to_string(part.first_tet + done + static_cast<std::int64_t>(t)) +
               " has node " + std::to_string(node) + " of " + std::to_string(mesh_.nodes));
        }
        visit(tets[t]);
      }
    }
  }

  static void set_regions(const PartOfList& here, NumberedPart& part) {
    part.region = here.runs.front().region;
    const bool is_one = std::all_of(here.runs.begin(), here.runs.end(),
                                    [&](const TetRun& run) { return run.region == part.region; });
    if (is_one) return;
    for (const TetRun& run : here.runs) {
      part.region_of_tet.insert(part.region_of_tet.end(), at(run.tets), run.region);
    }
    TF_CHECK(part.region_of_tet.size() == at(here.tets));
  }

  static void renumber(NumberedPart& part, const std::vector<std::int32_t>& new_number) {
    for (Tet& tet : part.tets) {
      for (std::int32_t& v : tet) v = new_number[at(v)];
    }
    for (Triangle& face : part.faces) {
      for (std::int32_t& v : face) v = new_number[at(v)];
    }
  }

  /// Stretches of the list that have nearly all their nodes in the part are read at once.
  void read_nodes(NumberedPart& part) const {
    constexpr std::int64_t widest_gap = 16;
    constexpr std::int64_t most_at_once = 65536;
    const std::vector<std::int64_t>& numbers = part.local2global;
    std::vector<Vec3> stretch;
    part.nodes.resize(numbers.size());
    for (std::size_t first = 0; first < numbers.size();) {
      std::size_t last = first;
      while (last + 1 < numbers.size() && numbers[last + 1] - numbers[last] <= widest_gap &&
             numbers[last + 1] - numbers[first] < most_at_once) {
        ++last;
      }
      stretch.resize(at(numbers[last] - numbers[first] + 1));
      mesh_.read_nodes(numbers[first], stretch);
      for (std::size_t v = first; v <= last; ++v) {
        part.nodes[v] = stretch[at(numbers[v] - numbers[first])];
      }
      first = last + 1;
    }
  }

  ListedMesh mesh_;
  std::vector<PartOfList> parts_;
  std::vector<std::string> complaints_;
};

}  // namespace

void add_tets(std::vector<TetRun>& runs, const TetRun& next) {
  if (!runs.empty() && runs.back().region == next.region &&
      runs.back().subdomain == next.subdomain) {
    runs.back().tets += next.tets;
  } else {
    runs.push_back(next);
  }
}

std::unique_ptr<MeshSource> open_listed(ListedMesh mesh, std::int64_t tets_of_piece) {
  return std::make_unique<ListedSource>(std::move(mesh), tets_of_piece);
}

}  // namespace tetfarm
