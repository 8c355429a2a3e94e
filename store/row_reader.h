/// Reads the rows that decide what happens next; the other half of JobDatabase::load.
#pragma once

#include <string>

#include "store/rows.h"

struct sqlite3;

namespace tetfarm {

/// Cost: one pass over the tables, but for history. @throws IoError, CorruptFile.
DurableState read_state(sqlite3* database);

/// The states of an attempt and the kinds of a task by their names. @throws CorruptFile.
AttemptState attempt_state_of(const std::string& name);
TaskKind task_kind_of(const std::string& name);

}  // namespace tetfarm
