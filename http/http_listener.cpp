#include "http/http_listener.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "base/check.h"
#include "base/error.h"
#include "proto/local_endpoint.h"

namespace tetfarm {
namespace {

constexpr int backlog = 64;

struct FreeAddresses {
  void operator()(addrinfo* list) const { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

/// @throws UsageError unless it is numbers (or localhost), a colon and a port.
Addresses resolve(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.starts_with("[") && host.ends_with("]")) host = host.substr(1, host.size() - 2);
  if (host == "localhost") host = "127.0.0.1";
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (colon == std::string::npos || host.empty() ||
      ::getaddrinfo(host.c_str(), address.c_str() + colon + 1, &hints, &found) != 0) {
    throw UsageError("is not an address and port such as 127.0.0.1:8080", address);
  }
  return Addresses(found);
}

std::string bound_address(int socket) {
  sockaddr_storage storage{};
  socklen_t size = sizeof storage;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&storage), &size);
  ::getnameinfo(reinterpret_cast<sockaddr*>(&storage), size, host.data(), host.size(), port.data(),
                port.size(), NI_NUMERICHOST | NI_NUMERICSERV);
  const std::string name = host.data();
  return (name.find(':') == std::string::npos ? name : "[" + name + "]") + ":" + port.data();
}

int listen_at(const std::string& address, const addrinfo& where) {
  const int fd =
      ::socket(where.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, where.ai_protocol);
  if (fd < 0) throw IoError("cannot create a socket", address, errno);
  const int yes = 1;
  ::setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(fd, where.ai_addr, where.ai_addrlen) == 0 && ::listen(fd, backlog) == 0) return fd;
  const std::string why = std::strerror(errno);
  ::close(fd);
  throw UsageError("cannot listen: " + why, address);
}

}  // namespace

HttpListener::HttpListener(const std::string& address, bool has_token) {
  const Addresses where = resolve(address);
  if (!has_token && !is_local("tcp://" + address)) {
    throw UsageError("other hosts can connect: give a file with a token (--http-token)", address);
  }
  descriptor_ = listen_at(address, *where);
  address_ = bound_address(descriptor_);
  TF_CHECK(descriptor_ >= 0);
}

HttpListener::~HttpListener() { ::close(descriptor_); }

}  // namespace tetfarm
