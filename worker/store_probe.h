/// Does this worker see the coordinator's store? It leaves a file with a random name and content
/// there, and the coordinator says whether it finds it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "proto/messages.pb.h"
#include "store/artifact_store.h"

namespace tetfarm {

class StoreProbe {
 public:
  /// `store` "": it sees none.
  explicit StoreProbe(std::filesystem::path store) : folder_(std::move(store)) {}
  ~StoreProbe() { remove(); }
  StoreProbe(const StoreProbe&) = delete;
  StoreProbe& operator=(const StoreProbe&) = delete;

  /// Names the file in the message. It stays while this lives: of Hellos that were repeated each
  /// must find it. Where there is no store yet, the message says so once `patience_ms` are over
  /// since the first call; until then false: ask again later.
  bool put_into(wire::Hello& hello, std::int64_t now_ms);

  /// Whether the file that was named last is gone: the next Hello names another.
  bool is_lost() const noexcept;

  static constexpr std::int64_t patience_ms = 10'000;

 private:
  void make(const ArtifactStore& store);
  void remove() noexcept;

  std::filesystem::path folder_;
  std::filesystem::path file_;
  std::string name_;
  std::string text_;
  std::optional<std::int64_t> missed_since_ms_;
};

}  // namespace tetfarm
