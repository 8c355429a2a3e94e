#include "tasks/task_place.h"

#include <optional>

#include "base/tree_path.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

bool is_of_cycle(std::string_view name) {
  const std::optional<TaskKind> kind = task_kind_named(name);
  return kind && traits_of(*kind).is_of_cycle;
}

}  // namespace

bool is_place_in_tree(std::string_view kind, std::uint64_t path) {
  return path != 0 && !is_of_cycle(kind);
}

std::string task_place(std::string_view kind, std::uint64_t path) {
  if (path == 0) return "";
  return is_of_cycle(kind) ? "cycle " + std::to_string(path) : tree_path(path);
}

std::string of_task_place(std::string_view kind, std::uint64_t path) {
  if (path == 0) return "";
  if (is_of_cycle(kind)) return " of " + task_place(kind, path);
  return path == 1 ? " of the whole domain" : " of sub-domain " + tree_path(path);
}

}  // namespace tetfarm
