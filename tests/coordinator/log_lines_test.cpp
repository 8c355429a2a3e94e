#include "coordinator/log_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>

#include <algorithm>
#include <sstream>

namespace tetfarm {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class LogLines : public testing::Test {
 protected:
  LogLines() : log_("farm", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)) {
    log_.set_formatter(one_line_formatter());
  }

  std::ostringstream text_;
  spdlog::logger log_;
};

TEST_F(LogLines, are_the_usual_ones) {
  log_.info("job {} of {} € is done", 7, "Flügel");
  EXPECT_THAT(text_.str(), EndsWith("[farm] [info] job 7 of Flügel € is done\n"));
}

TEST_F(LogLines, cannot_be_forged) {
  log_.warn("job {}", "x\n[2026-01-01 00:00:00.000] [farm] [info] all is well\x1b[2J\xff");
  const std::string said = text_.str();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_THAT(said, HasSubstr("job x\\n[2026-01-01"));
  EXPECT_THAT(said, EndsWith("all is well\\u001b[2J\\xff\n"));
}

}  // namespace
}  // namespace tetfarm
