/// Which tasks a job is made of: what a finished task brings into being.
///
/// remesh, where the job asks for it → inspect → a decomposition tree of decompose tasks → one mesh
/// task per leaf → number → one write task per leaf → assemble; before number the tasks of
/// cosmetics across cuts (cosmetic_graph.h), where the job asks for it. Where the job asks for
/// assimilation, the leaves are joined before they are meshed (assimilation_graph.h). Layers are
/// grown beside the write tasks (layer_graph.h). The graph is a pure function of results; the order
/// in which they arrive does not matter.
///
/// Source: thesis 4.3 and fig. 73, as a graph instead of rounds with a barrier.
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

/// Sub-domains below this heap number may still be cut: their children's numbers fit in 63 bits.
inline constexpr std::uint64_t deepest_cut = std::uint64_t{1} << 61U;

/// What a worker says about a finished task.
struct TaskResult {
  std::vector<ArtifactRef> outputs;
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
  double seconds = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::string log;  ///< of the attempt, for people
};

/// Rows that a finished task brings into being or changes. New tasks have no id yet.
struct GraphStep {
  std::vector<SubdomainRow> subdomains;
  std::vector<TaskRow> tasks;
};

/// What is wrong with a result: a missing output, leaves in no group. Nothing when it is
/// usable.
std::optional<std::string> problem_with(const TaskRow& task, const TaskResult& result);

/// What inspects the remeshed surface. @pre `remesh` is done and without problem.
TaskRow inspect_task(const TaskRow& remesh);

/// @pre `inspect` is done and without problem.
TaskRow mesh_task(const TaskRow& inspect, const SubdomainRow& leaf);

/// The root sub-domain and what to do with it. @pre `inspect` is done and without problem.
GraphStep after_inspect(const TaskRow& inspect);

/// The two halves of a cut, or the sub-domain as a leaf where it could not be cut. Leaves are
/// meshed at once where they are not assimilated, or where that is over: `is_further`.
/// @pre `decompose` is done and without problem; `parent` is its sub-domain.
GraphStep after_decompose(const TaskRow& inspect, const TaskRow& decompose,
                          const SubdomainRow& parent, bool is_further);

/// A leaf that is to be cut once more, and what does it: its halves are leaves.
/// @pre it has no decompose task yet, and its heap number is below deepest_cut.
GraphStep cut_once_more(const TaskRow& inspect, const SubdomainRow& leaf);

/// The leaf with the figures of its volume mesh.
SubdomainRow after_mesh(const TaskRow& mesh, SubdomainRow leaf);

/// Whether nothing more has to be found out about a sub-domain before the nodes can be numbered.
bool is_settled(const SubdomainRow& subdomain);

/// What the nodes are numbered from; after cosmetics across cuts add_elements (cosmetic_graph.h)
/// adds the rest. @pre `tree` is the whole tree by rising heap number, all of it settled;
/// `assimilate` is done, or null where the job has none.
NumberGiven given_to_number(const TaskRow& inspect, const TaskRow* assimilate,
                            std::span<const SubdomainRow> tree);

/// What gives the elements of a leaf their global numbers, as far as it is the same for all leaves:
/// add_mesh and, after cosmetics across cuts, add_final_elements (cosmetic_graph.h) add the leaf's
/// own files. @pre `number` is done and without problem.
WriteGiven given_to_write(const TaskRow& inspect, const TaskRow& number);

/// @pre `mesh` is that of the leaf, done and without problem.
void add_mesh(const TaskRow& mesh, WriteGiven& write);

/// The write task of a leaf, or the grow task of a chunk.
using FindWritten = std::function<const TaskRow*(std::uint64_t leaf)>;

/// @pre the write task of every leaf of `tree` and the grow task of every chunk of layers is done
/// and without problem: `find_written` and `find_grown` find it.
TaskRow assemble_task(const TaskRow& inspect, const TaskRow& number,
                      std::span<const SubdomainRow> tree, const FindWritten& find_written,
                      const FindWritten& find_grown);

}  // namespace tetfarm
