/// The dashboard's HTTP/1.1 server: one thread, which asks its site for answers and sends them, and
/// which keeps those told who watch (server-sent events).
///
/// Everything is bounded: connections, those of one address, the size of a request's head, the time
/// until it is there, the time that its answer may wait for its reader, what a watcher has not read
/// yet, and all answers under way together. Requests have no bodies. Who holds a place without
/// using it gives it up when another wants it (http/http_places.h), and some places are for short
/// answers alone: slow or idle clients, however many, keep nobody out. Boost.Beast reads the
/// requests; no other file knows of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "dashboard/web_request.h"
#include "http/http_listener.h"

namespace tetfarm {

struct WebAnswer {
  int status = 200;
  std::string type = "application/json; charset=utf-8";
  std::shared_ptr<const std::string> body;
  bool is_stream = false;  ///< the body is what a watcher is told first
};

class WebSite {
 public:
  using Answering = std::function<void(WebAnswer)>;
  virtual ~WebSite() = default;
  /// Calls `done` once, now or later, in any thread. In the server's thread; must not wait.
  virtual void answer(const WebRequest& request, Answering done) = 0;
  /// So many watch now.
  virtual void note_watchers(std::size_t count) = 0;
};

struct WebLimits {
  std::size_t connections = 240;
  std::size_t reserved = 16;    ///< more of them, for short answers only
  std::size_t of_address = 32;  ///< of one other host; this one may speak for many
  std::size_t watchers = 200;
  std::size_t head_bytes = 8192;
  std::size_t short_bytes = std::size_t{64} << 10U;    ///< of an answer that is short
  std::size_t unread_bytes = std::size_t{4} << 20U;    ///< by one watcher
  std::size_t answer_bytes = std::size_t{256} << 20U;  ///< of all answers under way
  std::int64_t request_ms = 5'000;                     ///< until the head is there
  std::int64_t thought_ms = 30'000;                    ///< until the site has the answer
  std::int64_t deaf_ms = 10'000;                       ///< without anything being read of an answer
  std::int64_t answer_ms = 60'000;                     ///< until all of an answer is read
  std::int64_t idle_ms = 30'000;                       ///< between two requests of a connection
  std::int64_t alive_ms = 15'000;                      ///< between two signs of life for watchers
};

class WebServer {
 public:
  /// @pre both outlive it. @throws IoError.
  WebServer(const HttpListener& listener, WebSite& site, const WebLimits& limits);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Serves from now on, in a thread of its own.
  void start();
  /// Tells all who watch; from any thread, also before start() and after stop().
  void publish(std::string messages);
  /// Ends all connections; the site is not asked any more. What is answered later is dropped.
  void stop();

 private:
  class Hall;
  std::unique_ptr<Hall> hall_;
};

}  // namespace tetfarm
