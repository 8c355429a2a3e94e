/// Which chunks of files go to and come from workers that do not see the store, and when.
///
/// Without I/O: messages go in, orders for the thread of files come out. Only the worker that holds
/// an attempt may fetch the inputs of its task and bring files for it; when the attempt is over,
/// what came of unfinished files is dropped. Memory is bounded: at most `most_transfers` workers
/// are served at once, each with at most `chunks_at_once` chunks under way; the others wait in the
/// order in which they asked.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "coordinator/decisions/job_state.h"
#include "coordinator/file_orders.h"
#include "coordinator/order_lines.h"
#include "proto/messages.pb.h"

namespace tetfarm {

class FileTransfers {
 public:
  explicit FileTransfers(std::size_t most_transfers = 32) : lines_({.served = most_transfers}) {}

  /// FetchFile, OfferFile or FileChunk of a worker that the state knows. False when it makes no
  /// sense.
  bool take(const std::string& connection, WorkerId worker, const wire::Envelope& message,
            const JobState& state, Moment now);

  /// What the thread of files shall do now. Whoever is served and silent for a while makes room.
  std::vector<FileOrder> take_orders(const JobState& state, Moment now);

  /// An order of that connection was carried out.
  void note_answer(const std::string& connection) { lines_.note_answer(connection); }

  /// All connections are unknown again. What came of files stays for who comes back.
  void forget_connections() { lines_.clear(); }

 private:
  void drop_finished(const JobState& state, std::vector<FileOrder>& orders);

  OrderLines lines_;
  std::map<AttemptId, std::map<std::string, std::uint64_t>> uploads_;  ///< hash to size
};

}  // namespace tetfarm
