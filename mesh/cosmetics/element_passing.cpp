#include "mesh/cosmetics/element_passing.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

/// Gives the section the nodes of its tets, and its elements the numbers there. `local` is scratch:
/// -1 for every node, before and after.
void take_nodes(const JoinedElements& joined, std::vector<std::int32_t>& local,
                ElementSection& section) {
  std::vector<std::int32_t> nodes;
  for (const Tet& tet : section.tets) {
    for (const std::int32_t v : tet) {
      if (local[at(v)] >= 0) continue;
      local[at(v)] = 0;
      nodes.push_back(v);
    }
  }
  std::sort(nodes.begin(), nodes.end(), [&joined](std::int32_t a, std::int32_t b) {
    return joined.node_origin[at(a)] < joined.node_origin[at(b)];
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    local[at(nodes[i])] = static_cast<std::int32_t>(i);
    section.nodes.push_back(joined.nodes[at(nodes[i])]);
    section.node_origin.push_back(joined.node_origin[at(nodes[i])]);
  }
  for (Tet& tet : section.tets) {
    for (std::int32_t& v : tet) v = local[at(v)];
  }
  for (Triangle& triangle : section.triangles) {
    for (std::int32_t& v : triangle) v = local[at(v)];
  }
  for (const std::int32_t v : nodes) local[at(v)] = -1;
}

/// Sorts what consists of ascending runs, each from one of the ends to the next.
void merge_runs(std::vector<Origin>& items, std::vector<std::size_t> ends) {
  while (ends.size() > 2) {
    std::vector<std::size_t> fewer = {0};
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const std::size_t last = std::min(i + 2, ends.size() - 1);
      const auto place = [&](std::size_t end) {
        return items.begin() + static_cast<std::ptrdiff_t>(ends[end]);
      };
      std::inplace_merge(place(i), place(i + 1), place(last));
      fewer.push_back(ends[last]);
    }
    ends = std::move(fewer);
  }
}

/// As std::lower_bound: quick when it is near the first.
std::vector<Origin>::const_iterator first_not_before(std::vector<Origin>::const_iterator first,
                                                     std::vector<Origin>::const_iterator last,
                                                     const Origin& wanted) {
  std::ptrdiff_t step = 1;
  while (last - first > step && *(first + step) < wanted) {
    first += step;
    step *= 2;
  }
  return std::lower_bound(first, first + std::min(last - first, step + 1), wanted);
}

/// Where in the joined mesh the nodes of the section are; puts them there.
std::vector<std::int32_t> place_nodes(const ElementSection& section, std::vector<bool>& is_placed,
                                      JoinedElements& joined) {
  const std::vector<Origin>& origins = joined.node_origin;
  std::vector<std::int32_t> places;
  places.reserve(section.nodes.size());
  auto found = origins.cbegin();
  for (std::size_t v = 0; v < section.nodes.size(); ++v) {
    found = first_not_before(found, origins.cend(), section.node_origin[v]);
    TF_CHECK(found != origins.cend() && *found == section.node_origin[v]);
    const auto place = at(found - origins.cbegin());
    TF_CHECK(!is_placed[place] || joined.nodes[place] == section.nodes[v]);
    is_placed[place] = true;
    joined.nodes[place] = section.nodes[v];
    places.push_back(static_cast<std::int32_t>(place));
  }
  return places;
}

/// Adds the elements of a section, whose nodes have these places. Those of the first stay where
/// they lie in memory: it may be a whole leaf's core.
void add_elements(std::uint32_t number, ElementSection section,
                  const std::vector<std::int32_t>& places, JoinedElements& joined) {
  TF_CHECK(places.size() == section.nodes.size());
  for (Tet& tet : section.tets) {
    for (std::int32_t& v : tet) v = places[at(v)];
  }
  for (Triangle& triangle : section.triangles) {
    for (std::int32_t& v : triangle) v = places[at(v)];
  }
  for (const std::uint8_t owner : section.tet_owner) joined.tet_home.push_back({number, owner});
  const auto add = [](auto& from, auto& to) {
    if (to.empty()) {
      to = std::move(from);
    } else {
      to.insert(to.end(), from.begin(), from.end());
    }
  };
  add(section.tets, joined.tets);
  add(section.triangles, joined.triangles);
  add(section.triangle_index, joined.triangle_index);
}

}  // namespace

std::vector<std::size_t> tets_of_triangles(std::size_t nodes, const std::vector<Tet>& tets,
                                           const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, std::size_t>> faces;
  std::vector<bool> has_triangle(nodes, false);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    faces.emplace_back(sorted_face(triangles[i]), i);
    for (const std::int32_t v : triangles[i]) has_triangle[at(v)] = true;
  }
  std::sort(faces.begin(), faces.end());
  std::vector<std::size_t> tet_of(triangles.size(), tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const Tet& tet = tets[t];
    for (const auto& [i, j, k] : tet_face_nodes) {
      if (!has_triangle[at(tet[at(i)])] || !has_triangle[at(tet[at(j)])] ||
          !has_triangle[at(tet[at(k)])]) {
        continue;
      }
      const Triangle face = sorted_face(std::array{tet[at(i)], tet[at(j)], tet[at(k)]});
      const auto found = std::lower_bound(
          faces.begin(), faces.end(), face,
          [](const auto& item, const Triangle& wanted) { return item.first < wanted; });
      if (found != faces.end() && found->first == face) tet_of[found->second] = t;
    }
  }
  return tet_of;
}

std::vector<ElementSection> share_out_elements(const JoinedElements& joined,
                                               std::span<const Sharers> sharers) {
  TF_CHECK(joined.tet_home.size() == joined.tets.size());
  std::vector<ElementSection> sections(sharers.size());
  for (std::size_t s = 0; s < sharers.size(); ++s) sections[s].sharers = sharers[s];
  for (std::size_t t = 0; t < joined.tets.size(); ++t) {
    const ElementHome& home = joined.tet_home[t];
    TF_CHECK(home.section < sections.size());
    sections[home.section].tets.push_back(joined.tets[t]);
    sections[home.section].tet_owner.push_back(home.owner);
  }
  const auto tet_of = tets_of_triangles(joined.nodes.size(), joined.tets, joined.triangles);
  for (std::size_t i = 0; i < joined.triangles.size(); ++i) {
    TF_CHECK(tet_of[i] < joined.tets.size());
    const ElementHome& home = joined.tet_home[tet_of[i]];
    sections[home.section].triangles.push_back(joined.triangles[i]);
    sections[home.section].triangle_index.push_back(joined.triangle_index[i]);
    sections[home.section].triangle_owner.push_back(home.owner);
  }
  std::vector<std::int32_t> local(joined.nodes.size(), -1);
  for (ElementSection& section : sections) take_nodes(joined, local, section);
  return sections;
}

JoinedElements join_elements(std::vector<ElementSection> sections) {
  JoinedElements joined;
  auto& origins = joined.node_origin;
  std::vector<std::size_t> ends = {0};
  std::size_t tets = 0;
  for (const ElementSection& section : sections) {
    origins.insert(origins.end(), section.node_origin.begin(), section.node_origin.end());
    ends.push_back(origins.size());
    tets += section.tets.size();
  }
  merge_runs(origins, std::move(ends));
  origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
  joined.nodes.resize(origins.size());
  joined.tet_home.reserve(tets);
  std::vector<bool> is_placed(origins.size(), false);
  for (std::uint32_t s = 0; s < sections.size(); ++s) {
    ElementSection section = std::move(sections[s]);
    const std::vector<std::int32_t> places = place_nodes(section, is_placed, joined);
    add_elements(s, std::move(section), places, joined);
    joined.tets.reserve(tets);
  }
  TF_CHECK(joined.tets.size() == tets && joined.tet_home.size() == tets);
  return joined;
}

ElementSection join_pieces(std::vector<ElementSection> pieces) {
  TF_CHECK(!pieces.empty());
  const Sharers sharers = pieces.front().sharers;
  JoinedElements joined = join_elements(std::move(pieces));
  for (ElementHome& home : joined.tet_home) home.section = 0;
  return share_out_elements(joined, {&sharers, 1}).front();
}

ElementSection elements_of(const ElementSection& section, std::uint64_t owner) {
  TF_CHECK(section.tet_owner.size() == section.tets.size());
  ElementSection part;
  part.sharers = section.sharers;
  std::vector<std::int32_t> number(section.nodes.size(), -1);
  for (std::size_t t = 0; t < section.tets.size(); ++t) {
    if (section.sharers[section.tet_owner[t]] != owner) continue;
    part.tets.push_back(section.tets[t]);
    part.tet_owner.push_back(section.tet_owner[t]);
    for (const std::int32_t v : section.tets[t]) number[at(v)] = 0;
  }
  for (std::size_t i = 0; i < section.triangles.size(); ++i) {
    if (section.sharers[section.triangle_owner[i]] != owner) continue;
    part.triangles.push_back(section.triangles[i]);
    part.triangle_index.push_back(section.triangle_index[i]);
    part.triangle_owner.push_back(section.triangle_owner[i]);
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<std::int32_t>(part.nodes.size());
    part.nodes.push_back(section.nodes[v]);
    part.node_origin.push_back(section.node_origin[v]);
  }
  for (Tet& tet : part.tets) {
    for (std::int32_t& v : tet) v = number[at(v)];
  }
  for (Triangle& triangle : part.triangles) {
    for (std::int32_t& v : triangle) v = number[at(v)];
  }
  return part;
}

std::vector<int> layers_from(const JoinedElements& joined, std::span<const Sharers> sharers,
                             std::uint64_t self, int most) {
  TF_CHECK(most >= 0 && joined.tet_home.size() == joined.tets.size());
  std::vector<int> layer_of(joined.tets.size(), most + 1);
  std::vector<bool> is_marked(joined.nodes.size(), false);
  for (std::size_t t = 0; t < joined.tets.size(); ++t) {
    const ElementHome& home = joined.tet_home[t];
    if (sharers[home.section][home.owner] != self) continue;
    layer_of[t] = 0;
    for (const std::int32_t v : joined.tets[t]) is_marked[at(v)] = true;
  }
  for (int layer = 1; layer <= most; ++layer) {
    std::vector<std::size_t> reached;
    for (std::size_t t = 0; t < joined.tets.size(); ++t) {
      if (layer_of[t] <= most) continue;
      const Tet& tet = joined.tets[t];
      if (std::any_of(tet.begin(), tet.end(), [&](std::int32_t v) { return is_marked[at(v)]; })) {
        reached.push_back(t);
      }
    }
    for (const std::size_t t : reached) {
      layer_of[t] = layer;
      for (const std::int32_t v : joined.tets[t]) is_marked[at(v)] = true;
    }
  }
  return layer_of;
}

}  // namespace tetfarm
