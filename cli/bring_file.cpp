#include "cli/bring_file.h"

#include "base/hash.h"
#include "worker/file_send.h"

namespace tetfarm {
namespace {

class BroughtFile : public PieceExchange {
 public:
  BroughtFile(const std::string& bytes, const StoredArtifact& file) : bytes_(bytes), send_(file) {}

  const FileSend& send() const { return send_; }
  bool is_complete() const override { return send_.is_whole(); }
  void ask_again() override { send_.ask_again(); }

  std::vector<wire::Envelope> due(std::int64_t now_ms) override {
    std::vector<wire::Envelope> messages;
    const FileSend::Due due = send_.due(now_ms);
    if (due.offer) {
      wire::OfferFile& offer = *messages.emplace_back().mutable_offer_file();
      offer.set_hash(send_.file().hash);
      offer.set_size(send_.file().size);
    }
    for (const std::uint64_t offset : due.chunks) {
      wire::FileChunk& chunk = *messages.emplace_back().mutable_file_chunk();
      chunk.set_hash(send_.file().hash);
      chunk.set_offset(offset);
      fill_chunk(chunk, bytes_.substr(offset, chunk_size(bytes_.size(), offset)));
    }
    return messages;
  }

  bool take(const wire::Envelope& message, std::int64_t now_ms) override {
    return message.has_file_stored() && send_.take(message.file_stored(), now_ms);
  }

 private:
  const std::string& bytes_;
  FileSend send_;
};

}  // namespace

StoredArtifact bring_file(CoordinatorConnection& connection, const std::string& bytes,
                          const std::string& name, const FetchOptions& options) {
  const StoredArtifact file{hash128(bytes).hex(), bytes.size()};
  BroughtFile files(bytes, file);
  TransferDisplay display(options.progress);
  connection.exchange(files, options.timeout_ms,
                      [&] { display.show("sending " + name, files.send().there(), file.size); });
  return file;
}

}  // namespace tetfarm
