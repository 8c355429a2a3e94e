#include "coordinator/service_manager.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace tetfarm {
namespace {

std::int64_t number_in(const std::string& text) {
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

ServiceManager::ServiceManager(const Environment& environment)
    : socket_name_(environment("NOTIFY_SOCKET")) {
  // A path, or a name that begins with @ and lies in no folder.
  const bool is_name = socket_name_.starts_with("/") || socket_name_.starts_with("@");
  if (!is_name || socket_name_.size() >= sizeof(sockaddr_un{}.sun_path)) return;
  socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const std::string process = environment("WATCHDOG_PID");
  if (!process.empty() && number_in(process) != ::getpid()) return;
  every_ms_ = number_in(environment("WATCHDOG_USEC")) / 2000;
}

ServiceManager::~ServiceManager() {
  if (socket_ >= 0) ::close(socket_);
}

void ServiceManager::say(const std::string& lines) const {
  if (socket_ < 0) return;
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  std::copy(socket_name_.begin(), socket_name_.end(), where.sun_path);
  if (where.sun_path[0] == '@') where.sun_path[0] = '\0';
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket_name_.size());
  // Nobody listens, or too slowly: the next beat tells it again.
  [[maybe_unused]] const auto sent = ::sendto(socket_, lines.data(), lines.size(), MSG_NOSIGNAL,
                                              reinterpret_cast<const sockaddr*>(&where), size);
}

void ServiceManager::ready(const std::string& status) { say("READY=1\nSTATUS=" + status + "\n"); }

void ServiceManager::turn(std::int64_t now_ms) {
  if (every_ms_ == 0 || now_ms < next_ms_) return;
  next_ms_ = now_ms + every_ms_;
  say("WATCHDOG=1\n");
}

void ServiceManager::stopping() { say("STOPPING=1\n"); }

}  // namespace tetfarm
