#include "coordinator/guarded_database.h"

#include <algorithm>
#include <cerrno>

#include "base/check.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr std::int64_t look_again_ms = 500;
constexpr std::int64_t slowest_try_ms = 8'000;

std::string worded(const FileInPlace& file, FileInPlace::State state) {
  const std::string name = file.path().string();
  if (state == FileInPlace::State::removed) {
    return name +
           ": the database was removed while the coordinator was using it; nothing is accepted "
           "until the same file is back. Move it back, or stop the coordinator, which then saves "
           "what it holds in a file beside it for `tetfarm restore`";
  }
  return name +
         ": another file has taken the place of the database while the coordinator was using it; "
         "nothing is accepted. Move the old file back, or restart the coordinator to continue with "
         "the new one";
}

std::string worded_of_log(const FileInPlace& log) {
  return log.path().string() +
         ": the log of the database was removed or replaced while the coordinator was using it; "
         "nothing is accepted. Restart the coordinator: as it stops, it writes what the log held "
         "to the database";
}

std::string worded(const IoError& error) {
  return std::string(error.what()) +
         "; nothing is accepted until the database can be written to again";
}

}  // namespace

GuardedDatabase::GuardedDatabase(const std::filesystem::path& path) : database_(path), file_(path) {
  // Opening the database has written to it.
  const std::string log = path.string() + "-wal";
  if (size_of_file(log)) log_.emplace(log);
}

GuardedDatabase::~GuardedDatabase() {
  try {
    if (file_.look() == FileInPlace::State::there) return;
  } catch (const IoError&) {
    // What cannot be looked at is left alone, too.
  }
  database_.leave_files_alone();
}

std::string GuardedDatabase::save_when_removed(std::int64_t now_wall_ms) {
  if (file_.look() != FileInPlace::State::removed) return "";
  const std::string saved = file_.path().string() + ".saved-" + std::to_string(now_wall_ms);
  database_.save_copy(saved);
  return saved;
}

/// Which file is not where it was, in words; "": none.
std::string GuardedDatabase::displacement() const {
  try {
    const FileInPlace::State state = file_.look();
    if (state != FileInPlace::State::there) return worded(file_, state);
    if (!log_ || log_->look() == FileInPlace::State::there) return "";
    return worded_of_log(*log_);
  } catch (const IoError& error) {
    return worded(error);
  }
}

void GuardedDatabase::close(const std::string& trouble, ExitCode code) {
  TF_CHECK(code != ExitCode::ok);
  trouble_ = last_failure_ = trouble;
  code_ = code;
}

GuardedDatabase::Outcome GuardedDatabase::commit(const ChangeSet& changes) {
  if (changes.empty()) return Outcome::committed;
  const std::string displaced = displacement();
  if (!displaced.empty()) {
    close(displaced, ExitCode::failed);
    return Outcome::closed;
  }
  try {
    database_.apply(changes);
    try_delay_ms_ = 0;
    return Outcome::committed;
  } catch (const IoError& error) {
    last_failure_ = error.what();
    if (error.error_number() == EINVAL) throw;  // no waiting mends what we did wrong
    if (error.error_number() == EBUSY) return Outcome::locked;
    close(worded(error), error.code());
    return Outcome::closed;
  }
}

/// Whether the closed database takes a transaction again; not tried at every call.
bool GuardedDatabase::try_to_write(std::int64_t now_ms) {
  if (now_ms < next_try_ms_) return false;
  try_delay_ms_ = std::clamp(2 * try_delay_ms_, look_again_ms, slowest_try_ms);
  next_try_ms_ = now_ms + try_delay_ms_;
  TF_CHECK(try_delay_ms_ >= look_again_ms && try_delay_ms_ <= slowest_try_ms);
  try {
    database_.try_to_write();
    return true;
  } catch (const IoError& error) {
    close(worded(error), error.code());
    return false;
  }
}

GuardedDatabase::Look GuardedDatabase::look(std::int64_t now_ms) {
  if (now_ms < next_look_ms_) return Look::as_before;
  next_look_ms_ = now_ms + look_again_ms;
  const bool was_closed = is_closed();
  const std::string displaced = displacement();
  if (!displaced.empty()) {
    close(displaced, ExitCode::failed);
    return was_closed ? Look::as_before : Look::has_closed;
  }
  if (!was_closed || !try_to_write(now_ms)) return Look::as_before;
  trouble_.clear();
  return Look::has_opened;
}

}  // namespace tetfarm
