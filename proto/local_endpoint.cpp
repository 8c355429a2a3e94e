#include "proto/local_endpoint.h"

#include <arpa/inet.h>

#include <string_view>

namespace tetfarm {

bool is_ipc(const std::string& endpoint) {
  return endpoint.starts_with("ipc://") || endpoint.starts_with("inproc://");
}

bool is_local(const std::string& endpoint) {
  constexpr std::string_view tcp = "tcp://";
  if (!endpoint.starts_with(tcp)) return is_ipc(endpoint);
  const std::string host = endpoint.substr(tcp.size(), endpoint.rfind(':') - tcp.size());
  if (host == "localhost" || host == "[::1]") return true;
  in_addr address{};  // not a name that only begins like one: 127.example.org
  return host.starts_with("127.") && ::inet_pton(AF_INET, host.c_str(), &address) == 1;
}

}  // namespace tetfarm
