#include "coordinator/views/http_server.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <utility>

#include "base/check.h"
#include "http/http_access.h"

namespace tetfarm {
namespace {

constexpr int most_accepted = 256;  // in one turn
constexpr int most_reads = 16;      // of a connection in one turn
constexpr std::int64_t last_words_ms = 1'000;

const char* reason_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 401:
      return "Unauthorized";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 431:
      return "Request Header Fields Too Large";
    default:
      return "Service Unavailable";
  }
}

std::string worded(const HttpAnswer& answer, bool is_head) {
  TF_CHECK(answer.status >= 200 && answer.status < 600);
  std::string text = "HTTP/1.1 " + std::to_string(answer.status) + " " + reason_of(answer.status) +
                     "\r\nContent-Type: " + answer.type +
                     "\r\nContent-Length: " + std::to_string(answer.body.size()) +
                     "\r\nConnection: close\r\nCache-Control: no-store"
                     "\r\nX-Content-Type-Options: nosniff"
                     "\r\nContent-Security-Policy: default-src 'none'; style-src 'unsafe-inline'";
  if (answer.status == 401) text += "\r\nWWW-Authenticate: Basic realm=\"tetfarm\"";
  if (answer.status == 405) text += "\r\nAllow: GET, HEAD";
  return text + "\r\n\r\n" + (is_head ? "" : answer.body);
}

HttpAnswer refusal(int status) {
  return {status, "text/plain; charset=utf-8", std::string(reason_of(status)) + "\n"};
}

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

HttpServer::HttpServer(const HttpOptions& options)
    : options_(options),
      token_(read_http_token(options.token_file)),
      listener_(options.address, !token_.empty()) {}

HttpServer::~HttpServer() {
  for (const auto& [fd, exchange] : exchanges_) ::close(fd);
}

void HttpServer::add_poll_items(std::vector<zmq::pollitem_t>& items) const {
  items.push_back({nullptr, listener_.descriptor(), ZMQ_POLLIN, 0});
  for (const auto& [fd, exchange] : exchanges_) {
    const bool writes = !exchange.answer.empty() && !exchange.is_over;
    items.push_back({nullptr, fd, static_cast<short>(writes ? ZMQ_POLLOUT : ZMQ_POLLIN), 0});
  }
}

std::vector<HttpPlace> HttpServer::places(bool reserved) const {
  std::vector<HttpPlace> places;
  for (const auto& [fd, exchange] : exchanges_) {
    if (exchange.is_reserved != reserved) continue;
    const bool asks = exchange.answer.empty();
    places.push_back({.fd = fd,
                      .peer = exchange.peer,
                      .stage = exchange.is_over ? HttpPlace::Stage::over
                               : asks           ? HttpPlace::Stage::asks
                                                : HttpPlace::Stage::listens,
                      .since_ms = asks ? exchange.begun_ms : exchange.heard_ms});
  }
  return places;
}

/// Ends one of these exchanges; false when all are being served.
bool HttpServer::make_way(const std::vector<HttpPlace>& places, std::int64_t now_ms) {
  const std::optional<int> fd = who_gives_way(places, now_ms);
  if (!fd) return false;
  ::close(*fd);
  const std::size_t erased = exchanges_.erase(*fd);
  TF_CHECK(erased == 1);
  return true;
}

/// False when there is none for it.
bool HttpServer::find_place(Exchange& newcomer, std::int64_t now_ms) {
  const std::vector<HttpPlace> taken = places(false);
  const std::vector<HttpPlace> own = places_of(newcomer.peer, taken);
  if (!newcomer.peer.empty() && own.size() >= options_.max_of_address) {
    return make_way(own, now_ms);
  }
  if (taken.size() < options_.max_connections || make_way(taken, now_ms)) return true;
  newcomer.is_reserved = true;
  const std::vector<HttpPlace> reserve = places(true);
  return reserve.size() < options_.reserved || make_way(reserve, now_ms);
}

/// Each is read from at once: a request that has come with its connection is answered before
/// anybody else can want its place.
void HttpServer::accept_all(std::int64_t now_ms, const Pages& pages) {
  for (int i = 0; i < most_accepted; ++i) {
    sockaddr_storage from{};
    socklen_t size = sizeof from;
    const int fd = ::accept4(listener_.descriptor(), reinterpret_cast<sockaddr*>(&from), &size,
                             SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (fd < 0) return;
    Exchange exchange;
    exchange.peer = peer_of(from);
    exchange.begun_ms = now_ms;
    exchange.ends_ms = now_ms + std::min(options_.request_ms, options_.exchange_ms);
    TF_CHECK(!exchanges_.contains(fd));
    if (find_place(exchange, now_ms) && serve_one(fd, exchange, now_ms, pages)) {
      exchanges_[fd] = std::move(exchange);
    } else {
      ::close(fd);
    }
  }
}

void HttpServer::answer(Exchange& exchange, const Pages& pages) const {
  HttpRequest request = parse_http_request(exchange.request, token_);
  const bool is_vital = request.path == "/healthz" || request.path == "/readyz";
  if (request.refusal == 0 && exchange.is_reserved && !is_vital) request.refusal = 503;
  const HttpAnswer page = request.refusal == 0 ? pages(request.path) : refusal(request.refusal);
  exchange.answer = worded(page, request.is_head);
}

/// False when the exchange is over. A connection that is closed with bytes unread would take the
/// answer along, so the other side is given a moment to end it.
bool HttpServer::go_on(int fd, Exchange& exchange, std::int64_t now_ms, const Pages& pages) const {
  std::array<char, 4096> buffer;
  bool has_ended = false;
  for (int i = 0; i < most_reads && !has_ended; ++i) {
    const ssize_t n = ::recv(fd, buffer.data(), buffer.size(), 0);
    if (n < 0 && would_block()) break;
    if (n < 0) return false;
    has_ended = n == 0;
    if (exchange.answer.empty())
      exchange.request.append(buffer.data(), static_cast<std::size_t>(n));
    if (exchange.request.size() > options_.max_request_bytes) break;
  }
  if (exchange.answer.empty()) {
    const std::size_t end = exchange.request.find("\r\n\r\n");
    if (end != std::string::npos && end + 4 <= options_.max_request_bytes) {
      exchange.request.resize(end + 4);
      answer(exchange, pages);
    } else if (exchange.request.size() > options_.max_request_bytes) {
      exchange.answer = worded(refusal(431), false);
    }
    exchange.request.shrink_to_fit();
    if (!exchange.answer.empty()) {
      exchange.heard_ms = now_ms;
      exchange.ends_ms = exchange.begun_ms + options_.exchange_ms;
    }
  }
  while (exchange.sent < exchange.answer.size()) {
    const ssize_t n = ::send(fd, exchange.answer.data() + exchange.sent,
                             exchange.answer.size() - exchange.sent, MSG_NOSIGNAL);
    if (n < 0) return would_block();
    exchange.sent += static_cast<std::size_t>(n);
    TF_CHECK(exchange.sent <= exchange.answer.size());
    exchange.heard_ms = now_ms;
  }
  return !has_ended;
}

/// False when the exchange is over, for one reason or another.
bool HttpServer::serve_one(int fd, Exchange& exchange, std::int64_t now_ms,
                           const Pages& pages) const {
  if (now_ms >= exchange.ends_ms || !go_on(fd, exchange, now_ms, pages)) return false;
  const bool is_said = !exchange.answer.empty() && exchange.sent == exchange.answer.size();
  if (!is_said || exchange.is_over) return true;
  exchange.is_over = true;
  exchange.request.clear();
  exchange.ends_ms = now_ms + last_words_ms;
  ::shutdown(fd, SHUT_WR);
  return true;
}

void HttpServer::serve(std::int64_t now_ms, const Pages& pages) {
  std::vector<int> over;
  for (auto& [fd, exchange] : exchanges_) {
    if (!serve_one(fd, exchange, now_ms, pages)) over.push_back(fd);
  }
  for (const int fd : over) {
    ::close(fd);
    exchanges_.erase(fd);
  }
  accept_all(now_ms, pages);
}

}  // namespace tetfarm
