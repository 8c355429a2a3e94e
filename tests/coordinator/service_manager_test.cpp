#include "coordinator/service_manager.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <map>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

/// What systemd would be: a socket that hears the lines.
class FakeSystemd {
 public:
  explicit FakeSystemd(const std::string& name)
      : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un where{};
    where.sun_family = AF_UNIX;
    std::memcpy(where.sun_path, name.data(), name.size());
    if (name[0] == '@') where.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&where), size), 0);
  }
  ~FakeSystemd() { ::close(socket_); }
  /// The next datagram, "" when there is none.
  std::string hear() const {
    char buffer[500];
    const ssize_t n = ::recv(socket_, buffer, sizeof buffer, MSG_DONTWAIT);
    return n < 0 ? "" : std::string(buffer, static_cast<std::size_t>(n));
  }

 private:
  int socket_;
};

ServiceManager::Environment environment(std::map<std::string, std::string> values) {
  return [values](const char* name) {
    const auto found = values.find(name);
    return found == values.end() ? "" : found->second;
  };
}

TEST(ServiceManager, says_when_it_is_ready_that_it_turns_and_when_it_stops) {
  const TempFolder folder;
  const std::string path = folder.path() / "notify";
  const FakeSystemd systemd(path);
  ServiceManager service(environment({{"NOTIFY_SOCKET", path},
                                      {"WATCHDOG_USEC", "2000000"},
                                      {"WATCHDOG_PID", std::to_string(::getpid())}}));
  service.ready("listening on tcp://*:5555");
  EXPECT_EQ(systemd.hear(), "READY=1\nSTATUS=listening on tcp://*:5555\n");
  service.turn(5000);
  EXPECT_EQ(systemd.hear(), "WATCHDOG=1\n");
  service.turn(5900);
  EXPECT_EQ(systemd.hear(), "") << "half of WatchdogSec has not passed";
  service.turn(6000);
  EXPECT_EQ(systemd.hear(), "WATCHDOG=1\n");
  service.stopping();
  EXPECT_EQ(systemd.hear(), "STOPPING=1\n");
}

TEST(ServiceManager, finds_a_socket_that_lies_in_no_folder) {
  const std::string name = "@tetfarm-test-" + std::to_string(::getpid());
  const FakeSystemd systemd(name);
  ServiceManager(environment({{"NOTIFY_SOCKET", name}})).ready("x");
  EXPECT_EQ(systemd.hear(), "READY=1\nSTATUS=x\n");
}

TEST(ServiceManager, is_silent_without_a_socket_or_when_the_watchdog_is_anothers) {
  ServiceManager nobody(environment({}));
  nobody.ready("x");
  nobody.turn(1);
  nobody.stopping();
  ServiceManager(environment({{"NOTIFY_SOCKET", "relative"}})).ready("x");
  ServiceManager(environment({{"NOTIFY_SOCKET", "/nowhere/at/all"}})).ready("x");
  const TempFolder folder;
  const std::string path = folder.path() / "notify";
  const FakeSystemd systemd(path);
  ServiceManager other(
      environment({{"NOTIFY_SOCKET", path}, {"WATCHDOG_USEC", "2000000"}, {"WATCHDOG_PID", "1"}}));
  other.turn(5000);
  EXPECT_EQ(systemd.hear(), "");
}

}  // namespace
}  // namespace tetfarm
