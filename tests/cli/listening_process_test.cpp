#include "cli/listening_process.h"

#include <unistd.h>

#include "tests/cli/plain_listener.h"

namespace tetfarm {
namespace {

TEST(ListeningProcess, is_found_by_its_port) {
  test::PlainListener listener;
  const auto found = process_that_listens(listener.port());
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->process, ::getpid());
  EXPECT_NE(found->command.find("cli_test"), std::string::npos) << found->command;
  const std::uint16_t port = listener.port();
  listener.end();
  EXPECT_FALSE(process_that_listens(port).has_value());
}

}  // namespace
}  // namespace tetfarm
