/// What is done with the store's files for workers and clients that do not see it, chunk by chunk;
/// and looking whether a file is damaged, as a worker says.
///
/// An order is carried out by the thread of files (file_thread.h): reading, writing and syncing a
/// file must not make the others wait. A file that comes lies in the store's scratch folder, under
/// the name of its attempt or its client, until all of it is there and has been checked; what is
/// there of it when a connection or the coordinator is lost is gone on from.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "store/rows.h"

namespace tetfarm {

struct FileOrder {
  enum class Kind {
    read,    ///< the chunk at `offset`
    open,    ///< how much of the offered file is there already?
    append,  ///< the chunk behind what is there
    drop,    ///< the file will not be finished
    clear,   ///< the attempt is over: what it left in its scratch folder
    forget,  ///< the worker is gone: its probe, named by the hash of `file`
    check    ///< is it what its name says? A damaged one is put aside
  };
  Kind kind = Kind::read;
  std::string connection;
  std::string client = {};  ///< "": of a worker; else of a client, by the hash of its key
  TaskId task;
  AttemptId attempt;
  StoredArtifact file;
  std::uint64_t offset = 0;
  wire::FileChunk chunk;  ///< of append
};

/// What became of a check.
struct CheckedFile {
  enum class Verdict {
    sound,
    damaged,  ///< or missing
    unknown   ///< it is damaged, but could not be put aside
  };
  AttemptId attempt;
  std::string hash;
  Verdict verdict = Verdict::unknown;
};

struct FileAnswer {
  std::string connection;
  std::string client = {};  ///< as in the order
  wire::Envelope envelope;  ///< without a body: nothing to say
  std::string trouble;      ///< for the log
  bool is_out_of_room = false;
  std::optional<CheckedFile> checked = {};
};

/// Never throws: a failing disk is an answer. Cost: a chunk in memory; the last chunk of a file is
/// followed by one pass over all of it, and a check is one.
FileAnswer carry_out(const FileOrder& order, const ArtifactStore& store) noexcept;

/// Removes what came of files for other attempts than these. @throws IoError.
void drop_uploads_but(const std::set<AttemptId>& running, const ArtifactStore& store);

/// A client's surface of which a part has come.
struct BegunSurface {
  std::string client;
  std::string hash;
  friend auto operator<=>(const BegunSurface&, const BegunSurface&) = default;
};
/// Those in the store's scratch folder.
std::vector<BegunSurface> begun_surfaces(const ArtifactStore& store);
/// Where one grows.
std::filesystem::path surface_path(const ArtifactStore& store, const std::string& client,
                                   const std::string& hash);

/// Where a file of the attempt grows.
std::filesystem::path upload_path(const ArtifactStore& store, AttemptId attempt,
                                  const std::string& hash);

}  // namespace tetfarm
