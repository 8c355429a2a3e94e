#include "base/file_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <set>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/support/seen_syncs.h"

namespace tetfarm {
namespace {

using test::SeenSyncs;
using testing::ElementsAre;
using testing::SizeIs;

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

TEST(FileSystem, a_file_in_the_making_has_its_old_bytes_again_when_more_do_not_fit) {
  const TempFolder folder;
  const auto path = folder.path() / "growing";
  const std::string begun(4000, 'a');
  append_to_file(path, 0, begun);
  EXPECT_TRUE(
      runs_out_of_room([&] { append_to_file(path, begun.size(), std::string(1000, 'b')); }));
  EXPECT_EQ(read_file(path), begun);
  append_to_file(path, begun.size(), "more");
  EXPECT_EQ(read_file(path), begun + "more");
}

/// The file under another name, before it has its own, then the folder with its name in it.
void expect_synced_before_and_after_it_is_named(const SeenSyncs& syncs,
                                                const std::filesystem::path& path) {
  ASSERT_THAT(syncs.all(), SizeIs(2));
  EXPECT_EQ(syncs.all()[0].path.parent_path(), path.parent_path());
  EXPECT_NE(syncs.all()[0].path, path);
  EXPECT_EQ(syncs.all()[1].path, path.parent_path());
  EXPECT_THAT(syncs.all()[1].names, ElementsAre(path.filename().string()));
}

TEST(FileSystem, a_file_is_on_the_disk_before_it_has_its_name_and_its_name_before_it_is_told) {
  const TempFolder folder;
  const auto path = folder.path() / "a";
  {
    const SeenSyncs syncs;
    write_file_atomically(path, "bytes");
    expect_synced_before_and_after_it_is_named(syncs, path);
  }
  const SeenSyncs syncs;
  publish_by_rename(path, folder.path() / "b");
  expect_synced_before_and_after_it_is_named(syncs, folder.path() / "b");
}

TEST(FileSystem, a_folder_that_is_made_and_a_link_are_on_the_disk) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a", "bytes");
  {
    const SeenSyncs syncs;
    link_or_copy_file(folder.path() / "a", folder.path() / "b");
    ASSERT_THAT(syncs.all(), SizeIs(1));
    EXPECT_THAT(syncs.all()[0].names, ElementsAre("a", "b"));
  }
  const SeenSyncs syncs;
  make_folders(folder.path() / "c");
  ASSERT_THAT(syncs.all(), SizeIs(1));
  EXPECT_THAT(syncs.all()[0].names, ElementsAre("a", "b", "c"));
}

TEST(FileSystem, folders_in_folders_that_are_made_are_on_the_disk_each) {
  const TempFolder folder;
  const SeenSyncs syncs;
  make_folders(folder.path() / "a/b/c");
  EXPECT_TRUE(syncs.has(folder.path() / "a/b"));
  EXPECT_TRUE(syncs.has(folder.path() / "a"));
  EXPECT_TRUE(syncs.has(folder.path()));
  make_folders(folder.path() / "a/b/c");
  EXPECT_THAT(syncs.all(), SizeIs(3)) << "what is there is not synced again";
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
  const SeenSyncs syncs;
  link_or_copy_file(folder.path() / "a", std::filesystem::path(other) / "b");
  EXPECT_EQ(read_file(std::filesystem::path(other) / "b"), "new");
  expect_synced_before_and_after_it_is_named(syncs, std::filesystem::path(other) / "b");
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

TEST(FileSystem, a_file_that_cannot_be_written_is_told_by_its_own_name) {
  const TempFolder folder;
  const auto path = folder.path() / "none" / "a.stl";
  try {
    write_file_atomically(path, "x");
    ADD_FAILURE();
  } catch (const IoError& error) {
    EXPECT_EQ(error.what(), path.string() + ": cannot open: No such file or directory");
  }
}

TEST(FileSystem, a_folder_of_temporary_files_that_is_not_there_is_told_with_the_variable) {
  const TempFolder folder;
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/nowhere/at/all", 1);
  try {
    temporary_folder();
    ADD_FAILURE();
  } catch (const IoError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "/nowhere/at/all: cannot put temporary files there, where $TMPDIR wants them: No such "
        "file or directory");
  }
  ::setenv("TMPDIR", folder.path().c_str(), 1);
  EXPECT_EQ(temporary_folder(), folder.path());
  before != nullptr ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
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

TEST(FileSystem, reads_a_part_of_a_file_as_far_as_there_is_one) {
  const TempFolder folder;
  const auto path = folder.path() / "a";
  write_file_atomically(path, "0123456789");
  EXPECT_EQ(read_part_of_file(path, 0, 4), "0123");
  EXPECT_EQ(read_part_of_file(path, 4, 3), "456");
  EXPECT_EQ(read_part_of_file(path, 8, 5), "89");
  EXPECT_EQ(read_part_of_file(path, 10, 5), "");
  EXPECT_EQ(read_part_of_file(path, 20, 5), "");
  EXPECT_EQ(read_part_of_file(path, 3, 0), "");
  const std::string large = std::string(200'000, 'x') + "end";
  write_file_atomically(path, large);
  EXPECT_EQ(read_file(path), large);
  EXPECT_EQ(read_part_of_file(path, 199'999, 10), "xend");
  EXPECT_EQ(size_of_file(path), 200'003U);
}

TEST(FileSystem, what_fails_is_told_with_the_path_and_what_was_tried) {
  const TempFolder folder;
  const std::string none = (folder.path() / "none/file").string();
  const std::string file = (folder.path() / "file").string();
  write_file_atomically(file, "");
  const auto told = [](const auto& action) -> std::string {
    try {
      action();
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  const std::string missing = ": cannot open: No such file or directory";
  EXPECT_EQ(told([&] { read_file(none); }), none + missing);
  EXPECT_EQ(told([&] { read_part_of_file(none, 0, 1); }), none + missing);
  EXPECT_EQ(told([&] { append_to_file(none, 0, "x"); }), none + missing);
  EXPECT_EQ(told([&] { publish_by_rename(file, none); }),
            none + ": cannot rename " + file + " to it: No such file or directory");
  EXPECT_EQ(told([&] { make_folders(file + "/a"); }),
            file + "/a: cannot create the folder: Not a directory");
  EXPECT_EQ(told([&] { remove_file(folder.path()); }),
            folder.path().string() + ": cannot remove: Is a directory");
  EXPECT_EQ(told([&] { remove_file(none); }), "");
  EXPECT_FALSE(size_of_file(file + "/a")) << "there is none below a file";
  EXPECT_EQ(told([&] { size_of_file(folder.path() / std::string(300, 'x')); }),
            (folder.path() / std::string(300, 'x')).string() + ": cannot stat: File name too long");
}

TEST(FileSystem, temporary_names_begin_with_the_stem_cut_to_what_file_systems_take) {
  EXPECT_THAT(unique_temp_name("mesh"),
              testing::MatchesRegex("mesh\\." + std::to_string(::getpid()) + "\\.[0-9a-f]+\\.tmp"));
  EXPECT_TRUE(unique_temp_name(std::string(300, 's')).starts_with(std::string(200, 's') + "."));
}

TEST(FileSystem, new_files_may_be_read_by_all_and_written_by_their_owner) {
  const TempFolder folder;
  const mode_t old = ::umask(0);
  write_file_atomically(folder.path() / "a", "x");
  append_to_file(folder.path() / "b", 0, "x");
  ::umask(old);
  for (const char* name : {"a", "b"}) {
    EXPECT_EQ(std::filesystem::status(folder.path() / name).permissions(),
              static_cast<std::filesystem::perms>(0644))
        << name;
  }
}

}  // namespace
}  // namespace tetfarm
