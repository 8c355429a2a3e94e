// Databases that can be read and not written to. Permissions do not bind root, so root becomes
// somebody else for these tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/support/failing_writes.h"

namespace tetfarm {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr uid_t nobody = 65534;

/// While it lives, the effective user is nobody where it was root.
class WithoutPrivileges {
 public:
  WithoutPrivileges() { become(nobody); }
  ~WithoutPrivileges() { become(0); }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

 private:
  static void become(uid_t user) {
    if (::getuid() != 0) return;
    EXPECT_EQ(::seteuid(user), 0);
  }
};

class ReadOnlyDatabase : public testing::Test {
 protected:
  ReadOnlyDatabase() {
    ::chmod(folder_.path().c_str(), 0777);
    { const JobDatabase database(path_); }
    ::chmod(path_.c_str(), 0666);
  }
  auto opening() const {
    return [this] {
      const WithoutPrivileges somebody;
      const JobDatabase database(path_);
    };
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "tetfarm.db";
};

TEST_F(ReadOnlyDatabase, of_which_the_file_may_not_be_written_to_is_refused_when_it_is_opened) {
  EXPECT_NO_THROW(opening()());
  ::chmod(path_.c_str(), 0444);
  EXPECT_THAT(opening(), ThrowsMessage<IoError>(AllOf(
                             HasSubstr(path_.string()), HasSubstr("can be read but not written to"),
                             HasSubstr("--database DIR"), HasSubstr("Permission denied"))));
}

TEST_F(ReadOnlyDatabase, of_which_the_folder_may_not_be_written_to_is_refused_too) {
  ::chmod(folder_.path().c_str(), 0555);
  EXPECT_THROW(opening()(), IoError);
  ::chmod(folder_.path().c_str(), 0777);
}

TEST_F(ReadOnlyDatabase, whose_disk_takes_no_writes_is_found_out_by_trying) {
  const test::FailingWrites disk(EROFS);
  EXPECT_THAT([this] { const JobDatabase database(path_); },
              ThrowsMessage<IoError>(AllOf(HasSubstr("can be read but not written to"),
                                           HasSubstr("Read-only file system"))));
}

TEST_F(ReadOnlyDatabase, that_becomes_so_later_says_so_and_takes_writes_again_afterwards) {
  JobDatabase database(path_);
  database.try_to_write();
  {
    const test::FailingWrites disk(EROFS);
    try {
      database.try_to_write();
      ADD_FAILURE() << "written to a disk that takes no writes";
    } catch (const IoError& error) {
      EXPECT_EQ(error.error_number(), EROFS);
    }
  }
  database.try_to_write();
}

}  // namespace
}  // namespace tetfarm
