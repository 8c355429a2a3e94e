#include "tasks/task_kind.h"

#include <algorithm>

#include "base/check.h"
#include "tasks/task_traits.h"

namespace tetfarm {
namespace {

#define TETFARM_TRAITS(kind) &kind##_traits,
constexpr std::array all_traits = {TETFARM_TASK_KINDS(TETFARM_TRAITS)};
#undef TETFARM_TRAITS

template <class Matches>
std::optional<TaskKind> find_kind(const Matches& matches) {
  const auto found = std::find_if(all_task_kinds.begin(), all_task_kinds.end(),
                                  [&](TaskKind kind) { return matches(traits_of(kind)); });
  return found == all_task_kinds.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

const TaskKindTraits& traits_of(TaskKind kind) {
  const auto place = static_cast<std::size_t>(kind);
  TF_CHECK(place < all_traits.size());
  return *all_traits[place];
}

const char* name_of(TaskKind kind) { return traits_of(kind).name; }

std::optional<TaskKind> task_kind_named(std::string_view name) {
  return find_kind([name](const TaskKindTraits& traits) { return traits.name == name; });
}

std::optional<TaskKind> task_kind_on_wire(std::uint32_t number) {
  return find_kind([number](const TaskKindTraits& traits) { return traits.on_wire == number; });
}

}  // namespace tetfarm
