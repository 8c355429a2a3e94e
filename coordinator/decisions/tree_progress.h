/// How far the tree of each job is: counts of its sub-domains and of what is done with them, so
/// that the next step is known without a look at the whole tree.
///
/// Invariants, checked by validate():
///  1. Sub-domains are counted as their rows say.
///  2. No more leaves are written, and chunks of layers grown, than there are.
///  3. No more turns are over than there are.
/// Cost: O(log jobs), where it is not said.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/decisions/cosmetic_graph.h"
#include "store/rows.h"

namespace tetfarm {

class TreeProgress {
 public:
  /// A row is there, or is there no more; one that changes is taken away and added.
  void add(const SubdomainRow& subdomain) { count(subdomain, 1); }
  void take_away(const SubdomainRow& subdomain) { count(subdomain, -1); }
  /// So many chunks of layers are to be grown.
  void set_chunks(JobId job, std::size_t chunks) {
    jobs_[job].chunks = static_cast<std::int64_t>(chunks);
  }
  /// There is, or was, the portion of one more leaf or chunk.
  void note_written(JobId job) { ++jobs_[job].written; }
  void note_turn_over(JobId job) { ++jobs_[job].turns_over; }
  /// @pre the job has no order of turns.
  const TurnOrder& set_turns(JobId job, TurnOrder turns);
  /// The order is another: all have their turn once more.
  void start_turns_anew(JobId job);
  /// A leaf for which there was no memory: it is cut further.
  void note_former_leaf(JobId job, std::uint64_t path) { jobs_[job].former_leaves.insert(path); }
  void forget(JobId job) { jobs_.erase(job); }

  /// Whether some sub-domain is still to be cut.
  bool has_open(JobId job) const { return of(job).open > 0; }
  /// Whether none is still to be cut or meshed.
  bool is_settled(JobId job) const { return of(job).unsettled == 0; }
  bool is_written(JobId job) const { return of(job).written >= of(job).leaves + of(job).chunks; }
  /// Null while nobody has set it.
  const TurnOrder* turns(JobId job) const;
  /// @pre the job has an order of turns.
  bool had_all_turns(JobId job) const;
  /// How many of those that the sub-domain lies below were leaves once. Cost: O(depth · log leaves)
  std::uint32_t former_leaves_above(JobId job, std::uint64_t path) const;

  /// The broken invariants, in words; empty when all is well. Cost: O(sub-domains).
  std::vector<std::string> validate(const std::map<SubdomainKey, SubdomainRow>& subdomains) const;

 private:
  struct OfJob {
    std::int64_t unsettled = 0;  ///< sub-domains still to be cut or meshed
    std::int64_t open = 0;       ///< sub-domains still to be cut
    std::int64_t leaves = 0;
    std::int64_t chunks = 0;  ///< of layers
    std::int64_t written = 0;
    std::int64_t turns_over = 0;
    std::optional<TurnOrder> turns = {};
    std::set<std::uint64_t> former_leaves = {};
  };

  void count(const SubdomainRow& subdomain, std::int64_t change);
  const OfJob& of(JobId job) const;

  std::map<JobId, OfJob> jobs_;
};

}  // namespace tetfarm
