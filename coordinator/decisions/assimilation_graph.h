/// The task that joins the leaves into groups, between the last cut and the first mesh.
///
/// A group is a leaf from then on, under the number of its first leaf; the others are joined into
/// it. The one task that needs all leaves: who is joined with whom depends on all of them.
///
/// Source: thesis 4.3.2. The files and numbers of the task are listed in proto/protocol.md.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "coordinator/decisions/task_graph.h"
#include "tasks/assimilate_contract.h"

namespace tetfarm {

/// Whether the job asks for groups. @pre `inspect` is done.
bool is_assimilated(const TaskRow& inspect);

/// What is wrong with the groups of a result: a leaf in none, a group without a file.
std::optional<std::string> problem_with_groups(const AssimilateGiven& given,
                                               const AssimilateMade& made);

/// Joins the leaves into groups (thesis 4.3.2); nothing when the job does not ask for it.
/// @pre `tree` is the whole tree by rising heap number: nothing in it is open or joined.
std::optional<TaskRow> assimilate_task(const TaskRow& inspect, std::span<const SubdomainRow> tree);

/// The groups as leaves to be meshed, and the leaves that are joined into them.
/// @pre `assimilate` is done and without problem; `tree` as it was for assimilate_task.
GraphStep after_assimilate(const TaskRow& inspect, const TaskRow& assimilate,
                           std::span<const SubdomainRow> tree);

}  // namespace tetfarm
