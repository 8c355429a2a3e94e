#include "base/file_system.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <set>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(FileSystem, writes_and_replaces_a_whole_file) {
  const TempFolder folder;
  const auto path = folder.path() / "a";
  write_file_atomically(path, "first");
  write_file_atomically(path, std::string("sec\0nd", 6));
  EXPECT_EQ(read_file(path), std::string("sec\0nd", 6));
  EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(FileSystem, a_missing_file_is_told_by_its_name) {
  const TempFolder folder;
  try {
    read_file(folder.path() / "nothing");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
    EXPECT_NE(std::string(error.what()).find("nothing"), std::string::npos);
  }
  EXPECT_FALSE(size_of_file(folder.path() / "nothing"));
}

/// Runs `action` in a child whose files may not grow beyond 4096 bytes; true when it threw an error
/// of the resources.
template <class Action>
bool runs_out_of_room(const Action& action) {
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      action();
    } catch (const IoError& error) {
      _exit(error.code() == ExitCode::out_of_resources ? 42 : 1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 42;
}

TEST(FileSystem, a_full_disk_leaves_the_old_file_and_nothing_else) {
  const TempFolder folder;
  const auto path = folder.path() / "a";
  write_file_atomically(path, "old");
  EXPECT_TRUE(runs_out_of_room([&] { write_file_atomically(path, std::string(100000, 'x')); }));
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(count_files(folder.path()), 1U);
}

TEST(FileSystem, links_or_copies_over_an_older_file) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a", "new");
  write_file_atomically(folder.path() / "b", "old");
  link_or_copy_file(folder.path() / "a", folder.path() / "b");
  link_or_copy_file(folder.path() / "a", folder.path() / "b");
  EXPECT_EQ(read_file(folder.path() / "b"), "new");
  EXPECT_EQ(count_files(folder.path()), 2U);
}

TEST(FileSystem, copies_to_another_file_system) {
  const TempFolder folder;
  std::string other = "/dev/shm/tetfarm_test.XXXXXX";
  if (mkdtemp(other.data()) == nullptr) GTEST_SKIP() << "no /dev/shm";
  write_file_atomically(folder.path() / "a", "new");
  link_or_copy_file(folder.path() / "a", std::filesystem::path(other) / "b");
  EXPECT_EQ(read_file(std::filesystem::path(other) / "b"), "new");
  std::filesystem::remove_all(other);
}

TEST(FileSystem, makes_folders_and_removes_files_also_when_that_is_done) {
  const TempFolder folder;
  make_folders(folder.path() / "a" / "b");
  make_folders(folder.path() / "a" / "b");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a" / "b"));
  remove_file(folder.path() / "a" / "nothing");
  write_file_atomically(folder.path() / "file", "");
  EXPECT_THROW(make_folders(folder.path() / "file" / "c"), IoError);
}

TEST(FileSystem, temporary_names_are_never_the_same) {
  std::set<std::string> names;
  for (int i = 0; i < 1000; ++i) names.insert(unique_temp_name("x"));
  EXPECT_EQ(names.size(), 1000U);
}

TEST(FileSystem, takes_names_as_long_as_the_file_system_does) {
  const TempFolder folder;
  const auto path = folder.path() / std::string(255, 'n');
  write_file_atomically(path, "bytes");
  EXPECT_EQ(read_file(path), "bytes");
}

}  // namespace
}  // namespace tetfarm
