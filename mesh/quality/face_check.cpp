#include "mesh/quality/face_check.h"

#include <algorithm>
#include <map>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "base/counted.h"
#include "mesh/core/complaints.h"
#include "mesh/core/element_block.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

using std::to_string;

constexpr std::uint64_t odd_bit = 1;
constexpr std::uint64_t boundary_bit = 2;
constexpr int last_shift = 2;
constexpr int middle_shift = 33;
constexpr std::uint64_t node_bits = 0x7fffffff;

/// The corners of a quad so that it has the same ones from either side and wherever it begins; true
/// when that turned them the other way round.
template <class Node>
bool sort_quad(std::array<Node, 4>& nodes) {
  std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
  if (nodes[1] < nodes[3]) return false;
  std::swap(nodes[1], nodes[3]);
  return true;
}

/// The same of either kind of face.
bool sort_nodes(FaceCorners& nodes) {
  if (nodes[3] >= 0) return sort_quad(nodes);
  std::array<std::int64_t, 3> triangle = {nodes[0], nodes[1], nodes[2]};
  const bool is_turned = sort_face(triangle);
  std::copy(triangle.begin(), triangle.end(), nodes.begin());
  return is_turned;
}

/// Calls visit(nodes, bits of the key) for each triangle that is a face of a cell, tets first, then
/// for each boundary triangle.
template <class Visit>
void for_each_face(const NumberedPart& part, const Visit& visit) {
  for (const Tet& tet : part.tets) {
    for (const auto& [i, j, k] : tet_face_nodes) {
      visit(Triangle{tet[at(i)], tet[at(j)], tet[at(k)]}, std::uint64_t{0});
    }
  }
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> cell, std::int32_t) {
        for_each_face_of(type, cell, [&](ElementType, std::span<const std::int32_t> face) {
          if (face.size() == 3) visit(Triangle{face[0], face[1], face[2]}, std::uint64_t{0});
        });
      });
  for (const Triangle& face : part.faces) visit(face, boundary_bit);
}

using Quad = std::array<std::int32_t, 4>;

/// Calls visit(nodes, bits) for each quad in the same way.
template <class Visit>
void for_each_quad(const NumberedPart& part, const Visit& visit) {
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> cell, std::int32_t) {
        for_each_face_of(type, cell, [&](ElementType, std::span<const std::int32_t> face) {
          if (face.size() == 4) visit(Quad{face[0], face[1], face[2], face[3]}, std::uint64_t{0});
        });
      });
  for_each_block_face(part.blocks, [&](ElementType, std::span<const std::int32_t> face,
                                       std::int32_t, std::int32_t) {
    visit(Quad{face[0], face[1], face[2], face[3]}, boundary_bit);
  });
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
  std::int64_t first_quad = 0;
  ElementCounts first_other;
};

/// The element of each face that for_each_face or for_each_quad visits, one after the other.
std::vector<std::string> owners_of_blocks(const NumberedPart& part, const PartPlace& place,
                                          std::size_t corners) {
  std::vector<std::string> owners;
  ElementCounts next = place.first_other;
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t>, std::int32_t) {
        const std::string name = std::string(element(type).name) + " " + to_string(next[type]++);
        for (const ElementFace& face : element(type).faces) {
          if (nodes_of(face.type) == corners) owners.push_back(name);
        }
      });
  return owners;
}

class FaceFinder {
 public:
  FaceFinder(const NumberedPart& part, const PartPlace& place, bool knows_subdomains,
             std::map<FaceCorners, FaceFinding>& findings)
      : part_(part),
        place_(place),
        where_(knows_subdomains ? " of sub-domain " + to_string(place.part) : ""),
        findings_(findings) {}

  void find() {
    const std::vector<std::string> owners = owners_of_blocks(part_, place_, 3);
    const std::int64_t of_tets = 4 * std::ssize(part_.tets);
    std::int64_t next = 0;
    for_each_face(part_, [&](const Triangle& face, std::uint64_t bits) {
      const std::int64_t i = next++;
      look(face, bits, [&] {
        if (i < of_tets) return "tet " + to_string(place_.first_tet + i / 4);
        const std::int64_t rest = i - of_tets - std::ssize(owners);
        return rest < 0 ? owners[static_cast<std::size_t>(i - of_tets)]
                        : "boundary triangle " + to_string(place_.first_triangle + rest);
      });
    });
    find_quads();
  }

 private:
  void find_quads() {
    const std::vector<std::string> owners = owners_of_blocks(part_, place_, 4);
    std::int64_t next = 0;
    for_each_quad(part_, [&](const Quad& face, std::uint64_t bits) {
      const std::int64_t i = next++;
      look(face, bits, [&] {
        return i < std::ssize(owners)
                   ? owners[static_cast<std::size_t>(i)]
                   : "boundary quad " + to_string(place_.first_quad + i - std::ssize(owners));
      });
    });
  }

  template <class Owner>
  void look(std::span<const std::int32_t> local, std::uint64_t bits, const Owner& owner) {
    FaceCorners nodes = {-1, -1, -1, -1};
    for (std::size_t k = 0; k < local.size(); ++k) nodes[k] = part_.local2global[at(local[k])];
    const std::size_t side = sort_nodes(nodes) ? 1 : 0;
    const auto found = findings_.find(nodes);
    if (found == findings_.end()) return;
    FaceFinding& finding = found->second;
    FaceUse use;
    (bits != boundary_bit ? use.tets : use.boundary)[side] = 1;
    finding.use.add(use);
    Vec3 sum;
    for (const std::int32_t v : local) sum += part_.nodes[at(v)];
    finding.at = sum / static_cast<double>(local.size());
    finding.elements += (finding.elements.empty() ? "" : ", ") + owner() + where_;
  }

  const NumberedPart& part_;
  const PartPlace& place_;
  std::string where_;
  std::map<FaceCorners, FaceFinding>& findings_;
};

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
  add_triangles(part);
  add_quads(part);
}

/// For faces that are not done with in their part; nodes are not sorted yet.
void FaceCheck::keep_open(OpenFace open) {
  if (sort_nodes(open.nodes)) {
    std::swap(open.use.tets[0], open.use.tets[1]);
    std::swap(open.use.boundary[0], open.use.boundary[1]);
  }
  open_.push(open);
}

void FaceCheck::add_triangles(const NumberedPart& part) {
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
    faces.for_each([&](const Triangle& nodes, const FaceUse& use) {
      if (is_matched_inside(use)) return;
      OpenFace open{{-1, -1, -1, -1}, use};
      for (std::size_t k = 0; k < 3; ++k) open.nodes[k] = part.local2global[at(nodes[k])];
      keep_open(open);
    });
    first = last;
  }
}

/// Quads are few beside what the kernel makes: all of a part are sorted at once.
void FaceCheck::add_quads(const NumberedPart& part) {
  std::vector<std::pair<Quad, FaceUse>> quads;
  for_each_quad(part, [&](Quad nodes, std::uint64_t bits) {
    FaceUse use;
    const std::size_t side = sort_quad(nodes) ? 1 : 0;
    (bits == boundary_bit ? use.boundary : use.tets)[side] = 1;
    quads.emplace_back(nodes, use);
  });
  std::sort(quads.begin(), quads.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < quads.size();) {
    OpenFace open;
    const Quad nodes = quads[i].first;
    for (; i < quads.size() && quads[i].first == nodes; ++i) open.use.add(quads[i].second);
    if (is_matched_inside(open.use)) continue;
    for (std::size_t k = 0; k < 4; ++k) open.nodes[k] = part.local2global[at(nodes[k])];
    keep_open(open);
  }
}

std::vector<FaceCorners> FaceCheck::finish(std::size_t most) {
  std::vector<FaceCorners> bad;
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
                                        const std::vector<FaceCorners>& faces) {
  std::map<FaceCorners, FaceFinding> findings;
  for (const FaceCorners& face : faces) findings[face];
  PartPlace place;
  for (; place.part < source.size() && !faces.empty(); ++place.part) {
    const NumberedPart part = source.part(place.part);
    FaceFinder(part, place, source.knows_subdomains(), findings).find();
    place.first_tet += std::ssize(part.tets);
    place.first_triangle += std::ssize(part.faces);
    for_each_block(part.blocks, [&](ElementType type, const ElementBlock& block) {
      (is_cell(type) ? place.first_other[type] : place.first_quad) += std::ssize(block.regions);
    });
  }
  std::vector<std::string> lines;
  for (const auto& [nodes, finding] : findings) {
    lines.push_back("face (" + to_string(nodes[0]) + ", " + to_string(nodes[1]) + ", " +
                    to_string(nodes[2]) + (nodes[3] < 0 ? "" : ", " + to_string(nodes[3])) +
                    ") at " + text_of(finding.at) + " has " + finding.use.text() + ": " +
                    finding.elements);
  }
  return lines;
}

}  // namespace tetfarm
