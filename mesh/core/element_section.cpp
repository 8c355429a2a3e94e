#include "mesh/core/element_section.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

template <class Element>
bool has_nodes(const std::vector<Element>& elements, std::size_t nodes) {
  return std::all_of(elements.begin(), elements.end(), [nodes](const Element& element) {
    return std::all_of(element.begin(), element.end(),
                       [nodes](std::int32_t v) { return v >= 0 && at(v) < nodes; });
  });
}

template <class T>
bool ascends(const std::vector<T>& items) {
  return std::adjacent_find(items.begin(), items.end(),
                            [](const T& a, const T& b) { return !(a < b); }) == items.end();
}

bool are_places(const std::vector<std::uint8_t>& owners, std::size_t sharers) {
  return std::all_of(owners.begin(), owners.end(),
                     [sharers](std::uint8_t owner) { return owner < sharers; });
}

bool uses_every_node(const ElementSection& section) {
  std::vector<bool> is_used(section.nodes.size(), false);
  for (const Tet& tet : section.tets) {
    for (const std::int32_t v : tet) is_used[at(v)] = true;
  }
  return std::find(is_used.begin(), is_used.end(), false) == is_used.end();
}

std::vector<std::uint64_t> count_by_owner(const std::vector<std::uint8_t>& owners,
                                          std::size_t sharers) {
  std::vector<std::uint64_t> counts(sharers, 0);
  for (const std::uint8_t owner : owners) {
    TF_CHECK(owner < sharers);
    ++counts[owner];
  }
  return counts;
}

}  // namespace

std::vector<std::uint64_t> tets_by_sharer(const ElementSection& section) {
  return count_by_owner(section.tet_owner, section.sharers.size());
}

std::vector<std::uint64_t> triangles_by_sharer(const ElementSection& section) {
  return count_by_owner(section.triangle_owner, section.sharers.size());
}

std::vector<std::string> validate(const ElementSection& section) {
  Complaints complaints;
  const std::size_t nodes = section.nodes.size();
  const std::size_t sharers = section.sharers.size();
  const auto demand = [&complaints](bool holds, const char* what) {
    if (!holds) complaints.add(what);
  };
  demand(section.node_origin.size() == nodes, "nodes and their origins differ in number");
  demand(section.tet_owner.size() == section.tets.size(), "tets and owners differ in number");
  demand(section.triangle_index.size() == section.triangles.size() &&
             section.triangle_owner.size() == section.triangles.size(),
         "triangles, their numbers and owners differ in number");
  demand(sharers >= 1 && sharers <= most_sharers && ascends(section.sharers),
         "the sharers do not ascend");
  demand(are_places(section.tet_owner, sharers) && are_places(section.triangle_owner, sharers),
         "an owner is not a sharer");
  demand(ascends(section.node_origin), "the origins of the nodes do not ascend");
  const bool is_indexed = has_nodes(section.tets, nodes) && has_nodes(section.triangles, nodes);
  demand(is_indexed, "an element has a node that is not there");
  if (is_indexed) demand(uses_every_node(section), "a node is in no tet");
  return complaints.take();
}

}  // namespace tetfarm
