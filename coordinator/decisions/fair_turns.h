/// The order in which ready tasks are handed out: those of jobs with a higher priority first; of
/// one priority those of the user who has the fewest tasks at work, so that users take turns
/// however many jobs each has submitted; then by the rank of their kind, then the older ones.
///
/// A user is an owner of jobs: the public key of who submitted them. Whoever came without a key is
/// one and the same user. With one user the order is that of TaskLists::offers().
/// Cost: each step O(users + log tasks).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coordinator/decisions/task_lists.h"
#include "store/rows.h"

namespace tetfarm {

/// How many tasks of each user are at work; who is not named has none.
using UsersAtWork = std::map<std::string, std::size_t>;

class FairTurns {
 public:
  /// @pre what is on offer stays as it is, and outlives this.
  FairTurns(const TaskLists::OfUsers& offers, const UsersAtWork& at_work);

  /// The task whose turn it is; nothing when all had theirs.
  std::optional<TaskId> next();

 private:
  struct User {
    std::set<TaskLists::Offer>::const_iterator next;
    std::set<TaskLists::Offer>::const_iterator end;
    std::size_t at_work = 0;
  };
  static bool comes_before(const User& a, const User& b);

  std::vector<User> users_;  ///< with something left
};

}  // namespace tetfarm
