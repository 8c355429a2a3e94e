/// A small HTTP server for people's eyes and for Prometheus: GET and HEAD of a few pages, nothing
/// else.
///
/// It has no thread: the coordinator's loop polls its sockets, so that an answer means that the
/// loop turns. Nothing here waits. Everything is bounded: connections, those of one address, the
/// size of a request, the time until it is complete, the time of an exchange. One request a
/// connection. Who holds a place without using it gives it up when another wants it, and some
/// places are for /healthz and /readyz alone: slow or idle clients, however many, keep nobody out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "http/http_listener.h"
#include "http/http_places.h"

namespace tetfarm {

struct HttpOptions {
  std::string address;               ///< "127.0.0.1:8080", "[::1]:0": any free port
  std::filesystem::path token_file;  ///< "": no token; only loopback addresses then
  std::size_t max_connections = 64;
  std::size_t reserved = 8;         ///< more of them, for /healthz and /readyz only
  std::size_t max_of_address = 16;  ///< of one other host; this one may speak for many
  std::size_t max_request_bytes = 8192;
  std::int64_t request_ms = 5'000;    ///< from the connection to the end of the request
  std::int64_t exchange_ms = 10'000;  ///< from the connection to the end of the answer
};

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
};

/// What a request came to before any page is made of it.
struct HttpRequest {
  int refusal = 0;  ///< 400, 401, 403, 405; 0: it is fine
  bool is_head = false;
  std::string path;  ///< without what follows '?'
};

/// Reads a whole request head (up to and with the empty line). `token` "": none is asked for, and
/// the request must name this host by a loopback name. /healthz is open to all.
HttpRequest parse_http_request(const std::string& head, const std::string& token);

class HttpServer {
 public:
  using Pages = std::function<HttpAnswer(const std::string& path)>;

  /// Listens. @throws UsageError when the address is malformed or not free, when other hosts can
  /// reach it and there is no token, or when the token is short or others may read it.
  explicit HttpServer(const HttpOptions& options);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// "127.0.0.1:8080", as bound.
  const std::string& address() const { return listener_.address(); }
  void add_poll_items(std::vector<zmq::pollitem_t>& items) const;
  /// Does what can be done without waiting.
  void serve(std::int64_t now_ms, const Pages& pages);
  std::size_t connections() const { return exchanges_.size(); }

 private:
  struct Exchange {
    std::string request;
    std::string answer;
    std::size_t sent = 0;
    bool is_over = false;      ///< only the other side's end is waited for
    bool is_reserved = false;  ///< its place is for /healthz and /readyz
    std::string peer;
    std::int64_t begun_ms = 0;
    std::int64_t heard_ms = 0;  ///< when it last took a part of the answer
    std::int64_t ends_ms = 0;
  };
  void accept_all(std::int64_t now_ms, const Pages& pages);
  bool find_place(Exchange& newcomer, std::int64_t now_ms);
  bool make_way(const std::vector<HttpPlace>& places, std::int64_t now_ms);
  std::vector<HttpPlace> places(bool reserved) const;
  bool serve_one(int fd, Exchange& exchange, std::int64_t now_ms, const Pages& pages) const;
  bool go_on(int fd, Exchange& exchange, std::int64_t now_ms, const Pages& pages) const;
  void answer(Exchange& exchange, const Pages& pages) const;

  HttpOptions options_;
  std::string token_;
  HttpListener listener_;
  std::map<int, Exchange> exchanges_;  ///< by file descriptor
};

}  // namespace tetfarm
