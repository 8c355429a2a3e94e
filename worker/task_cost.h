/// What a task will take: memory, as a bound, and seconds, as an expectation; and how many
/// sub-domains keep every task below a limit of memory (`[decompose] max_memory`).
///
/// The thesis lets the user choose the number of sub-domains (4.3.1); here the size of a task is
/// known before it runs: its surface's triangles, its estimated elements, and the spacing's bytes,
/// which every task reads whole. The coefficients are measured:
/// docs/decisions/0012-decompose-assimilation.md; each kind's are in its traits
/// (tasks/task_kind.h). Units: bytes of the process that runs the task (peak resident set); CPU
/// seconds.
#pragma once

#include <cstdint>

#include "mesh/core/subdomain.h"
#include "store/task_time.h"
#include "tasks/task_kind.h"
#include "worker/task_io.h"

namespace tetfarm {

struct TaskCost {
  double bytes = 0;
  double seconds = 0;  ///< by the built-in terms
  TaskKind kind = TaskKind::inspect;
  TaskSize size;  ///< what the seconds depend on
};

/// The size of a sub-domain, and of what a task on it reads besides.
struct SubdomainSize {
  double elements = 0;   ///< estimated
  double triangles = 0;  ///< of its surface
  double spacing_bytes = 0;
  double needles = 0;  ///< triangles of the input surface in it with a small angle
};

/// What the memory of a task is told in.
struct MemorySize {
  double elements = 0;
  double triangles = 0;
  double spacing_bytes = 0;
  double input_bytes = 0;
  double triangles_of_largest = 0;  ///< of the largest group that is joined
};

/// By the traits of the kind. Cost: O(1).
TaskCost cost_of(TaskKind kind, const MemorySize& memory, const TaskSize& size);

/// `wall_triangles` are those on which layers are planned.
TaskCost inspect_cost(double input_bytes, const SubdomainSize& root, double wall_triangles = 0);
/// `triangles` of the given surface and of the one that is made, together.
TaskCost remesh_cost(double input_bytes, double triangles);
TaskCost decompose_cost(const SubdomainSize& size);
TaskCost mesh_cost(const SubdomainSize& size);
/// `triangles` of all leaves together, and of the largest group when joined.
TaskCost assimilate_cost(double triangles, double largest_group);
/// `triangles` of all sub-domains together, and of the largest.
TaskCost order_cost(double triangles, double largest_leaf);
/// `elements` counted.
TaskCost extract_cost(double elements, double triangles);
/// `elements` counted: of all sections that the turn reads.
TaskCost cosmetic_cost(double elements, double spacing_bytes);
TaskCost number_cost(double surface_triangles);
/// `elements` counted, of the leaf.
TaskCost write_cost(double elements);
/// `cells` counted, of the chunk.
TaskCost grow_cost(double cells);
/// `largest` is the largest sub-domain, `elements` all of them.
TaskCost assemble_cost(double surface_triangles, double elements, const SubdomainSize& largest);

/// The size of a task's sub-domain; `elements` are estimated. Cost: O(triangles).
SubdomainSize size_of(const Subdomain& subdomain, double elements, const TaskFile& spacing);

/// As numbers of the task's result: expected_bytes and expected_seconds for the job's report, and
/// size_elements, size_triangles, size_needles, from which later expectations are learnt.
void report_cost(TaskIo& io, const TaskCost& cost);

/// How many elements the cosmetic turn of a leaf reads, at most: its own near cuts and those of its
/// neighbours.
double turn_elements(const SubdomainSize& leaf);

/// The most that a task on a leaf takes: meshing it, extracting its elements near cuts, its turn.
double leaf_bytes(const SubdomainSize& leaf);

/// Triangles of all leaves together, those of cuts on both sides, when they are about cubes.
double triangles_of_leaves(const SubdomainSize& root, double parts);

/// How many leaves a sub-domain has to become for leaf_bytes to stay within `most_bytes`: 1
/// exactly when its own do. Never more than a million.
std::int64_t parts_for_memory(const SubdomainSize& size, double most_bytes);

/// The least limit that the tasks leave room for that are as large however finely is cut: reading
/// and checking the surface, cutting the root, numbering, assembling.
double least_memory(double input_bytes, const SubdomainSize& root);

}  // namespace tetfarm
