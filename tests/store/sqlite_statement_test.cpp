#include "store/sqlite_statement.h"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <cerrno>

#include "base/error.h"
#include "store/database_file.h"

namespace tetfarm {
namespace {

class SqliteStatements : public testing::Test {
 protected:
  SqliteStatements() { execute(get(), "CREATE TABLE t (a INTEGER, b REAL, c TEXT)"); }
  sqlite3* get() const { return database_.get(); }

  SqlitePtr database_ = open_database(":memory:", DatabaseAccess::write);
};

TEST_F(SqliteStatements, bind_values_one_after_the_other_and_read_them_so) {
  Statement insert(get(), "INSERT INTO t VALUES (?, ?, ?)");
  insert.bind(std::int64_t{-5}).bind(0.1).bind(std::string("a\0b", 3)).run();
  insert.bind(std::int64_t{7}).bind_null().bind("text").run();
  Statement rows(get(), "SELECT a, b, c FROM t ORDER BY a");
  ASSERT_TRUE(rows.step());
  EXPECT_EQ(rows.integer(), -5);
  EXPECT_EQ(rows.real(), 0.1);
  EXPECT_EQ(rows.text(), std::string("a\0b", 3));
  ASSERT_TRUE(rows.step());
  EXPECT_EQ(rows.integer(), 7);
  EXPECT_EQ(rows.real(), 0) << "nothing";
  EXPECT_EQ(rows.text(), "text");
  EXPECT_FALSE(rows.step());
  rows.rewind();
  EXPECT_TRUE(rows.step()) << "once more from the beginning";
}

TEST_F(SqliteStatements, that_are_none_are_our_mistake_and_named) {
  try {
    execute(get(), "SELECT nonsense");
    ADD_FAILURE() << "there is no such column";
  } catch (const IoError& error) {
    EXPECT_STREQ(error.what(), ": SELECT nonsense (no such column: nonsense): Invalid argument");
    EXPECT_EQ(error.error_number(), EINVAL);
  }
  EXPECT_THROW(Statement(get(), "SELEC"), IoError);
}

TEST(SqliteErrors, are_told_from_one_another_by_what_can_be_done_about_them) {
  const auto number_of = [](int code) {
    try {
      throw_sqlite_error(nullptr, code, "cannot");
    } catch (const IoError& error) {
      return error.error_number();
    } catch (const CorruptFile&) {
      return -1;
    }
    return 0;
  };
  EXPECT_EQ(number_of(SQLITE_FULL), ENOSPC);
  EXPECT_EQ(number_of(SQLITE_NOMEM), ENOMEM);
  EXPECT_EQ(number_of(SQLITE_BUSY), EBUSY);
  EXPECT_EQ(number_of(SQLITE_BUSY_SNAPSHOT), EBUSY);
  EXPECT_EQ(number_of(SQLITE_LOCKED), EBUSY);
  EXPECT_EQ(number_of(SQLITE_READONLY), EROFS);
  EXPECT_EQ(number_of(SQLITE_READONLY_DBMOVED), EROFS);
  EXPECT_EQ(number_of(SQLITE_PERM), EACCES);
  EXPECT_EQ(number_of(SQLITE_IOERR_WRITE), EFBIG) << "a quota";
  EXPECT_EQ(number_of(SQLITE_IOERR_READ), EIO);
  EXPECT_EQ(number_of(SQLITE_CANTOPEN), EIO);
  EXPECT_EQ(number_of(SQLITE_PROTOCOL), EIO);
  EXPECT_EQ(number_of(SQLITE_CONSTRAINT), EINVAL);
  EXPECT_EQ(number_of(SQLITE_MISUSE), EINVAL);
  EXPECT_EQ(number_of(SQLITE_CORRUPT), -1);
  EXPECT_EQ(number_of(SQLITE_NOTADB), -1);
  try {
    throw_sqlite_error(nullptr, SQLITE_FULL, "cannot write");
  } catch (const IoError& error) {
    EXPECT_STREQ(error.what(),
                 "database: cannot write (database or disk is full): No space left "
                 "on device");
    EXPECT_EQ(error.code(), ExitCode::out_of_resources);
  }
}

}  // namespace
}  // namespace tetfarm
