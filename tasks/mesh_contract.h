/// The contract of mesh: the tets of a leaf.
#pragma once

#include <cstdint>
#include <optional>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct MeshGiven {
  TaskFile job;  ///< the settings
  TaskFile subdomain;
  TaskFile spacing;
  std::uint64_t work = 0;                ///< estimated elements
  std::optional<std::uint64_t> needles;  ///< if it has any

  static constexpr TaskKind kind = TaskKind::mesh;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

struct MeshMade {
  TaskFile mesh;
  std::uint64_t interior_nodes = 0;
  std::uint64_t tets = 0;

  static constexpr TaskKind kind = TaskKind::mesh;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
