/// Numbers in the whole mesh for the nodes of a decomposed OpenFOAM case, which has none: nodes of
/// two processors are one where the faces between them say so.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/core/face_nodes.h"

namespace tetfarm {

/// The faces towards another processor: they come in the same order there, turned round, and begin
/// with the same node.
struct ProcessorPatch {
  std::int32_t neighbour = 0;
  std::vector<FaceNodes<std::int32_t>> faces;
};

/// Numbers go by processor, then by the node's number there; a node has that of the first processor
/// which has it. In memory: 20 bytes a node on faces between processors, and those faces.
/// Cost: O(n log n) in them.
class ProcessorNumbers {
 public:
  explicit ProcessorNumbers(std::string name) : name_(std::move(name)) {}

  /// Processors 0, 1, …; @throws InvalidInput when two do not fit. @pre nodes are below `nodes`.
  void add(std::int64_t nodes, const std::vector<ProcessorPatch>& patches);
  /// After the last. @throws InvalidInput when a side is missing, or two nodes of a processor
  /// are one.
  void finish();
  /// Of each node of the processor its number in the whole mesh.
  std::vector<std::int64_t> local2global(std::size_t processor) const;

 private:
  /// Of the nodes on faces between processors: its i-th has the id first_id + i.
  struct Processor {
    std::int64_t nodes = 0;
    std::int64_t first_number = 0;
    std::vector<std::int32_t> shared;  ///< ascending
    std::size_t first_id = 0;
  };
  using Ids = FaceNodes<std::int64_t>;  ///< of the nodes of a face

  std::vector<Ids> ids_of(const Processor& processor, const ProcessorPatch& patch) const;
  std::size_t root_of(std::size_t id);
  void unite(std::size_t a, std::size_t b);
  void join(std::int32_t lower, std::int32_t higher, const std::vector<Ids>& here);
  void number(Processor& processor, std::int64_t& next);
  [[noreturn]] void refuse(std::int32_t a, std::int32_t b, const std::string& what) const;

  std::string name_;
  std::vector<Processor> processors_;
  std::vector<std::size_t> parent_;   ///< of each id one that is not higher
  std::vector<std::int64_t> number_;  ///< of each id
  /// Of a pair, the lower first: the faces of the lower until the higher comes.
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<Ids>> waiting_;
};

}  // namespace tetfarm
