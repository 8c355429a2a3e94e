/// Which chunks of files go to and come from clients that do not see the store: results of jobs,
/// and the surfaces of jobs to be submitted.
///
/// Without I/O: messages go in, orders for the thread of files come out. A client gets the files
/// that the status of the job that it names tells of, and nothing else of the store. A surface lies
/// under the key of its sender until it is whole, so that nobody spoils another's. Workers come
/// first: fewer clients are served at once, with less under way each.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/file_orders.h"
#include "coordinator/order_lines.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// The largest surface that a client may bring.
inline constexpr std::uint64_t max_brought_bytes = std::uint64_t{2} << 30U;

struct ClientFileLimits {
  LineLimits lines = {.served = 8, .under_way = 4};
  std::size_t surfaces = 32;           ///< begun ones at once
  std::size_t surfaces_of_client = 8;  ///< the same of one client
  std::int64_t kept_ms = 3'600'000;    ///< a begun one of which no more comes
};

/// Who asks: the connection, and a name made of the key, which stays when the client comes back.
struct ClientSender {
  std::string connection;
  std::string client;
};
/// The name of a client with this key; "": none, as all have over plain connections.
std::string client_name(const std::string& key);

class ClientFiles {
 public:
  explicit ClientFiles(const ClientFileLimits& limits = {})
      : limits_(limits), lines_(limits.lines) {}

  /// The files that are a job's to give; nothing when there is no such job.
  using FilesOfJob = std::function<std::optional<std::vector<StoredArtifact>>(JobId)>;
  /// @throws Error (not_found) for a file that is none of the job's, UsageError for an offset
  /// within a chunk.
  void fetch(const ClientSender& sender, const wire::FetchFile& message,
             const FilesOfJob& files_of_job, Moment now);
  /// @throws UsageError when it is too large or no file can be named so, Error (out_of_resources)
  /// when there are too many.
  void offer(const ClientSender& sender, const wire::OfferFile& message, Moment now);
  /// False when it was not offered over this connection: it will be offered again.
  bool append(const ClientSender& sender, const wire::FileChunk& message, Moment now);

  /// What the thread of files shall do now. A begun surface of which no more comes is dropped.
  std::vector<FileOrder> take_orders(Moment now);
  /// An order of a client was carried out.
  void note_answer(const FileAnswer& answer);

  /// Orders that wait or are under way are no more: who wants them carried out says so again.
  void forget_connections() { lines_.clear(); }

  /// What was begun before a restart.
  void remember(const std::vector<BegunSurface>& begun, Moment now);

 private:
  struct Upload {
    std::string connection;  ///< that may send its chunks
    std::uint64_t size = 0;
    std::int64_t heard_ms = 0;
  };
  /// Asked for by a connection, and looked up already.
  struct Granted {
    JobId job;
    StoredArtifact file;
    std::int64_t heard_ms = 0;
  };
  void drop_silent(Moment now, std::vector<FileOrder>& orders);

  ClientFileLimits limits_;
  OrderLines lines_;
  std::map<std::string, Granted> granted_;
  std::map<BegunSurface, Upload> uploads_;
};

}  // namespace tetfarm
