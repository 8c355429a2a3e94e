#include "coordinator/views/refusals.h"

#include <bit>
#include <numeric>
#include <utility>

#include "base/printable_text.h"
#include "base/utf8.h"

namespace tetfarm {
namespace {

constexpr std::int64_t quiet_ms = 60'000;
constexpr std::size_t longest_told = 300;

constexpr std::array<const char*, refusal_kinds> names = {"unknown_key",
                                                          "revoked_key",
                                                          "wrong_role",
                                                          "broken_handshake",
                                                          "too_many_connections",
                                                          "too_many_workers",
                                                          "foreign_connection",
                                                          "garbage",
                                                          "too_large",
                                                          "wrong_version",
                                                          "senseless",
                                                          "stale",
                                                          "outside_roots",
                                                          "no_result"};

}  // namespace

const char* name_of(Refusal kind) { return names.at(static_cast<std::size_t>(kind)); }

void Refusals::count(Refusal kind, const std::string& told, std::int64_t now_ms) {
  const auto i = static_cast<std::size_t>(kind);
  ++counts_.at(i);
  if (!std::has_single_bit(counts_.at(i)) && now_ms - told_ms_.at(i) < quiet_ms) return;
  told_ms_.at(i) = now_ms;
  complaints_.push_back(std::string("refused: ") + name_of(kind) + " (" +
                        std::to_string(counts_.at(i)) +
                        " so far): " + printable(cut_utf8(told, longest_told)));
}

std::uint64_t Refusals::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

std::vector<std::string> Refusals::take_complaints() { return std::exchange(complaints_, {}); }

}  // namespace tetfarm
