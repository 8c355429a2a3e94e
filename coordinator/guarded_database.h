/// The coordinator's database for as long as it can be relied on.
///
/// A transaction counts as committed only when it is in the file that lies under the database's
/// name: whoever starts next opens that one. When the file or its log was removed or replaced, may
/// not be written to, or its disk is full or failing, this is closed: nothing is committed, and it
/// says why. It opens again by itself as soon as the files are back and a write goes through.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"
#include "store/file_in_place.h"
#include "store/job_database.h"

namespace tetfarm {

class GuardedDatabase {
 public:
  /// @throws as JobDatabase does.
  explicit GuardedDatabase(const std::filesystem::path& path);
  /// Files that others put in the place of the database stay as they are.
  ~GuardedDatabase();
  GuardedDatabase(const GuardedDatabase&) = delete;
  GuardedDatabase& operator=(const GuardedDatabase&) = delete;

  /// @pre nobody uses it any more. Of a database that was removed what it holds is saved beside its
  /// name, for `tetfarm restore`; the file's name is returned, "" where there is no need.
  /// @throws IoError when it cannot be saved.
  std::string save_when_removed(std::int64_t now_wall_ms);

  JobDatabase& rows() { return database_; }

  enum class Outcome {
    committed,
    locked,  ///< by somebody, for the moment
    closed
  };
  /// All of the changes are durable, or none. @throws Error for what no waiting mends.
  Outcome commit(const ChangeSet& changes);

  enum class Look { as_before, has_closed, has_opened };
  /// Are the files there, and while it is closed, does a write go through? Looks twice a second,
  /// whenever it is called; a write is tried less often where it keeps failing.
  Look look(std::int64_t now_ms);

  bool is_closed() const { return !trouble_.empty(); }
  /// Why, for people: what, where, and what to do; "" while it is open.
  const std::string& trouble() const { return trouble_; }
  /// Of a closed one: out_of_resources, or failed.
  ExitCode trouble_code() const { return code_; }
  /// What kept the last commit out, for the log.
  const std::string& last_failure() const { return last_failure_; }

 private:
  std::string displacement() const;
  void close(const std::string& trouble, ExitCode code);
  bool try_to_write(std::int64_t now_ms);

  JobDatabase database_;
  FileInPlace file_;
  std::optional<FileInPlace> log_;  ///< none where the file system cannot have one
  std::string trouble_;
  ExitCode code_ = ExitCode::failed;
  std::string last_failure_;
  std::int64_t next_look_ms_ = 0;
  std::int64_t next_try_ms_ = 0;
  std::int64_t try_delay_ms_ = 0;
};

}  // namespace tetfarm
