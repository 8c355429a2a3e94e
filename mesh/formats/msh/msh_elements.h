/// Gmsh's element types and node tags, as both versions of .msh use them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/core/elements.h"

namespace tetfarm {

struct MshElementType {
  std::string_view name;
  int dimension = 0;
  int nodes = 0;
};

inline constexpr std::int64_t msh_triangle = code_of(ElementCodes::msh, ElementType::triangle);
inline constexpr std::int64_t msh_quad = code_of(ElementCodes::msh, ElementType::quad);

/// Source: Gmsh reference manual, "MSH file format". Nothing for a type that it does not list.
std::optional<MshElementType> msh_element_type(std::int64_t type);

/// Node tags may have gaps and any order. Looked up where the tag of a file numbered in sequence
/// would be, then by bisection.
class MshNodeTags {
 public:
  void reserve(std::size_t count) { tags_.reserve(count); }
  /// The next node of the file.
  void add(std::int64_t tag) { tags_.push_back({tag, static_cast<std::int32_t>(tags_.size())}); }
  std::size_t size() const { return tags_.size(); }
  /// To be called before find; a tag that occurs twice is returned.
  std::optional<std::int64_t> sort();
  /// The node's place in the file, or -1.
  std::int32_t find(std::int64_t tag) const;

 private:
  std::vector<std::pair<std::int64_t, std::int32_t>> tags_;
};

}  // namespace tetfarm
