#include "cli/passing_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "base/error.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using std::filesystem::exists;

TEST(PassingFile, is_there_as_long_as_its_object) {
  const TempFolder folder;
  std::filesystem::path place;
  {
    const PassingFile file(folder.path());
    place = file.path();
    EXPECT_EQ(place.parent_path(), folder.path());
    EXPECT_EQ(std::filesystem::file_size(place), 0U);
  }
  EXPECT_FALSE(exists(place));
}

TEST(PassingFile, goes_with_the_object_that_it_was_moved_to) {
  const TempFolder folder;
  PassingFile last;
  EXPECT_EQ(last.path(), "");
  std::filesystem::path place;
  {
    PassingFile first(folder.path());
    place = first.path();
    PassingFile second(std::move(first));
    EXPECT_EQ(second.path(), place);
    last = std::move(second);
  }
  EXPECT_EQ(last.path(), place);
  EXPECT_TRUE(exists(place));
  last = PassingFile();
  EXPECT_FALSE(exists(place));
}

TEST(PassingFile, is_gone_with_its_process_however_that_ends) {
  const TempFolder folder;
  const pid_t process = ::fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    const PassingFile file(folder.path());
    ::raise(SIGKILL);
    ::_exit(0);
  }
  ::waitpid(process, nullptr, 0);
  for (int i = 0; i < 500 && !std::filesystem::is_empty(folder.path()); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(PassingFile, is_not_made_in_a_folder_that_is_not_there) {
  const TempFolder folder;
  const std::filesystem::path nowhere = folder.path() / "nowhere";
  try {
    const PassingFile file(nowhere);
    FAIL() << "made " << file.path();
  } catch (const IoError& error) {
    EXPECT_EQ(std::string(error.what()),
              nowhere.string() + ": cannot create a file in: No such file or directory");
    EXPECT_EQ(error.code(), ExitCode::not_found);
  }
}

}  // namespace
}  // namespace tetfarm
