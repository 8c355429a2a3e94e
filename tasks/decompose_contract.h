/// The contract of decompose: cuts a sub-domain in two.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

struct DecomposeGiven {
  TaskFile job;  ///< the settings
  TaskFile subdomain;
  TaskFile spacing;
  std::uint64_t left_parts = 0;
  std::uint64_t right_parts = 0;
  std::uint64_t work = 0;                   ///< estimated elements
  std::optional<std::uint64_t> most_bytes;  ///< where memory decides
  std::optional<std::uint64_t> needles;     ///< if it has any

  static constexpr TaskKind kind = TaskKind::decompose;
  static constexpr ContractSide side = ContractSide::given;
  void describe(ContractFields& fields);
};

/// Two halves; or none and why it stays whole.
struct DecomposeMade {
  struct Half {
    TaskFile file;
    double work = 0;                     ///< estimated elements
    std::optional<std::uint64_t> parts;  ///< that it is to become, where not as was given
    std::uint64_t needles = 0;
  };
  struct Halves {
    Half left;
    Half right;
    std::uint64_t interdomain_nodes = 0;  ///< of the cut between them
  };
  std::optional<Halves> halves;
  std::optional<std::string> reason;

  static constexpr TaskKind kind = TaskKind::decompose;
  static constexpr ContractSide side = ContractSide::made;
  void describe(ContractFields& fields);
};

}  // namespace tetfarm
