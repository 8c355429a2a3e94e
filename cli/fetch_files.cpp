#include "cli/fetch_files.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/file_system.h"
#include "base/ids.h"
#include "store/artifact_store.h"
#include "store/disk_room.h"
#include "store/folder_lock.h"
#include "worker/file_receive.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

class ResultFetch : public PieceExchange {
 public:
  ResultFetch(std::string job, const fs::path& growing, const StoredArtifact& file)
      : job_(std::move(job)), receive_(growing, file) {}

  const FileReceive& receive() const { return receive_; }
  bool is_complete() const override { return receive_.state() != FileReceive::State::coming; }
  void ask_again() override { receive_.ask_again(); }

  std::vector<wire::Envelope> due(std::int64_t now_ms) override {
    std::vector<wire::Envelope> messages;
    while (const auto offset = receive_.next(now_ms)) {
      wire::FetchFile& fetch = *messages.emplace_back().mutable_fetch_file();
      fetch.set_task(parse_job_name(job_).value);
      fetch.set_hash(receive_.file().hash);
      fetch.set_offset(*offset);
    }
    return messages;
  }

  bool take(const wire::Envelope& message, std::int64_t now_ms) override {
    return message.has_file_chunk() && receive_.take(message.file_chunk(), now_ms);
  }

 private:
  std::string job_;
  FileReceive receive_;
};

/// A file that is to come, and where it goes.
struct Wanted {
  wire::Artifact file;
  fs::path target;
  fs::path growing;
};

bool is_whole(const fs::path& path, const wire::Artifact& file) {
  return size_of_file(path) == file.size() && checksum_of_file(path).hash == file.hash();
}

/// Names come over the network: only their last part counts.
std::vector<Wanted> wanted_of(const wire::JobStatus& status, const fs::path& folder) {
  std::vector<Wanted> wanted;
  for (const wire::Artifact& file : status.files()) {
    const fs::path name = fs::path(file.name()).filename();
    if (name.empty() || name == "." || name == "..") continue;
    if (!ArtifactStore::is_hash(file.hash())) continue;
    wanted.push_back({file, folder / name, folder / ("." + file.hash() + ".part")});
  }
  return wanted;
}

void want_room(const fs::path& folder, std::uint64_t bytes, const std::string& job) {
  const DiskRoom room = disk_room(fs::absolute(folder));
  if (room.has(bytes)) return;
  throw Error(ExitCode::out_of_resources, folder.string() + ": the files of " + job + " need " +
                                              bytes_text(bytes) + ", but the disk has only " +
                                              bytes_text(room.free_bytes) + " free");
}

/// Bytes that were there before may have been lost with the power: then all of it comes anew, once.
FileReceive::State fetch(CoordinatorConnection& connection, const std::string& job,
                         const Wanted& wanted, const FetchOptions& options,
                         TransferDisplay& display) {
  const std::string what = "fetching " + wanted.target.filename().string();
  while (true) {
    ResultFetch files(job, wanted.growing, {wanted.file.hash(), wanted.file.size()});
    connection.exchange(files, options.timeout_ms,
                        [&] { display.show(what, files.receive().there(), wanted.file.size()); });
    const FileReceive::State state = files.receive().state();
    if (state != FileReceive::State::damaged || files.receive().found() == 0) return state;
    fs::resize_file(wanted.growing, 0);
  }
}

/// @throws Error unless it came and is what it should be.
void expect_whole(FileReceive::State state, const Wanted& wanted, const std::string& job) {
  const std::string name = wanted.target.filename().string() + " of " + job;
  if (state == FileReceive::State::missing) {
    throw Error(ExitCode::not_found, name + " is no longer in the coordinator's store");
  }
  if (state == FileReceive::State::damaged) {
    throw CorruptFile("is damaged in the coordinator's store: its checksum is not " +
                          wanted.file.hash() +
                          " (`tetfarm check --store DIR` on its machine says more)",
                      name);
  }
}

void fetch_to_its_place(CoordinatorConnection& connection, const std::string& job,
                        const Wanted& wanted, const FetchOptions& options,
                        TransferDisplay& display) {
  const auto lock = FolderLock::take_unsigned(wanted.growing);
  if (!lock) {
    throw Error(
        ExitCode::failed,
        wanted.target.string() + ": another process is fetching it; wait until that has ended");
  }
  const FileReceive::State state = fetch(connection, job, wanted, options, display);
  if (state != FileReceive::State::whole) remove_file(wanted.growing);
  expect_whole(state, wanted, job);
  publish_by_rename(wanted.growing, wanted.target);
}

}  // namespace

std::vector<fs::path> fetch_files(CoordinatorConnection& connection, const wire::JobStatus& status,
                                  const fs::path& folder, const FetchOptions& options) {
  make_folders(folder);
  std::vector<fs::path> files;
  std::vector<Wanted> to_come;
  std::uint64_t bytes = 0;
  for (Wanted& wanted : wanted_of(status, folder)) {
    files.push_back(wanted.target);
    if (is_whole(wanted.target, wanted.file)) continue;
    const std::uint64_t there = size_of_file(wanted.growing).value_or(0);
    bytes += wanted.file.size() - std::min(there, wanted.file.size());
    to_come.push_back(std::move(wanted));
  }
  if (!to_come.empty()) want_room(folder, bytes, status.job());
  TransferDisplay display(options.progress);
  for (const Wanted& wanted : to_come) {
    fetch_to_its_place(connection, status.job(), wanted, options, display);
  }
  return files;
}

PassingFile fetch_for_a_while(CoordinatorConnection& connection, const wire::JobStatus& status,
                              const wire::Artifact& file, const fs::path& folder,
                              const FetchOptions& options) {
  want_room(folder, file.size(), status.job());
  PassingFile passing(folder);
  const Wanted wanted{file, fs::path(file.name()).filename(), passing.path()};
  TransferDisplay display(options.progress);
  expect_whole(fetch(connection, status.job(), wanted, options, display), wanted, status.job());
  return passing;
}

}  // namespace tetfarm
