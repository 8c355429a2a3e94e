/// What a running task sees of the world: its inputs, its parameters, a place for its outputs.
///
/// Inputs are checked against their checksums when read; outputs are published at once, under the
/// checksum of their bytes, so that a task that fails later leaves nothing but unused files.
#pragma once

#include <bitset>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/work_progress.h"
#include "proto/messages.pb.h"
#include "store/artifact_store.h"

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

/// What `look` returns; damage and absence of the artifact become DamagedInput.
template <class Look>
auto checked_input(const wire::Artifact& artifact, const Look& look) {
  try {
    return look();
  } catch (const CorruptFile& error) {
    throw DamagedInput(error.what(), artifact.hash());
  } catch (const IoError& error) {
    if (error.code() != ExitCode::not_found) throw;
    throw DamagedInput(error.what(), artifact.hash());
  }
}

class TaskIo {
 public:
  using Say = std::function<void(const wire::Doing&)>;

  TaskIo(const ArtifactStore& store, const wire::Assign& assign, Say say, bool is_apart = false);
  TaskIo(const TaskIo&) = delete;
  TaskIo& operator=(const TaskIo&) = delete;

  /// The checked bytes of the input of that name. @throws DamagedInput; Error when the task has no
  /// such input.
  std::string read(const std::string& name) const;
  bool has_input(const std::string& name) const;
  /// The checksum that names it. @throws Error when the task has no such input.
  std::string input_hash(const std::string& name) const { return input(name).hash(); }
  /// 0 when the task has no such input.
  std::uint64_t input_size(const std::string& name) const;
  /// Where the checked file of that input lies, for readers of their own. @throws as read does.
  std::filesystem::path path(const std::string& name) const;
  /// What `look` returns, called with the path of that input, for readers that read a part of a
  /// file and check what they read. Damage and absence become DamagedInput. @throws what `look`
  /// throws.
  template <class Look>
  auto look_into(const std::string& name, const Look& look) const;
  const wire::Assign& assign() const { return assign_; }
  /// Whether no other task sees this store.
  bool is_apart() const { return is_apart_; }

  bool has_parameter(const std::string& name) const;
  /// @throws Error when the parameter is missing.
  std::string parameter(const std::string& name) const;
  std::int64_t whole_parameter(const std::string& name) const;

  void publish(const std::string& name, std::string_view bytes);
  /// As publish, of a finished file in the store's scratch folder, which is moved.
  void publish_file(const std::string& name, const std::filesystem::path& path);
  /// The same of a file whose checksum is known.
  void publish_checked_file(const std::string& name, const std::filesystem::path& path,
                            const StoredArtifact& known);
  void number(const std::string& name, double value);
  void text(const std::string& name, const std::string& value);
  /// A number among the parameters; `otherwise` when it is not there.
  double number_parameter(const std::string& name, double otherwise) const;

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
  const wire::Artifact& input(const std::string& name) const;
  void pass_on(const WorkCount& count);

  const ArtifactStore& store_;
  const wire::Assign& assign_;
  Say say_;
  wire::Done done_;
  WorkProgress progress_;
  std::bitset<work_stages> said_stages_;
  std::chrono::steady_clock::time_point last_said_;
  bool is_apart_;
};

template <class Look>
auto TaskIo::look_into(const std::string& name, const Look& look) const {
  const wire::Artifact& artifact = input(name);
  return checked_input(artifact, [&] { return look(store_.path_of(artifact.hash())); });
}

}  // namespace tetfarm
