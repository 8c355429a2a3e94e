/// What has been fetched once and serves many: kept for at least so long, and for ten times as long
/// as it took to fetch, so that however many ask, fetching takes at most a tenth of the time.
/// Bounded by a number of things and by their sizes; what was used longest ago goes first.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <utility>

namespace tetfarm {

/// When something was fetched, and how long that took.
struct FetchTime {
  std::int64_t at_ms = 0;
  std::int64_t took_ms = 0;
};

/// Whether it need not be fetched again yet.
bool is_fresh(const FetchTime& fetched, std::int64_t now_ms);

template <class Thing>
class KeptThings {
 public:
  /// @param most_size of all things together, in the unit that keep() is told
  KeptThings(std::size_t most_things, std::size_t most_size)
      : most_things_(most_things), most_size_(most_size) {}

  struct Kept {
    std::string name;
    FetchTime fetched;
    std::size_t size = 0;
    std::shared_ptr<const Thing> thing;
  };

  /// Nothing when there is none, or it has to be fetched again.
  const Kept* find(const std::string& name, std::int64_t now_ms) {
    for (auto kept = things_.begin(); kept != things_.end(); ++kept) {
      if (kept->name != name) continue;
      if (!is_fresh(kept->fetched, now_ms)) return nullptr;
      things_.splice(things_.begin(), things_, kept);
      return &things_.front();
    }
    return nullptr;
  }

  /// In place of the one of that name. What is too large by itself is not kept.
  void keep(Kept kept) {
    things_.remove_if([&](const Kept& other) { return other.name == kept.name; });
    if (kept.size > most_size_) return;
    things_.push_front(std::move(kept));
    while (things_.size() > most_things_ || size() > most_size_) things_.pop_back();
  }

  std::size_t count() const { return things_.size(); }

 private:
  std::size_t size() const {
    std::size_t sum = 0;
    for (const Kept& kept : things_) sum += kept.size;
    return sum;
  }

  std::size_t most_things_;
  std::size_t most_size_;
  std::list<Kept> things_;  ///< the last used first
};

}  // namespace tetfarm
