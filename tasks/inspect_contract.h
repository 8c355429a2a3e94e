/// The contract of inspect: reads and checks the surface, and says what the job will come to.
#pragma once

#include <cstdint>
#include <optional>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct InspectGiven {
  TaskFile job;
  std::optional<TaskFile> input_surface;
  std::optional<std::uint64_t>
      free_bytes;  ///< of the disk for this job, told with the assignment; never kept
  std::optional<TaskFile> remeshed_surface = {};  ///< in place of `input_surface`

  static constexpr TaskKind kind = TaskKind::inspect;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct InspectMade {
  TaskFile surface;
  TaskFile spacing;
  TaskFile root;                 ///< the whole domain as a sub-domain, but for its layers
  TaskFile settings;             ///< the job file without what makes no difference to a sub-domain
  std::uint64_t parts = 0;       ///< sub-domains that the root is to become, at least 1
  double total_work = 0;         ///< estimated elements
  std::uint64_t groups = 0;      ///< of leaves, to be joined; 0: none are
  std::uint64_t most_bytes = 0;  ///< memory of a task; 0: it does not decide
  std::uint64_t needles = 0;     ///< triangles with a small angle
  bool across_cuts = false;      ///< whether there are turns of cosmetics
  // Of a job with layers, where `root` is what they leave of the domain:
  LeafFiles layers;                     ///< the chunks of the layers
  std::optional<TaskFile> layer_table;  ///< their lines of the numbering's table, and the root's
  std::optional<TaskFile> layer_map;    ///< for people: what each triangle of the wall has
  std::optional<TaskFile> top_heights;  ///< of the last prisms below the triangles of the top

  static constexpr TaskKind kind = TaskKind::inspect;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
