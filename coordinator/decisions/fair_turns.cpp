#include "coordinator/decisions/fair_turns.h"

#include <algorithm>
#include <tuple>

#include "base/check.h"

namespace tetfarm {

FairTurns::FairTurns(const TaskLists::OfUsers& offers, const UsersAtWork& at_work) {
  for (const auto& [user, tasks] : offers) {
    TF_CHECK(!tasks.empty());
    const auto known = at_work.find(user);
    users_.push_back({tasks.begin(), tasks.end(), known == at_work.end() ? 0 : known->second});
  }
}

bool FairTurns::comes_before(const User& a, const User& b) {
  const auto& [a_priority, a_rank, a_task] = *a.next;
  const auto& [b_priority, b_rank, b_task] = *b.next;
  return std::tie(a_priority, a.at_work, a_rank, a_task) <
         std::tie(b_priority, b.at_work, b_rank, b_task);
}

std::optional<TaskId> FairTurns::next() {
  const auto user = std::min_element(users_.begin(), users_.end(), comes_before);
  if (user == users_.end()) return std::nullopt;
  const TaskId task = std::get<TaskId>(*user->next++);
  if (user->next == user->end) users_.erase(user);
  return task;
}

}  // namespace tetfarm
