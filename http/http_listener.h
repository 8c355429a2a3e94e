/// The socket on which an HTTP server of ours waits for connections.
#pragma once

#include <string>

namespace tetfarm {

/// Holds a listening socket that never blocks; closes it.
class HttpListener {
 public:
  /// Listens at "127.0.0.1:8080", "[::1]:0" (any free port), "localhost:8080"; no other names.
  /// @param has_token whether the server asks for a token
  /// @throws UsageError when the address is malformed or not free, or when other hosts can reach it
  /// and there is no token; IoError.
  HttpListener(const std::string& address, bool has_token);
  ~HttpListener();
  HttpListener(const HttpListener&) = delete;
  HttpListener& operator=(const HttpListener&) = delete;

  int descriptor() const { return descriptor_; }
  /// "127.0.0.1:8080", as bound.
  const std::string& address() const { return address_; }
  bool is_version_6() const { return address_.starts_with("["); }

 private:
  int descriptor_ = -1;
  std::string address_;
};

}  // namespace tetfarm
