#include "base/error.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace tetfarm {
namespace {

TEST(Error, kinds_carry_the_documented_exit_codes) {
  EXPECT_EQ(InvalidInput("open surface", "a.stl:3").code(), ExitCode::bad_geometry);
  EXPECT_EQ(UsageError("unknown key", "job.toml:2:1").code(), ExitCode::usage);
  EXPECT_EQ(CorruptFile("bad magic", "x").code(), ExitCode::failed);
  EXPECT_EQ(static_cast<int>(ExitCode::stopped_at_checkpoint), 75);
}

TEST(Error, messages_say_where_then_what) {
  EXPECT_STREQ(InvalidInput("open surface", "a.stl:3").what(), "a.stl:3: open surface");
  EXPECT_STREQ(InvalidInput("open surface", "").what(), "open surface");
  EXPECT_STREQ(UsageError("unknown key", "").what(), "unknown key");
  EXPECT_STREQ(CorruptFile("bad magic", "x").what(), "x: bad magic");
}

TEST(InvalidInput, keeps_the_triangles_it_names) {
  EXPECT_EQ(InvalidInput("flat", "a", {4, 7}).triangles(), (std::vector<std::int64_t>{4, 7}));
}

TEST(IoError, tells_a_full_disk_and_a_missing_file_from_other_failures) {
  for (const int full : {ENOSPC, EDQUOT, EFBIG, ENOMEM}) {
    EXPECT_EQ(IoError("write", "f", full).code(), ExitCode::out_of_resources);
  }
  EXPECT_EQ(IoError("open", "f", ENOENT).code(), ExitCode::not_found);
  EXPECT_EQ(IoError("open", "f", EACCES).code(), ExitCode::failed);
  EXPECT_EQ(IoError("open", "f", EIO).error_number(), EIO);
  EXPECT_EQ(std::string(IoError("cannot open", "f", ENOENT).what()),
            "f: cannot open: No such file or directory");
}

}  // namespace
}  // namespace tetfarm
