/// Where in its job a task is, for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tetfarm {

/// "LR" of a sub-domain, "cycle 3" of a cycle, "" where it is in none. `kind`: the name of the
/// kind.
std::string task_place(std::string_view kind, std::uint64_t path);

/// The same in a sentence: " of sub-domain LR", " of the whole domain", " of cycle 3", "".
std::string of_task_place(std::string_view kind, std::uint64_t path);

/// Whether the path is that of a sub-domain.
bool is_place_in_tree(std::string_view kind, std::uint64_t path);

}  // namespace tetfarm
