/// What a running task sees of the world: what it was given, and a place for what it makes.
///
/// Both are the contracts of its kind (tasks/KIND_contract.h): given() is the one, and made() takes
/// the other; beside it there may be figures for people. Files are checked against their checksums
/// when read; outputs are published at once, under the checksum of their bytes, so that a task that
/// fails later leaves nothing but unused files.
#pragma once

#include <bitset>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/work_progress.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"
#include "tasks/task_contract.h"
#include "tasks/task_kind.h"

namespace tetfarm {

/// An end for good, together with files that show why; the runner publishes them.
class TaskRefusal : public Error {
 public:
  struct File {
    std::string name;
    std::string bytes;
  };
  TaskRefusal(ExitCode code, const std::string& message, std::vector<File> evidence)
      : Error(code, message), evidence_(std::move(evidence)) {}
  const std::vector<File>& evidence() const { return evidence_; }

 private:
  std::vector<File> evidence_;
};

/// The input is bad.
class RefusedInput : public TaskRefusal {
 public:
  RefusedInput(const std::string& message, std::vector<File> evidence)
      : TaskRefusal(ExitCode::bad_geometry, message, std::move(evidence)) {}
};

/// The input is good, and Tetfarm fails at it each time.
class OwnDefect : public TaskRefusal {
 public:
  OwnDefect(const std::string& message, std::vector<File> evidence)
      : TaskRefusal(ExitCode::failed, message, std::move(evidence)) {}
};

/// An input that is missing or not what its checksum says: the task that made it has to run again.
class DamagedInput : public Error {
 public:
  DamagedInput(const std::string& message, std::string hash)
      : Error(ExitCode::failed, message), hash_(std::move(hash)) {}
  const std::string& hash() const { return hash_; }

 private:
  std::string hash_;
};

/// What `look` returns; damage and absence of the file become DamagedInput.
template <class Look>
auto checked_input(const TaskFile& file, const Look& look) {
  try {
    return look();
  } catch (const CorruptFile& error) {
    throw DamagedInput(error.what(), file.hash);
  } catch (const IoError& error) {
    if (error.code() != ExitCode::not_found) throw;
    throw DamagedInput(error.what(), file.hash);
  }
}

/// That of the leaf. @throws Error when it has none.
const TaskFile& file_of_leaf(const LeafFiles& files, std::uint64_t heap);

/// What a task is given, as it travels.
TaskWords given_words(const wire::Assign& assign);

class TaskIo {
 public:
  using Say = std::function<void(const wire::Doing&)>;

  TaskIo(const ArtifactStore& store, const wire::Assign& assign, Say say,
         bool is_without_shared_store = false);
  TaskIo(const TaskIo&) = delete;
  TaskIo& operator=(const TaskIo&) = delete;

  /// What the task was given. @throws OwnDefect where that is not its contract.
  template <class Given>
  Given given() const {
    ContractReading<Given> reading = from_words<Given>(given_words(assign_));
    require_no_breach(Given::kind, reading.breach);
    return std::move(reading.contract);
  }
  /// What it has made; once. Its files are published.
  template <class Made>
  void made(const Made& made) {
    add(to_words(made));
  }

  /// The checked bytes of an input. @throws DamagedInput.
  std::string read(const TaskFile& file) const;
  /// What `parse` makes of them and of the input's name. @throws DamagedInput; what `parse` throws.
  template <class Parse>
  auto read(const TaskFile& file, const Parse& parse) const {
    return parse(read(file), name_of(file));
  }
  /// The name of an input, for messages; of files of the same bytes the last one's.
  std::string name_of(const TaskFile& file) const;
  /// Where the checked file of an input lies, for readers of their own. @throws DamagedInput.
  std::filesystem::path path(const TaskFile& file) const;
  /// What `look` returns, called with the path of the input, for readers that read a part of a
  /// file and check what they read. Damage and absence become DamagedInput. @throws what `look`
  /// throws.
  template <class Look>
  auto look_into(const TaskFile& file, const Look& look) const {
    return checked_input(file, [&] { return look(store_.path_of(file.hash)); });
  }
  const wire::Assign& assign() const { return assign_; }
  /// Whether no other task sees this store.
  bool is_without_shared_store() const { return is_without_shared_store_; }

  TaskFile publish(std::string_view bytes);

  // For people, beside the contract.
  void publish(const std::string& name, std::string_view bytes);
  /// As publish, of a finished file in the store's scratch folder, which is moved.
  void publish_file(const std::string& name, const std::filesystem::path& path);
  /// The same of a file whose checksum is known.
  void publish_checked_file(const std::string& name, const std::filesystem::path& path,
                            const StoredArtifact& known);
  void number(const std::string& name, double value);
  void text(const std::string& name, const std::string& value);

  /// What the task counts its work on; each new stage is passed on, and otherwise a few counts a
  /// second.
  const WorkProgress& progress() const { return progress_; }

  /// Where a file in the making may lie: in a folder of the attempt's own, which is made now and
  /// goes with the attempt, however that ends. Asked twice for one name it says the same. @throws
  /// IoError.
  std::filesystem::path scratch_path(const std::string& name) const;

  const ArtifactStore& store() const { return store_; }
  const wire::Done& done() const { return done_; }

 private:
  static void require_no_breach(TaskKind kind, const std::string& breach);
  void add(const TaskWords& made);
  void pass_on(const WorkCount& count);

  const ArtifactStore& store_;
  const wire::Assign& assign_;
  std::map<std::string_view, const wire::Artifact*> hash2input_;
  Say say_;
  wire::Done done_;
  WorkProgress progress_;
  std::bitset<work_stages> said_stages_;
  std::chrono::steady_clock::time_point last_said_;
  bool is_without_shared_store_;
};

}  // namespace tetfarm
