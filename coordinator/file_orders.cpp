#include "coordinator/file_orders.h"

#include <charconv>
#include <optional>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "proto/file_chunks.h"
#include "store/attempt_scratch.h"
#include "store/disk_room.h"

namespace tetfarm {
namespace {

const std::string upload_stem = "upload-";
const std::string surface_stem = "surface-";
const std::string part_ending = ".part";
constexpr std::size_t hash_digits = 32;

wire::Envelope read_chunk(const FileOrder& order, const ArtifactStore& store) {
  wire::Envelope envelope;
  wire::FileChunk& chunk = *envelope.mutable_file_chunk();
  chunk.set_task(order.task.value);
  chunk.set_attempt(order.attempt.value);
  chunk.set_hash(order.file.hash);
  chunk.set_offset(order.offset);
  const std::uint64_t wanted = chunk_size(order.file.size, order.offset);
  std::string bytes;
  if (wanted > 0 && store.has(order.file.hash, order.file.size)) {
    bytes = read_part_of_file(store.path_of(order.file.hash), order.offset, wanted);
  }
  chunk.set_missing(bytes.size() != wanted || wanted == 0);
  if (!chunk.missing()) fill_chunk(chunk, std::move(bytes));
  return envelope;
}

std::filesystem::path growing_path(const ArtifactStore& store, const FileOrder& order) {
  return order.client.empty() ? upload_path(store, order.attempt, order.file.hash)
                              : surface_path(store, order.client, order.file.hash);
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
    store.adopt_file(growing_path(store, order), order.file);
    return stored(order, order.file.size, true, false);
  } catch (const CorruptFile&) {
    return stored(order, 0, false, true);
  }
}

/// A client can be told before it sends; a worker's file is made already, and has to go somewhere.
void want_room_for(std::uint64_t bytes, const ArtifactStore& store) {
  if (disk_room(store.folder()).has(bytes)) return;
  throw Error(ExitCode::out_of_resources,
              "the coordinator's disk has no room for another " + std::to_string(bytes) + " bytes");
}

wire::Envelope open_upload(const FileOrder& order, const ArtifactStore& store) {
  if (has_whole(order, store)) return stored(order, order.file.size, true, false);
  const std::filesystem::path path = growing_path(store, order);
  std::uint64_t there = size_of_file(path).value_or(0);
  if (there > order.file.size) {
    remove_file(path);
    there = 0;
  }
  if (there < order.file.size) {
    if (!order.client.empty()) want_room_for(order.file.size - there, store);
    return stored(order, there, false, true);
  }
  TF_CHECK(there == order.file.size);
  append_to_file(path, there, "");
  return publish_upload(order, store);
}

wire::Envelope append_chunk(const FileOrder& order, const ArtifactStore& store) {
  const std::filesystem::path path = growing_path(store, order);
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
  TF_CHECK(now_there <= order.file.size);
  if (now_there < order.file.size) return stored(order, now_there, false, false);
  return publish_upload(order, store);
}

wire::Envelope drop_upload(const FileOrder& order, const ArtifactStore& store) {
  remove_file(growing_path(store, order));
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
    case FileOrder::Kind::clear:
      remove_attempt_scratch(store, order.attempt);
      break;
    case FileOrder::Kind::forget:
      remove_file(probe_path(store, order.file.hash));
      break;
    case FileOrder::Kind::check:
      break;
  }
  return {};
}

/// Who cannot read a file does not know it to be damaged: the worker's disk may have failed.
void check(const FileOrder& order, const ArtifactStore& store, FileAnswer& answer) {
  TF_CHECK(answer.checked.has_value());
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

/// A worker says later what it misses; a client has nobody but us to hear it from.
void tell_client(const FileOrder& order, const std::string& trouble, ExitCode code,
                 FileAnswer& answer) {
  if (order.client.empty() || order.connection.empty()) return;
  answer.envelope.mutable_refused()->set_reason(trouble);
  answer.envelope.mutable_refused()->set_exit_code(static_cast<int>(code));
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
  TF_CHECK(attempt && ArtifactStore::is_hash(hash));
  return store.scratch_folder() /
         (upload_stem + std::to_string(attempt.value) + "-" + hash + part_ending);
}

std::filesystem::path surface_path(const ArtifactStore& store, const std::string& client,
                                   const std::string& hash) {
  TF_CHECK(ArtifactStore::is_hash(client) && ArtifactStore::is_hash(hash));
  return store.scratch_folder() / (surface_stem + client + "-" + hash + part_ending);
}

FileAnswer carry_out(const FileOrder& order, const ArtifactStore& store) noexcept {
  FileAnswer answer;
  answer.connection = order.connection;
  answer.client = order.client;
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
    answer.is_out_of_room = order.client.empty() && error.code() == ExitCode::out_of_resources;
    tell_client(order, answer.trouble, error.code(), answer);
  } catch (const std::exception& error) {
    answer.trouble = error.what();
  }
  return answer;
}

std::vector<BegunSurface> begun_surfaces(const ArtifactStore& store) {
  std::vector<BegunSurface> begun;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(store.scratch_folder(), error)) {
    const std::string name = entry.path().filename().string();
    const std::size_t client = surface_stem.size();
    const std::size_t hash = client + hash_digits + 1;
    if (name.size() != hash + hash_digits + part_ending.size()) continue;
    const BegunSurface surface{name.substr(client, hash_digits), name.substr(hash, hash_digits)};
    const bool is_one = ArtifactStore::is_hash(surface.client) &&
                        ArtifactStore::is_hash(surface.hash) &&
                        entry.path() == surface_path(store, surface.client, surface.hash);
    if (is_one) begun.push_back(surface);
  }
  return begun;
}

void drop_uploads_but(const std::set<AttemptId>& running, const ArtifactStore& store) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(store.scratch_folder(), error)) {
    const std::optional<AttemptId> attempt = attempt_of(entry.path().filename().string());
    if (attempt && !running.contains(*attempt)) remove_file(entry.path());
  }
}

}  // namespace tetfarm
