/// What TetGen's files are made of: lists, each a line of counts and then a line or more for each
/// record. The readers of surfaces (.poly, .smesh) and of meshes (.node, .face, .ele) share it.
///
/// Source: TetGen manual, "File formats". `#` begins a comment; what follows in a line is passed
/// over. Every failure throws InvalidInput with file and line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

#include "mesh/core/vec3.h"
#include "mesh/formats/input_scanner.h"

namespace tetfarm {

inline constexpr char tetgen_comment = '#';

/// The number of records, the first word of a list's line of counts. `what` is for messages: "the
/// number of nodes".
std::size_t tetgen_count(InputScanner& in, std::string_view what);

/// The next number of this line; `otherwise` when the line has no more.
std::int64_t tetgen_option(InputScanner& in, std::int64_t otherwise);

/// Reads a list of nodes from its line of counts on, hands each on, and returns the number of the
/// first, 0 or 1: those after it follow one another. Cost: O(bytes).
std::int64_t walk_tetgen_nodes(InputScanner& in, const std::function<void(const Vec3&)>& add_node);

}  // namespace tetfarm
