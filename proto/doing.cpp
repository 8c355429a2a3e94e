#include "proto/doing.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// More than any task counts, and exact in a double.
constexpr std::uint64_t largest_count = 1'000'000'000'000'000;

}  // namespace

wire::Doing doing_message(const WorkCount& count) {
  wire::Doing doing;
  doing.set_stage(name_of(count.stage));
  doing.set_pass(count.pass);
  doing.set_done(count.done);
  doing.set_total(count.total);
  return doing;
}

std::optional<WorkCount> work_count_of(const wire::Doing& doing) {
  const std::optional<WorkStage> stage = work_stage_of(doing.stage());
  if (!stage) return std::nullopt;
  WorkCount count;
  count.stage = *stage;
  count.pass = std::min(doing.pass(), largest_count);
  count.total = std::min(doing.total(), largest_count);
  count.done = std::min(doing.done(), count.total > 0 ? count.total : largest_count);
  TF_CHECK(count.total == 0 || count.done <= count.total);
  return count;
}

std::string doing_text(const wire::Doing& doing) {
  const std::optional<WorkCount> count = work_count_of(doing);
  return count ? work_text(*count) : doing.stage();
}

}  // namespace tetfarm
