#include "dashboard/web_server.h"

#include <gmock/gmock.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <list>
#include <thread>
#include <utility>
#include <vector>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int patience_ms = 10'000;

/// A TCP connection that says anything.
class Client {
 public:
  explicit Client(const std::string& address, int receive_bytes = 0) {
    descriptor_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (receive_bytes > 0) {
      ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &receive_bytes, sizeof receive_bytes);
    }
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    where.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    EXPECT_EQ(::connect(descriptor_, reinterpret_cast<sockaddr*>(&where), sizeof where), 0);
  }
  ~Client() { ::close(descriptor_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void send(const std::string& bytes) const {
    ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// What comes until `until` is in it, the other side closes, or patience ends.
  std::string hear(const std::string& until = "") const {
    std::string heard;
    std::array<char, 65536> buffer;
    while (until.empty() || heard.find(until) == std::string::npos) {
      pollfd what{descriptor_, POLLIN, 0};
      if (::poll(&what, 1, patience_ms) <= 0) break;
      const ssize_t count = ::recv(descriptor_, buffer.data(), buffer.size(), 0);
      if (count <= 0) break;
      heard.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return heard;
  }
  bool is_cut_off(int within_ms) const {
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(within_ms);
    while (std::chrono::steady_clock::now() < until) {
      pollfd what{descriptor_, POLLRDHUP, 0};
      if (::poll(&what, 1, 20) > 0) return true;
    }
    return false;
  }

 private:
  int descriptor_;
};

/// /text: a body; /large: one of 8 MiB; /watch: a stream; /never: no answer.
class SmallSite : public WebSite {
 public:
  void answer(const WebRequest& request, Answering done) override {
    WebAnswer answer;
    answer.type = "text/plain";
    if (request.target == "/never") return kept_.push_back(std::move(done));
    if (request.target == "/large") {
      answer.body = std::make_shared<const std::string>(std::size_t{8} << 20U, 'x');
    } else {
      answer.body = std::make_shared<const std::string>(request.method + " " + request.target);
    }
    if (request.target == "/watch") {
      answer.is_stream = true;
      answer.body = std::make_shared<const std::string>("first\n");
    }
    done(answer);
  }
  void note_watchers(std::size_t count) override { watchers = count; }

  std::atomic<std::size_t> watchers = 0;

 private:
  std::vector<Answering> kept_;
};

class Served {
 public:
  explicit Served(const WebLimits& limits = WebLimits()) : server_(listener_, site_, limits) {
    server_.start();
  }
  const std::string& address() const { return listener_.address(); }
  std::string answer_to(const std::string& bytes) const {
    const Client client(address());
    client.send(bytes);
    return client.hear();
  }
  WebServer& server() { return server_; }
  bool has_watchers(std::size_t count) const {
    for (int i = 0; i < 500 && site_.watchers != count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return site_.watchers == count;
  }

 private:
  HttpListener listener_{"127.0.0.1:0", false};
  SmallSite site_;
  WebServer server_;
};

std::string request(const std::string& target, const std::string& more = "Connection: close\r\n") {
  return "GET " + target + " HTTP/1.1\r\nHost: localhost\r\n" + more + "\r\n";
}

TEST(WebServer, answers_with_the_body_and_tells_browsers_to_load_nothing_from_elsewhere) {
  const Served served;
  const std::string answer = served.answer_to(request("/text"));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_TRUE(answer.ends_with("\r\n\r\nGET /text")) << answer;
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'self'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, HasSubstr("Cache-Control: no-store"));
  EXPECT_THAT(answer, HasSubstr("Content-Length: 9\r\n"));
}

TEST(WebServer, answers_several_requests_of_a_connection_in_their_order) {
  const Served served;
  const Client client(served.address());
  client.send(request("/one", "") + request("/two", ""));
  EXPECT_THAT(client.hear("GET /two"), HasSubstr("GET /one"));
  client.send(request("/three"));
  EXPECT_THAT(client.hear(), HasSubstr("GET /three"));
}

TEST(WebServer, answers_head_with_the_length_and_no_body) {
  const Served served;
  const std::string answer =
      served.answer_to("HEAD /text HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  EXPECT_THAT(answer, HasSubstr("Content-Length: 10\r\n"));
  EXPECT_TRUE(answer.ends_with("\r\n\r\n"));
}

TEST(WebServer, refuses_heads_that_are_too_long_malformed_or_ambiguous) {
  const Served served;
  EXPECT_THAT(served.answer_to(request("/", "X: " + std::string(9000, 'x') + "\r\n")),
              StartsWith("HTTP/1.1 431"));
  EXPECT_THAT(served.answer_to(std::string(20'000, 'x')), StartsWith("HTTP/1.1 4"));
  EXPECT_THAT(served.answer_to("GET\r\n\r\n"), StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(served.answer_to("GET / HTTP/9.9\r\n\r\n"), StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(served.answer_to(request("/", "Host: evil.example\r\n")), StartsWith("HTTP/1.1 400"));
}

TEST(WebServer, refuses_bodies) {
  const Served served;
  EXPECT_THAT(served.answer_to(request("/", "Content-Length: 5\r\n") + "hello"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(served.answer_to(request("/", "Transfer-Encoding: chunked\r\n") + "0\r\n\r\n"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(served.answer_to("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n"
                               "Connection: close\r\n\r\n"),
              HasSubstr("POST /"));
}

TEST(WebServer, cuts_off_who_does_not_end_a_request) {
  WebLimits limits;
  limits.request_ms = 300;
  const Served served(limits);
  const Client silent(served.address());
  const Client slow(served.address());
  for (int i = 0; i < 10; ++i) {
    slow.send("X");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_TRUE(slow.is_cut_off(5'000));
  EXPECT_TRUE(silent.is_cut_off(5'000));
}

TEST(WebServer, cuts_off_who_does_not_read) {
  WebLimits limits;
  limits.deaf_ms = 300;
  const Served served(limits);
  const Client deaf(served.address(), 4096);
  deaf.send(request("/large"));
  EXPECT_TRUE(deaf.is_cut_off(8'000));
  const std::string answer = served.answer_to(request("/large"));
  EXPECT_GT(answer.size(), std::size_t{8} << 20U) << "who reads gets all of it";
}

TEST(WebServer, cuts_off_idle_connections_and_those_for_whom_there_is_no_answer) {
  WebLimits limits;
  limits.idle_ms = 300;
  limits.thought_ms = 300;
  const Served served(limits);
  const Client idle(served.address());
  idle.send(request("/text", ""));
  idle.hear("GET /text");
  EXPECT_TRUE(idle.is_cut_off(5'000));
  const Client waiting(served.address());
  waiting.send(request("/never"));
  EXPECT_TRUE(waiting.is_cut_off(5'000));
}

TEST(WebServer, connections_that_are_not_used_keep_nobody_out) {
  WebLimits limits;
  limits.connections = 8;
  limits.reserved = 2;
  const Served served(limits);
  std::list<Client> unfinished;
  for (int i = 0; i < 100; ++i) {
    unfinished.emplace_back(served.address()).send("GET / HTTP/1.1\r\nX: ");
    if (i % 10 != 0) continue;
    EXPECT_THAT(served.answer_to(request("/text")), HasSubstr("200 OK"));
  }
}

TEST(WebServer, keeps_places_for_short_answers_when_all_others_watch) {
  WebLimits limits;
  limits.connections = 3;
  limits.reserved = 1;
  limits.watchers = 3;
  const Served served(limits);
  std::list<Client> watchers;
  for (int i = 0; i < 3; ++i) {
    watchers.emplace_back(served.address()).send(request("/watch"));
    EXPECT_THAT(watchers.back().hear("first"), HasSubstr("200 OK"));
  }
  EXPECT_THAT(served.answer_to(request("/text")), HasSubstr("200 OK"));
  EXPECT_THAT(served.answer_to(request("/large")), HasSubstr("503 "));
  EXPECT_THAT(served.answer_to(request("/watch")), HasSubstr("503 "));
}

TEST(WebServer, tells_all_who_watch_until_they_leave) {
  Served served;
  const Client first(served.address());
  first.send(request("/watch"));
  EXPECT_THAT(first.hear("first"), HasSubstr("Connection: close"));
  {
    const Client second(served.address());
    second.send(request("/watch"));
    second.hear("first");
    EXPECT_TRUE(served.has_watchers(2));
    served.server().publish("news\n");
    EXPECT_THAT(second.hear("news"), HasSubstr("news"));
  }
  EXPECT_THAT(first.hear("news"), HasSubstr("news"));
  EXPECT_TRUE(served.has_watchers(1));
}

TEST(WebServer, shows_watchers_that_it_lives) {
  WebLimits limits;
  limits.alive_ms = 200;
  const Served served(limits);
  const Client watcher(served.address());
  watcher.send(request("/watch"));
  EXPECT_THAT(watcher.hear(": alive"), HasSubstr("\n: alive\n\n"));
}

TEST(WebServer, a_watcher_that_does_not_read_loses_its_place_and_holds_nobody_up) {
  WebLimits limits;
  limits.unread_bytes = 100'000;
  Served served(limits);
  const Client deaf(served.address(), 4096);
  deaf.send(request("/watch"));
  const Client watcher(served.address());
  watcher.send(request("/watch"));
  watcher.hear("first");
  EXPECT_TRUE(served.has_watchers(2));
  for (int i = 0; i < 1000 && !deaf.is_cut_off(1); ++i) {
    served.server().publish(std::string(50'000, 'x') + "end\n");
    EXPECT_THAT(watcher.hear("end\n"), Not(HasSubstr("HTTP")));
  }
  EXPECT_TRUE(served.has_watchers(1));
}

TEST(WebServer, of_watchers_takes_a_bounded_number) {
  WebLimits limits;
  limits.watchers = 1;
  const Served served(limits);
  const Client watcher(served.address());
  watcher.send(request("/watch"));
  watcher.hear("first");
  EXPECT_THAT(served.answer_to(request("/watch")), HasSubstr("503 "));
}

TEST(WebServer, ends_all_connections_when_it_stops) {
  Served served;
  const Client watcher(served.address());
  watcher.send(request("/watch"));
  watcher.hear("first");
  served.server().stop();
  EXPECT_TRUE(watcher.is_cut_off(5'000));
  served.server().publish("nobody hears this");
}

}  // namespace
}  // namespace tetfarm
