/// The kinds of tasks, and what everybody knows of them: names, what goes over the wire, colours,
/// outputs, costs. Coordinator, worker and reports look here; none has a list of its own.
///
/// What a kind reads and makes is in its own file, tasks/KIND_contract.h and .cpp, with its traits;
/// what may follow what is in coordinator/decisions/task_graph.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// A kind is a line here. In the order in which they come: a job is at the earliest that is left.
/// The first three are those of an adaptation loop, the others make a mesh of tets; `remesh` comes
/// where the job asks for it.
#define TETFARM_TASK_KINDS(KIND) \
  KIND(solve)                    \
  KIND(adapt)                    \
  KIND(collect)                  \
  KIND(remesh)                   \
  KIND(inspect)                  \
  KIND(decompose)                \
  KIND(assimilate)               \
  KIND(mesh)                     \
  KIND(order)                    \
  KIND(extract)                  \
  KIND(cosmetic)                 \
  KIND(number)                   \
  KIND(write)                    \
  KIND(grow)                     \
  KIND(assemble)

namespace tetfarm {

#define TETFARM_ENUMERATOR(kind) kind,
enum class TaskKind { TETFARM_TASK_KINDS(TETFARM_ENUMERATOR) };
#undef TETFARM_ENUMERATOR

#define TETFARM_LISTED(kind) TaskKind::kind,
inline constexpr std::array all_task_kinds = {TETFARM_TASK_KINDS(TETFARM_LISTED)};
#undef TETFARM_LISTED

/// What is believed of the CPU seconds of a kind before anything was learnt: of the fixed part, and
/// of an element, a triangle and a needle among many; and how sure each is, of its logarithm. See
/// store/task_time.h.
struct TaskSeconds {
  std::array<double, 4> of = {};
  std::array<double, 4> spreads = {0.4, 0.4, 0.4, 0.55};
};

/// The peak memory of a kind in bytes, beside that of a process: so much, and so much for each unit
/// of what its size is told in. See worker/task_cost.h.
struct TaskMemory {
  double fixed = 0;
  double of_input_byte = 0;
  double of_spacing_byte = 0;
  double of_element = 0;
  double of_triangle = 0;
  double of_triangle_of_largest = 0;  ///< of the largest group that is joined
};

struct TaskKindTraits {
  const char* name = "";
  std::uint32_t on_wire = 0;      ///< not 0; that of a kind that is no more is never given again
  int rank = 1;                   ///< the lowest is handed out first
  const char* colour = "";        ///< of charts, "#rrggbb"
  const char* trace_colour = "";  ///< a name that Chrome's trace viewer knows
  /// That every result has. One that ends in ':' is there once for each input that ends in a heap
  /// number.
  std::array<std::string_view, 4> outputs = {};
  bool may_make_nothing = false;  ///< no output at all is a result, too
  TaskSeconds seconds = {};
  TaskMemory memory = {};
  // Limits.
  bool shrinks_with_leaf = false;   ///< out of memory, it is helped by cutting its leaf once more
  bool needs_whole_tree = false;    ///< and starts anew when a leaf is cut
  bool reads_file_by_file = false;  ///< one after the other: what it has freed it needs again
  bool is_of_others = false;  ///< a program of somebody else's, of which no time can be expected
  // What it is to its job.
  bool is_of_cycle = false;  ///< its path is the number of a cycle, not that of a sub-domain
  bool begins_job = false;   ///< what it is given may have come with the job
  bool ends_job = false;     ///< what it makes is what the job delivers
};

const TaskKindTraits& traits_of(TaskKind kind);
const char* name_of(TaskKind kind);
/// Nothing where no kind has that name.
std::optional<TaskKind> task_kind_named(std::string_view name);
/// Nothing where no kind that this program knows has that number.
std::optional<TaskKind> task_kind_on_wire(std::uint32_t number);

}  // namespace tetfarm
