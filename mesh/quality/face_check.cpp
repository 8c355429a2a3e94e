#include "mesh/quality/face_check.h"

#include <algorithm>
#include <map>
#include <span>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/core/complaints.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

using std::to_string;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

constexpr std::uint64_t odd_bit = 1;
constexpr std::uint64_t boundary_bit = 2;
constexpr int last_shift = 2;
constexpr int middle_shift = 33;
constexpr std::uint64_t node_bits = 0x7fffffff;

/// Calls visit(nodes, bits of the key) for each face of each tet, then for each boundary triangle.
template <class Visit>
void for_each_face(const NumberedPart& part, const Visit& visit) {
  for (const Tet& tet : part.tets) {
    for (const auto& [i, j, k] : tet_face_nodes) {
      visit(Triangle{tet[at(i)], tet[at(j)], tet[at(k)]}, std::uint64_t{0});
    }
  }
  for (const Triangle& face : part.faces) visit(face, boundary_bit);
}

/// How many faces have each node as their lowest.
std::vector<std::uint32_t> faces_of_lowest_node(const NumberedPart& part) {
  std::vector<std::uint32_t> counts(part.nodes.size(), 0);
  for_each_face(part, [&](const Triangle& nodes, std::uint64_t) {
    ++counts[at(std::min({nodes[0], nodes[1], nodes[2]}))];
  });
  return counts;
}

/// The faces whose lowest node is one of a range, in buckets of that node.
class FaceBuckets {
 public:
  FaceBuckets(const NumberedPart& part, std::span<const std::uint32_t> counts,
              std::int32_t first_node)
      : first_node_(first_node), end_(counts.size()) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      end_[i] = start;
      start += counts[i];
    }
    keys_.resize(start);
    const auto last_node = first_node + static_cast<std::int32_t>(counts.size());
    for_each_face(part, [&](Triangle nodes, std::uint64_t bits) {
      const std::int32_t lowest = std::min({nodes[0], nodes[1], nodes[2]});
      if (lowest < first_node || lowest >= last_node) return;
      if (sort_face(nodes)) bits |= odd_bit;
      keys_[end_[at(lowest - first_node)]++] =
          static_cast<std::uint64_t>(nodes[1]) << middle_shift |
          static_cast<std::uint64_t>(nodes[2]) << last_shift | bits;
    });
  }

  /// Calls visit(nodes, use) for each face.
  template <class Visit>
  void for_each(const Visit& visit) {
    std::size_t i = 0;
    for (std::size_t bucket = 0; bucket < end_.size(); ++bucket) {
      std::sort(keys_.begin() + static_cast<std::ptrdiff_t>(i),
                keys_.begin() + static_cast<std::ptrdiff_t>(end_[bucket]));
      TF_CHECK(end_[bucket] >= i);  // buckets follow one another
      while (i < end_[bucket]) {
        const std::uint64_t nodes = keys_[i] >> last_shift;
        FaceUse use;
        for (; i < end_[bucket] && keys_[i] >> last_shift == nodes; ++i) use.add(use_of(keys_[i]));
        visit(Triangle{first_node_ + static_cast<std::int32_t>(bucket),
                       static_cast<std::int32_t>(nodes >> (middle_shift - last_shift)),
                       static_cast<std::int32_t>(nodes & node_bits)},
              use);
      }
    }
  }

 private:
  static FaceUse use_of(std::uint64_t key) {
    FaceUse use;
    ((key & boundary_bit) != 0 ? use.boundary : use.tets)[key & odd_bit] = 1;
    return use;
  }

  std::int32_t first_node_;
  std::vector<std::size_t> end_;
  std::vector<std::uint64_t> keys_;
};

/// Which elements have a face.
struct FaceFinding {
  Vec3 at;
  FaceUse use;
  std::string elements;
};

/// Where the elements of a part begin in the whole mesh.
struct PartPlace {
  std::size_t part = 0;
  std::int64_t first_tet = 0;
  std::int64_t first_triangle = 0;
};

void find_faces(const NumberedPart& part, const PartPlace& place, bool knows_subdomains,
                std::map<FaceNodes, FaceFinding>& findings) {
  const std::string where = knows_subdomains ? " of sub-domain " + to_string(place.part) : "";
  std::int64_t next = 0;
  for_each_face(part, [&](const Triangle& local, std::uint64_t bits) {
    const std::int64_t face = next++;
    FaceNodes nodes{};
    for (std::size_t k = 0; k < 3; ++k) nodes[k] = part.local2global[at(local[k])];
    const std::size_t side = sort_face(nodes) ? 1 : 0;
    const auto found = findings.find(nodes);
    if (found == findings.end()) return;
    FaceFinding& finding = found->second;
    FaceUse use;
    const bool is_tet = bits != boundary_bit;
    (is_tet ? use.tets : use.boundary)[side] = 1;
    finding.use.add(use);
    const auto p = [&](std::size_t k) { return part.nodes[at(local[k])]; };
    finding.at = (p(0) + p(1) + p(2)) / 3.0;
    finding.elements += (finding.elements.empty() ? "" : ", ") +
                        (is_tet ? "tet " + to_string(place.first_tet + face / 4)
                                : "boundary triangle " + to_string(place.first_triangle + face -
                                                                   4 * std::ssize(part.tets))) +
                        where;
  });
}

bool is_matched_inside(const FaceUse& use) {
  return use.tets == std::array<std::uint8_t, 2>{1, 1} &&
         use.boundary == std::array<std::uint8_t, 2>{0, 0};
}

}  // namespace

bool FaceUse::is_right() const {
  if (boundary[0] == 0 && boundary[1] == 0) return tets[0] == 1 && tets[1] == 1;
  return std::max(boundary[0], boundary[1]) == 1 && tets == boundary;
}

void FaceUse::add(const FaceUse& other) {
  const auto sum = [](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::min(a + b, 255));
  };
  for (std::size_t i = 0; i < 2; ++i) {
    tets[i] = sum(tets[i], other.tets[i]);
    boundary[i] = sum(boundary[i], other.boundary[i]);
  }
}

std::string FaceUse::text() const {
  const auto sum = [](const auto& sides) {
    return static_cast<std::uint64_t>(sides[0] + sides[1]);
  };
  return counted(sum(tets), "tet") + " (" + to_string(tets[0]) + " from one side, " +
         to_string(tets[1]) + " from the other) and " +
         counted(sum(boundary), "boundary triangle") + " (" + to_string(boundary[0]) + ", " +
         to_string(boundary[1]) + ")";
}

FaceCheck::FaceCheck(const std::filesystem::path& folder, std::size_t memory_bytes)
    : keys_at_once_(std::max<std::size_t>(memory_bytes / 2 / sizeof(std::uint64_t), 1024)),
      open_(folder, std::max<std::size_t>(memory_bytes / 4 / sizeof(OpenFace), 1024)) {}

void FaceCheck::add(const NumberedPart& part) {
  const std::vector<std::uint32_t> counts = faces_of_lowest_node(part);
  for (std::size_t first = 0; first < counts.size();) {
    std::size_t last = first;
    for (std::size_t keys = 0; last < counts.size(); ++last) {
      keys += counts[last];
      if (keys > keys_at_once_ && last > first) break;
    }
    FaceBuckets faces(part, std::span(counts).subspan(first, last - first),
                      static_cast<std::int32_t>(first));
    TF_CHECK(last > first);
    faces.for_each([&](const Triangle& nodes, FaceUse use) {
      if (is_matched_inside(use)) return;
      OpenFace open;
      for (std::size_t k = 0; k < 3; ++k) open.nodes[k] = part.local2global[at(nodes[k])];
      if (sort_face(open.nodes)) {
        std::swap(use.tets[0], use.tets[1]);
        std::swap(use.boundary[0], use.boundary[1]);
      }
      open.use = use;
      open_.push(open);
    });
    first = last;
  }
}

std::vector<FaceNodes> FaceCheck::finish(std::size_t most) {
  std::vector<FaceNodes> bad;
  OpenFace next;
  bool has_next = open_.next(next);
  while (has_next && bad.size() < most) {
    OpenFace face = next;
    while ((has_next = open_.next(next)) && next.nodes == face.nodes) face.use.add(next.use);
    if (!face.use.is_right()) bad.push_back(face.nodes);
  }
  return bad;
}

std::vector<std::string> describe_faces(const MeshSource& source,
                                        const std::vector<FaceNodes>& faces) {
  std::map<FaceNodes, FaceFinding> findings;
  for (const FaceNodes& face : faces) findings[face];
  PartPlace place;
  for (; place.part < source.size() && !faces.empty(); ++place.part) {
    const NumberedPart part = source.part(place.part);
    find_faces(part, place, source.knows_subdomains(), findings);
    place.first_tet += std::ssize(part.tets);
    place.first_triangle += std::ssize(part.faces);
  }
  std::vector<std::string> lines;
  for (const auto& [nodes, finding] : findings) {
    lines.push_back("face (" + to_string(nodes[0]) + ", " + to_string(nodes[1]) + ", " +
                    to_string(nodes[2]) + ") at " + text_of(finding.at) + " has " +
                    finding.use.text() + ": " + finding.elements);
  }
  return lines;
}

}  // namespace tetfarm
