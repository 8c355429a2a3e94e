/// What a TOML text may be before it is parsed: toml++ descends once for each level of nesting and
/// for each segment of a dotted key, also when it frees the tables again, so that a long key would
/// overflow the stack. Looks at the text alone, in one pass.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetfarm {

/// 1 MiB: ten thousand sources.
inline constexpr std::size_t largest_job_file = std::size_t{1} << 20U;
/// Arrays and inline tables in one another; a job file has three.
inline constexpr int deepest_toml = 32;
/// Of a dotted key or the name of a table; a job file has two.
inline constexpr int most_key_segments = 16;

/// @param path that of the file, for messages. @throws UsageError "path:line:column: …"; of a text
/// that is too large "path: …". Cost: O(size).
void check_toml_limits(std::string_view text, const std::string& path);

}  // namespace tetfarm
