/// What workers that are gone have left in the store's scratch folder, and nobody will use: their
/// probes, and the files that their attempts had in the making.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "coordinator/file_orders.h"
#include "store/rows.h"

namespace tetfarm {

class Leftovers {
 public:
  /// The worker's probe was found under that name. One process may be several workers, one after
  /// the other, with one probe.
  void note_probe(WorkerId worker, const std::string& name) { probes_[worker] = name; }

  /// What to remove now that these changes are durable. Cost: O(changes), and O(workers) for each
  /// that is gone.
  std::vector<FileOrder> orders_after(const ChangeSet& changes);

  /// All workers are unknown again and will say Hello.
  void forget_workers() { probes_.clear(); }

 private:
  std::map<WorkerId, std::string> probes_;
};

}  // namespace tetfarm
