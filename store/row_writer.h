/// Writes changed rows into the tables of the database; the other half of JobDatabase::apply.
#pragma once

#include "store/rows.h"

struct sqlite3;

namespace tetfarm {

/// Inserts or replaces all rows. @pre a transaction is open. @throws IoError, CorruptFile.
void write_rows(sqlite3* database, const ChangeSet& changes);

}  // namespace tetfarm
