/// The tables of the database and how an older database becomes a newer one.
///
/// `PRAGMA user_version` says how many migrations have run; each runs in a transaction of its own.
#pragma once

struct sqlite3;

namespace tetfarm {

/// Marks a database file as one of ours ("TetF"), in PRAGMA application_id.
inline constexpr int application_id = 0x54657446;

/// How many migrations the database has had; 0: it is new, or another program's.
int schema_version(sqlite3* database);

/// Brings the schema up to database_version. @throws CorruptFile when the file is another program's
/// or a newer program's, IoError.
void migrate(sqlite3* database);

}  // namespace tetfarm
