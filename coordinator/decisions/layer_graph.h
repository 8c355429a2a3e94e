/// The tasks of a job with layers: its tree has what the layers leave of the domain on the left
/// side of the root, and chunks of layers on the right, which are grown when the nodes have their
/// numbers.
///
/// Chunks are no sub-domains: they are known, cells and all, when the surface is inspected, and
/// nothing cuts them further.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "store/rows.h"
#include "tasks/assemble_contract.h"
#include "tasks/grow_contract.h"
#include "tasks/inspect_contract.h"

namespace tetfarm {

/// Where the tree of sub-domains begins: at 1; with layers at 2.
std::uint64_t root_path(const InspectMade& inspected);

/// Why what was inspected makes no tree; nothing where all is well.
std::optional<std::string> problem_with_layers(const InspectMade& inspected);

/// What gives a chunk its global numbers, as far as it is the same for all: `layers` is the chunk's
/// own. @pre `number` is done and without problem.
GrowGiven given_to_grow(const TaskRow& inspect, const TaskRow& number);

/// @pre `grow` is done and without problem.
void add_grown(const TaskRow& grow, AssembleGiven& assemble);

}  // namespace tetfarm
