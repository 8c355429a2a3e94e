/// The tasks of cosmetics across cuts, between meshing and numbering.
///
/// Once the tree is whole: order. Each leaf that is meshed and has its order: extract. A leaf has
/// its turn (cosmetic) when it is extracted, its neighbours of lower colour had their turn, and
/// those of higher colour are extracted: no turn waits for another colour as a whole.
///
/// Source: thesis 4.3.4.1, figs. 82 and 83, as a graph instead of rounds.
/// The files and numbers of each kind of task are listed in proto/protocol.md.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "store/rows.h"
#include "tasks/number_contract.h"
#include "tasks/write_contract.h"

namespace tetfarm {

/// When a leaf has its turn, and which leaves share nodes with it.
struct Turn {
  std::int32_t colour = 0;
  std::vector<std::uint64_t> neighbours;  ///< by rising heap number
};

/// The turns of all leaves, by heap number.
using TurnOrder = std::map<std::uint64_t, Turn>;

/// From the text of an order task; nothing when it is not well-formed, a neighbour does not know
/// its neighbour, or two of them have one colour.
std::optional<TurnOrder> turn_order_of(const std::string& text);

/// Whether the job asks for cosmetics across cuts, and has cuts.
/// @pre `inspect` is done; `tree` is the whole tree, nothing in it is open.
bool has_seam_cosmetics(const TaskRow& inspect, std::span<const SubdomainRow> tree);

/// @pre as has_seam_cosmetics, which holds.
TaskRow order_task(const TaskRow& inspect, std::span<const SubdomainRow> tree);

/// @pre `order` and `mesh` are done; `mesh` is that of the leaf.
TaskRow extract_task(const TaskRow& order, const TaskRow& mesh);

/// The task of that kind and leaf, if its outputs are known; null otherwise.
using FindDone = std::function<const TaskRow*(TaskKind kind, std::uint64_t leaf)>;

/// The turn of a leaf; nothing as long as it has to wait.
/// @pre `order` is done; `turns` are its.
std::optional<TaskRow> cosmetic_task(const TaskRow& inspect, const TurnOrder& turns,
                                     std::uint64_t leaf, const FindDone& find);

/// What number needs after the last turn: the order and the files of all leaves.
/// @pre every leaf had its turn.
void add_elements(const TaskRow& order, const TurnOrder& turns, const FindDone& find,
                  NumberGiven& number);

/// The files that the elements of a leaf are in after the last turn: its own and those of its
/// neighbours. @pre every leaf had its turn.
void add_final_elements(std::uint64_t leaf, const TurnOrder& turns, const FindDone& find,
                        WriteGiven& write);

}  // namespace tetfarm
