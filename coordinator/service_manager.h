/// Tells systemd that the coordinator is ready, that it still turns, and that it stops.
///
/// The protocol of sd_notify(3): a datagram of lines to the socket that $NOTIFY_SOCKET names.
/// Without that variable all of this does nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace tetfarm {

class ServiceManager {
 public:
  /// The value of an environment variable, "" when it is not set.
  using Environment = std::function<std::string(const char* name)>;
  explicit ServiceManager(const Environment& environment);
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  /// Clients may come; `status` is a line for `systemctl status`.
  void ready(const std::string& status);
  /// Call it in every turn: it speaks when half of WatchdogSec has passed since the last time.
  void turn(std::int64_t now_ms);
  void stopping();

 private:
  void say(const std::string& lines) const;

  std::string socket_name_;
  int socket_ = -1;
  std::int64_t every_ms_ = 0;  ///< 0: no watchdog
  std::int64_t next_ms_ = 0;
};

}  // namespace tetfarm
