#include "coordinator/file_orders.h"

#include <charconv>
#include <optional>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/file_chunks.h"

namespace tetfarm {
namespace {

const std::string upload_stem = "upload-";

wire::Envelope read_chunk(const FileOrder& order, const ArtifactStore& store) {
  wire::Envelope envelope;
  wire::FileChunk& chunk = *envelope.mutable_file_chunk();
  chunk.set_task(order.task.value);
  chunk.set_attempt(order.attempt.value);
  chunk.set_hash(order.file.hash);
  chunk.set_offset(order.offset);
  const std::uint64_t wanted = chunk_size(order.file.size, order.offset);
  std::string bytes;
  if (store.has(order.file.hash, order.file.size)) {
    bytes = read_part_of_file(store.path_of(order.file.hash), order.offset, wanted);
  }
  chunk.set_missing(bytes.size() != wanted || wanted == 0);
  if (!chunk.missing()) fill_chunk(chunk, std::move(bytes));
  return envelope;
}

wire::Envelope stored(const FileOrder& order, std::uint64_t bytes, bool whole, bool resend) {
  wire::Envelope envelope;
  wire::FileStored& message = *envelope.mutable_file_stored();
  message.set_task(order.task.value);
  message.set_attempt(order.attempt.value);
  message.set_hash(order.file.hash);
  message.set_bytes(bytes);
  message.set_whole(whole);
  message.set_resend(resend);
  return envelope;
}

/// What is there under the name counts only when it is what the name says.
bool has_whole(const FileOrder& order, const ArtifactStore& store) {
  if (!store.has(order.file.hash, order.file.size)) return false;
  try {
    store.verify(order.file.hash, order.file.size);
    return true;
  } catch (const CorruptFile&) {
    return false;
  }
}

wire::Envelope publish_upload(const FileOrder& order, const ArtifactStore& store) {
  try {
    store.adopt_file(upload_path(store, order.attempt, order.file.hash), order.file);
    return stored(order, order.file.size, true, false);
  } catch (const CorruptFile&) {
    return stored(order, 0, false, true);
  }
}

wire::Envelope open_upload(const FileOrder& order, const ArtifactStore& store) {
  if (has_whole(order, store)) return stored(order, order.file.size, true, false);
  const std::filesystem::path path = upload_path(store, order.attempt, order.file.hash);
  std::uint64_t there = size_of_file(path).value_or(0);
  if (there > order.file.size) {
    remove_file(path);
    there = 0;
  }
  if (there < order.file.size) return stored(order, there, false, true);
  append_to_file(path, there, "");
  return publish_upload(order, store);
}

wire::Envelope append_chunk(const FileOrder& order, const ArtifactStore& store) {
  const std::filesystem::path path = upload_path(store, order.attempt, order.file.hash);
  const std::optional<std::uint64_t> begun = size_of_file(path);
  if (!begun && order.offset > 0 && has_whole(order, store)) {
    return stored(order, order.file.size, true, false);
  }
  const std::uint64_t there = begun.value_or(0);
  if (order.offset < there) return stored(order, there, false, false);
  if (order.offset > there || !is_intact(order.chunk) ||
      order.chunk.bytes().size() != chunk_size(order.file.size, there)) {
    return stored(order, there, false, true);
  }
  append_to_file(path, there, order.chunk.bytes());
  const std::uint64_t now_there = there + order.chunk.bytes().size();
  if (now_there < order.file.size) return stored(order, now_there, false, false);
  return publish_upload(order, store);
}

wire::Envelope drop_upload(const FileOrder& order, const ArtifactStore& store) {
  remove_file(upload_path(store, order.attempt, order.file.hash));
  return {};
}

wire::Envelope answer_to(const FileOrder& order, const ArtifactStore& store) {
  switch (order.kind) {
    case FileOrder::Kind::read:
      return read_chunk(order, store);
    case FileOrder::Kind::open:
      return open_upload(order, store);
    case FileOrder::Kind::append:
      return append_chunk(order, store);
    case FileOrder::Kind::drop:
      return drop_upload(order, store);
    case FileOrder::Kind::check:
      break;
  }
  return {};
}

/// Who cannot read a file does not know it to be damaged: the worker's disk may have failed.
void check(const FileOrder& order, const ArtifactStore& store, FileAnswer& answer) {
  CheckedFile& checked = *answer.checked;
  try {
    store.verify(order.file.hash, order.file.size);
    checked.verdict = CheckedFile::Verdict::sound;
  } catch (const IoError& error) {
    const bool is_gone = error.code() == ExitCode::not_found;
    checked.verdict = is_gone ? CheckedFile::Verdict::damaged : CheckedFile::Verdict::sound;
  } catch (const CorruptFile& error) {
    answer.trouble = error.what();
    store.set_aside(order.file.hash);
    checked.verdict = CheckedFile::Verdict::damaged;
  }
}

/// The 7 of "upload-7-HASH.part"; nothing for other names.
std::optional<AttemptId> attempt_of(const std::string& name) {
  if (!name.starts_with(upload_stem)) return std::nullopt;
  AttemptId attempt;
  const char* end = name.data() + name.size();
  const auto [stopped, error] =
      std::from_chars(name.data() + upload_stem.size(), end, attempt.value);
  return error == std::errc{} && stopped != end && *stopped == '-' ? std::optional(attempt)
                                                                   : std::nullopt;
}

}  // namespace

std::filesystem::path upload_path(const ArtifactStore& store, AttemptId attempt,
                                  const std::string& hash) {
  return store.scratch_folder() /
         (upload_stem + std::to_string(attempt.value) + "-" + hash + ".part");
}

FileAnswer carry_out(const FileOrder& order, const ArtifactStore& store) noexcept {
  FileAnswer answer;
  answer.connection = order.connection;
  const bool is_check = order.kind == FileOrder::Kind::check;
  if (is_check) answer.checked = CheckedFile{order.attempt, order.file.hash};
  try {
    if (is_check) {
      check(order, store, answer);
    } else {
      answer.envelope = answer_to(order, store);
    }
  } catch (const Error& error) {
    answer.trouble = error.what();
    answer.is_out_of_room = error.code() == ExitCode::out_of_resources;
  } catch (const std::exception& error) {
    answer.trouble = error.what();
  }
  return answer;
}

void drop_uploads_but(const std::set<AttemptId>& running, const ArtifactStore& store) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(store.scratch_folder(), error)) {
    const std::optional<AttemptId> attempt = attempt_of(entry.path().filename().string());
    if (attempt && !running.contains(*attempt)) remove_file(entry.path());
  }
}

}  // namespace tetfarm
