#include "dashboard/kept_things.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int64_t shortest_ms = 2'000;
constexpr std::int64_t times_what_it_took = 10;

}  // namespace

bool is_fresh(const FetchTime& fetched, std::int64_t now_ms) {
  TF_CHECK(fetched.took_ms >= 0);
  return now_ms - fetched.at_ms < std::max(shortest_ms, times_what_it_took * fetched.took_ms);
}

}  // namespace tetfarm
