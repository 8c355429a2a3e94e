#include "store/folder_lock.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class FolderLocks : public ::testing::Test {
 protected:
  FolderLocks() {
    std::string name = (std::filesystem::temp_directory_path() / "folder_lock-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~FolderLocks() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(FolderLocks, who_has_it_is_told_by_process_and_host) {
  EXPECT_FALSE(FolderLock::holder(folder_, "a.lock"));
  const std::optional<FolderLock> lock = FolderLock::take(folder_, "a.lock");
  ASSERT_TRUE(lock);
  EXPECT_FALSE(FolderLock::take(folder_, "a.lock"));
  const std::optional<LockHolder> holder = FolderLock::holder(folder_, "a.lock");
  ASSERT_TRUE(holder);
  EXPECT_EQ(holder->process, ::getpid());
  EXPECT_TRUE(holder->may_live());
  EXPECT_EQ(holder->text(), "process " + std::to_string(::getpid()) + " on " + holder->host);
}

TEST_F(FolderLocks, nobody_has_it_when_it_was_let_go) {
  FolderLock::take(folder_, "a.lock");
  EXPECT_FALSE(FolderLock::holder(folder_, "a.lock"));
}

TEST_F(FolderLocks, unsigned_leaves_a_file_as_it_is_and_keeps_others_out) {
  const std::filesystem::path file = folder_ / "result.part";
  write_file_atomically(file, "half a mesh");
  {
    const std::optional<FolderLock> lock = FolderLock::take_unsigned(file);
    ASSERT_TRUE(lock);
    EXPECT_FALSE(FolderLock::take_unsigned(file));
    EXPECT_EQ(read_file(file), "half a mesh");
  }
  EXPECT_EQ(read_file(file), "half a mesh");
  EXPECT_TRUE(FolderLock::take_unsigned(file));
}

TEST_F(FolderLocks, of_a_store_names_the_coordinator_that_is_there) {
  const FolderLock lock = FolderLock::of_store(folder_);
  EXPECT_THAT([&] { FolderLock::of_store(folder_); },
              ThrowsMessage<UsageError>(HasSubstr("another coordinator is using this store: "
                                                  "process " +
                                                  std::to_string(::getpid()))));
}

TEST_F(FolderLocks, who_died_without_letting_go_does_not_live) {
  const FolderLock lock = FolderLock::of_store(folder_);
  LockHolder holder = FolderLock::holder_of_store(folder_).value();
  holder.process = 0x7fffffff;  // above every process number of Linux
  EXPECT_FALSE(holder.may_live());
  holder.host = "another-host";
  EXPECT_TRUE(holder.may_live());
}

TEST_F(FolderLocks, a_note_that_nobody_of_us_wrote_names_nobody) {
  for (const std::string note : {"", "x", "12", "-3 host\n", "0 host\n", "12 \x1b[31mhost\n",
                                 "99999999999999999999 host\n"}) {
    write_file_atomically(folder_ / "a.lock", note);
    EXPECT_FALSE(FolderLock::holder(folder_, "a.lock")) << note;
  }
}

}  // namespace
}  // namespace tetfarm
