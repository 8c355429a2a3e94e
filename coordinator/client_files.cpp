#include "coordinator/client_files.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"

namespace tetfarm {
namespace {

/// A client that fetches is heard of more often.
constexpr std::int64_t grant_ms = 60'000;

FileOrder order_of(const ClientSender& sender, FileOrder::Kind kind, const StoredArtifact& file,
                   std::uint64_t offset) {
  TF_CHECK(!sender.client.empty());
  FileOrder order;
  order.kind = kind;
  order.connection = sender.connection;
  order.client = sender.client;
  order.file = file;
  order.offset = offset;
  return order;
}

}  // namespace

std::string client_name(const std::string& key) { return hash128(key).hex(); }

void ClientFiles::fetch(const ClientSender& sender, const wire::FetchFile& message,
                        const FilesOfJob& files_of_job, Moment now) {
  const JobId job{message.task()};
  if (message.offset() % chunk_bytes != 0) {
    throw UsageError("no chunk begins at byte " + std::to_string(message.offset()), job_name(job));
  }
  Granted& granted = granted_[sender.connection];
  granted.heard_ms = now.steady_ms;
  if (granted.job != job || granted.file.hash != message.hash()) {
    granted.job = {};
    const auto files = files_of_job(job);
    if (!files) throw Error(ExitCode::not_found, "no job " + job_name(job));
    const auto file = std::find_if(
        files->begin(), files->end(),
        [&](const StoredArtifact& candidate) { return candidate.hash == message.hash(); });
    if (file == files->end()) {
      throw Error(ExitCode::not_found, job_name(job) + " has no such file");
    }
    granted = {job, *file, now.steady_ms};
  }
  lines_.add(order_of(sender, FileOrder::Kind::read, granted.file, message.offset()), {}, now);
}

void ClientFiles::offer(const ClientSender& sender, const wire::OfferFile& message, Moment now) {
  if (!ArtifactStore::is_hash(message.hash()))
    throw UsageError("has no valid checksum", "the surface");
  if (message.size() > max_brought_bytes) {
    throw UsageError("has " + std::to_string(message.size()) + " bytes; at most " +
                         std::to_string(max_brought_bytes) +
                         " can be sent over a connection: submit it with --store",
                     "the surface");
  }
  const BegunSurface surface{sender.client, message.hash()};
  if (!uploads_.contains(surface)) {
    const auto of_client = std::count_if(uploads_.begin(), uploads_.end(), [&](const auto& entry) {
      return entry.first.client == sender.client;
    });
    if (uploads_.size() >= limits_.surfaces ||
        static_cast<std::size_t>(of_client) >= limits_.surfaces_of_client) {
      throw Error(ExitCode::out_of_resources,
                  "too many surfaces are being sent to this coordinator; try again later");
    }
  }
  uploads_[surface] = {sender.connection, message.size(), now.steady_ms};
  const StoredArtifact file{message.hash(), message.size()};
  lines_.add(order_of(sender, FileOrder::Kind::open, file, 0), {}, now);
}

bool ClientFiles::append(const ClientSender& sender, const wire::FileChunk& chunk, Moment now) {
  const auto upload = uploads_.find({sender.client, chunk.hash()});
  if (upload == uploads_.end() || upload->second.connection != sender.connection) return false;
  upload->second.heard_ms = now.steady_ms;
  const StoredArtifact file{chunk.hash(), upload->second.size};
  FileOrder order = order_of(sender, FileOrder::Kind::append, file, chunk.offset());
  order.chunk = chunk;
  return lines_.add(std::move(order), {}, now);
}

void ClientFiles::drop_silent(Moment now, std::vector<FileOrder>& orders) {
  std::erase_if(granted_, [&](const auto& entry) {
    return entry.second.heard_ms + grant_ms < now.steady_ms;
  });
  std::erase_if(uploads_, [&](const auto& entry) {
    const auto& [surface, upload] = entry;
    if (upload.heard_ms + limits_.kept_ms >= now.steady_ms) return false;
    orders.push_back(
        order_of({"", surface.client}, FileOrder::Kind::drop, {surface.hash, upload.size}, 0));
    return true;
  });
}

std::vector<FileOrder> ClientFiles::take_orders(Moment now) {
  std::vector<FileOrder> orders;
  if (granted_.empty() && uploads_.empty() && lines_.empty()) return orders;
  drop_silent(now, orders);
  for (FileOrder& order : lines_.take(now)) orders.push_back(std::move(order));
  return orders;
}

void ClientFiles::note_answer(const FileAnswer& answer) {
  lines_.note_answer(answer.connection);
  const wire::FileStored& stored = answer.envelope.file_stored();
  if (stored.whole()) uploads_.erase({answer.client, stored.hash()});
}

void ClientFiles::remember(const std::vector<BegunSurface>& begun, Moment now) {
  for (const BegunSurface& surface : begun) uploads_[surface] = {"", 0, now.steady_ms};
}

}  // namespace tetfarm
