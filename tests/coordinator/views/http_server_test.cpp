#include "coordinator/views/http_server.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <optional>
#include <random>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/views/loopback.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* token = "a token of the test";

std::string get(const std::string& path, const std::string& fields = "Host: localhost\r\n") {
  return "GET " + path + " HTTP/1.1\r\n" + fields + "\r\n";
}

int refusal_of(const std::string& head, const std::string& secret = "") {
  return parse_http_request(head, secret).refusal;
}

TEST(HttpRequest, a_plain_one_is_read) {
  const HttpRequest request = parse_http_request(get("/metrics?x=1"), "");
  EXPECT_EQ(request.refusal, 0);
  EXPECT_EQ(request.path, "/metrics");
  EXPECT_TRUE(parse_http_request("HEAD / HTTP/1.0\r\nHost: [::1]:80\r\n\r\n", "").is_head);
}

TEST(HttpRequest, garbage_is_a_bad_request) {
  for (const char* head : {"\r\n\r\n", "GET\r\n\r\n", "GET /\r\n\r\n", "GET x HTTP/1.1\r\n\r\n",
                           "GET / HTTP/2\r\n\r\n", "GET / HTTP/1.1\r\nno field\r\n\r\n",
                           "GET / HTTP/1.1\r\n: x\r\n\r\n"}) {
    EXPECT_EQ(refusal_of(head), 400) << head;
  }
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(random() % 200, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    EXPECT_NE(refusal_of(bytes + "\r\n\r\n"), 0);
  }
}

TEST(HttpRequest, only_reading_is_allowed) {
  EXPECT_EQ(refusal_of("POST / HTTP/1.1\r\nHost: localhost\r\n\r\n"), 405);
}

TEST(HttpRequest, without_a_token_only_names_of_this_host_are_served) {
  for (const char* host : {"127.0.0.1:8080", "localhost", "[::1]:8080", "LOCALHOST:1"}) {
    EXPECT_EQ(refusal_of(get("/", std::string("Host: ") + host + "\r\n")), 0) << host;
  }
  for (const char* host : {"evil.example", "127.evil.example", "localhost.evil.example"}) {
    EXPECT_EQ(refusal_of(get("/", std::string("Host: ") + host + "\r\n")), 403) << host;
  }
  EXPECT_EQ(refusal_of(get("/", "")), 403);
}

TEST(HttpRequest, a_token_is_asked_for_and_compared) {
  const std::string bearer = std::string("Authorization: Bearer ") + token + "\r\n";
  EXPECT_EQ(refusal_of(get("/", bearer), token), 0);
  EXPECT_EQ(refusal_of(get("/", "authorization:bearer   " + std::string(token) + "\r\n"), token),
            0);
  EXPECT_EQ(refusal_of(get("/", ""), token), 401);
  EXPECT_EQ(refusal_of(get("/", "Authorization: Bearer wrong\r\n"), token), 401);
  EXPECT_EQ(refusal_of(get("/", "Authorization: Bearer " + std::string(token) + "x\r\n"), token),
            401);
  EXPECT_EQ(refusal_of(get("/", "Authorization: Bearer\r\n"), token), 401);
  // "me:a token of the test"
  EXPECT_EQ(
      refusal_of(get("/", "Authorization: Basic bWU6YSB0b2tlbiBvZiB0aGUgdGVzdA==\r\n"), token), 0);
  EXPECT_EQ(refusal_of(get("/", "Authorization: Basic bWU6d3Jvbmc=\r\n"), token), 401);
  EXPECT_EQ(refusal_of(get("/healthz", ""), token), 0) << "whether it lives is no secret";
}

class HttpServerTest : public testing::Test {
 protected:
  static HttpOptions options() {
    HttpOptions options;
    options.address = "127.0.0.1:0";
    options.max_connections = 3;
    options.reserved = 2;
    options.request_ms = 1000;
    options.exchange_ms = 3000;
    return options;
  }
  int connect() const { return connect_to(server_.address()); }
  void turn(std::int64_t ms = 1) {
    now_ms_ += ms;
    std::vector<zmq::pollitem_t> items;
    server_.add_poll_items(items);
    zmq::poll(items, std::chrono::milliseconds(5));
    server_.serve(now_ms_, [this](const std::string& path) {
      ++pages_;
      if (path == "/healthz") return HttpAnswer{200, "text/plain", "ok"};
      return HttpAnswer{path == "/" ? 200 : 404, "text/plain", body_};
    });
  }
  /// All that comes until the connection ends; closes it.
  std::string read_all(int fd) {
    std::string text;
    for (int i = 0; i < 400; ++i) {
      turn();
      char buffer[65536];
      const ssize_t n = ::recv(fd, buffer, sizeof buffer, MSG_DONTWAIT);
      if (n == 0) break;
      if (n > 0) text.append(buffer, static_cast<std::size_t>(n));
      if (n < 0 && errno != EAGAIN) break;
    }
    ::close(fd);
    turn();
    return text;
  }
  std::string exchange(const std::string& request) {
    const int fd = connect();
    EXPECT_EQ(::send(fd, request.data(), request.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(request.size()));
    return read_all(fd);
  }

  HttpServer server_{options()};
  std::int64_t now_ms_ = 0;
  int pages_ = 0;
  std::string body_ = "the page";
};

TEST_F(HttpServerTest, a_page_comes_whole_and_the_connection_ends) {
  body_ = std::string(3'000'000, 'x');
  const std::string answer = exchange(get("/"));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Length: 3000000\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, 3'000'000U);
  EXPECT_EQ(server_.connections(), 0U);
}

TEST_F(HttpServerTest, a_head_has_no_body_and_an_unknown_page_is_not_found) {
  const std::string answer = exchange("HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_THAT(answer, HasSubstr("Content-Length: 8\r\n"));
  EXPECT_THAT(answer, testing::EndsWith("\r\n\r\n"));
  EXPECT_THAT(exchange(get("/nothing")), StartsWith("HTTP/1.1 404 "));
}

TEST_F(HttpServerTest, an_answer_says_what_it_is_and_that_nobody_shall_keep_or_guess_it) {
  EXPECT_EQ(exchange(get("/")),
            "HTTP/1.1 200 OK\r\n"
            "Content-Type: text/plain\r\n"
            "Content-Length: 8\r\n"
            "Connection: close\r\n"
            "Cache-Control: no-store\r\n"
            "X-Content-Type-Options: nosniff\r\n"
            "Content-Security-Policy: default-src 'none'; style-src 'unsafe-inline'\r\n"
            "\r\n"
            "the page");
}

TEST_F(HttpServerTest, a_refusal_has_its_number_its_words_and_what_would_help) {
  const auto told = [this](const std::string& request) {
    const std::string answer = exchange(request);
    const std::size_t line = answer.find("\r\n");
    const std::size_t body = answer.find("\r\n\r\n");
    if (body == answer.npos) return answer;
    const std::string fields = answer.substr(line, body + 2 - line);
    std::string extra;
    for (const char* field : {"\r\nAllow: GET, HEAD\r\n", "\r\nWWW-Authenticate: "}) {
      if (fields.find(field) != fields.npos) extra += " +";
    }
    return answer.substr(0, line) + extra + ": " + answer.substr(body + 4);
  };
  EXPECT_EQ(told("x\r\n\r\n"), "HTTP/1.1 400 Bad Request: Bad Request\n");
  EXPECT_EQ(told(get("/", "Host: far.org\r\n")), "HTTP/1.1 403 Forbidden: Forbidden\n");
  EXPECT_EQ(told("PUT / HTTP/1.1\r\nHost: localhost\r\n\r\n"),
            "HTTP/1.1 405 Method Not Allowed +: Method Not Allowed\n");
  EXPECT_EQ(told("HEAD /nothing HTTP/1.1\r\nHost: localhost\r\n\r\n"), "HTTP/1.1 404 Not Found: ");
  EXPECT_EQ(told(std::string(9000, 'x')),
            "HTTP/1.1 431 Request Header Fields Too Large: Request Header Fields Too Large\n");
  EXPECT_EQ(pages_, 1) << "the one that is not there";
}

TEST_F(HttpServerTest, a_request_may_have_as_many_bytes_as_allowed_and_no_more) {
  const std::string plain = get("/", "Host: localhost\r\nX: \r\n");
  const auto with_bytes = [&plain](std::size_t bytes) {
    return get("/", "Host: localhost\r\nX: " + std::string(bytes - plain.size(), 'x') + "\r\n");
  };
  EXPECT_THAT(exchange(with_bytes(8192)), StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(exchange(with_bytes(8193)), StartsWith("HTTP/1.1 431 "));
  EXPECT_THAT(exchange(get("/") + std::string(20'000, 'x')), StartsWith("HTTP/1.1 200 "))
      << "what follows a request is not read as part of it";
}

TEST_F(HttpServerTest, times_are_over_when_they_were_told_to_be) {
  const int silent = connect();
  turn();  // it comes at 1
  turn(999);
  EXPECT_EQ(server_.connections(), 1U) << "at 1000";
  turn(1);
  EXPECT_EQ(server_.connections(), 0U) << "at 1001, a second after it came";
  ::close(silent);
}

TEST_F(HttpServerTest, who_takes_no_answer_is_put_out_when_the_time_of_an_exchange_is_over) {
  body_ = std::string(30'000'000, 'x');
  const int slow = connect();
  turn();  // it comes at 1
  const std::string request = get("/");
  ::send(slow, request.data(), request.size(), MSG_NOSIGNAL);
  turn(900);  // and is answered at 901
  EXPECT_EQ(pages_, 1);
  turn(2099);
  EXPECT_EQ(server_.connections(), 1U) << "at 3000";
  turn(1);
  EXPECT_EQ(server_.connections(), 0U) << "at 3001, three seconds after it came";
  ::close(slow);
}

TEST_F(HttpServerTest, who_has_the_answer_and_does_not_go_is_put_out_after_a_second) {
  const int idle = connect();
  const std::string request = get("/");
  ::send(idle, request.data(), request.size(), MSG_NOSIGNAL);
  turn();  // it is answered at 1
  EXPECT_EQ(pages_, 1);
  turn(999);
  EXPECT_EQ(server_.connections(), 1U) << "at 1000";
  turn(1);
  EXPECT_EQ(server_.connections(), 0U) << "at 1001";
  ::close(idle);
}

TEST_F(HttpServerTest, is_polled_for_what_it_waits_for) {
  const auto events = [this] {
    std::vector<zmq::pollitem_t> items;
    server_.add_poll_items(items);
    std::vector<short> wanted;
    for (const zmq::pollitem_t& item : items) wanted.push_back(item.events);
    return wanted;
  };
  EXPECT_THAT(events(), testing::ElementsAre(ZMQ_POLLIN));
  body_ = std::string(30'000'000, 'x');
  const int client = connect();
  turn();
  EXPECT_THAT(events(), testing::ElementsAre(ZMQ_POLLIN, ZMQ_POLLIN)) << "for its request";
  const std::string request = get("/");
  ::send(client, request.data(), request.size(), MSG_NOSIGNAL);
  turn();
  EXPECT_THAT(events(), testing::ElementsAre(ZMQ_POLLIN, ZMQ_POLLOUT)) << "to take its answer";
  read_all(client);
  EXPECT_THAT(events(), testing::ElementsAre(ZMQ_POLLIN));
}

TEST_F(HttpServerTest, a_request_that_comes_byte_by_byte_is_served) {
  const int fd = connect();
  for (const char c : get("/")) {
    ::send(fd, &c, 1, MSG_NOSIGNAL);
    turn();
  }
  EXPECT_THAT(read_all(fd), HasSubstr("the page"));
  EXPECT_EQ(pages_, 1);
}

TEST_F(HttpServerTest, a_request_without_end_is_refused_and_never_parsed) {
  EXPECT_THAT(exchange("GET / HTTP/1.1\r\n" + std::string(20'000, 'a')),
              StartsWith("HTTP/1.1 431 "));
  EXPECT_EQ(pages_, 0);
}

TEST_F(HttpServerTest, a_client_that_says_nothing_is_put_out_when_its_time_is_over) {
  const int slow = connect();
  turn();
  ::send(slow, "GET", 3, MSG_NOSIGNAL);
  turn(900);
  EXPECT_EQ(server_.connections(), 1U);
  turn(200);
  EXPECT_EQ(server_.connections(), 0U);
  ::close(slow);
}

TEST_F(HttpServerTest, a_client_that_does_not_read_is_put_out_too) {
  body_ = std::string(30'000'000, 'x');
  const int slow = connect();
  const std::string request = get("/");
  ::send(slow, request.data(), request.size(), MSG_NOSIGNAL);
  for (int i = 0; i < 5; ++i) turn();
  EXPECT_EQ(server_.connections(), 1U);
  turn(4000);
  EXPECT_EQ(server_.connections(), 0U);
  ::close(slow);
}

TEST_F(HttpServerTest, slow_clients_keep_nobody_out_however_many) {
  std::vector<int> slow;
  for (int i = 0; i < 20; ++i) {
    slow.push_back(connect());
    ::send(slow.back(), "GET / HTTP/1.1\r\nX", 17, MSG_NOSIGNAL);
    turn();
  }
  EXPECT_THAT(exchange(get("/")), HasSubstr("the page"));
  EXPECT_THAT(exchange(get("/healthz")), HasSubstr("ok"));
  EXPECT_LE(server_.connections(), 3U);
  for (const int fd : slow) ::close(fd);
}

TEST_F(HttpServerTest, a_request_that_came_with_its_connection_is_answered_in_the_same_turn) {
  const int honest = connect();
  const std::string request = get("/");
  ::send(honest, request.data(), request.size(), MSG_NOSIGNAL);
  std::vector<int> slow;
  for (int i = 0; i < 20; ++i) slow.push_back(connect());
  turn();
  EXPECT_EQ(pages_, 1);
  EXPECT_THAT(read_all(honest), HasSubstr("the page"));
  for (const int fd : slow) ::close(fd);
}

TEST_F(HttpServerTest, while_all_places_are_served_health_has_places_of_its_own) {
  body_ = std::string(30'000'000, 'x');
  std::vector<int> readers;
  const std::string request = get("/");
  for (int i = 0; i < 3; ++i) {
    readers.push_back(connect());
    ::send(readers.back(), request.data(), request.size(), MSG_NOSIGNAL);
    for (int j = 0; j < 5; ++j) turn();
  }
  EXPECT_EQ(server_.connections(), 3U);
  for (int i = 0; i < 10; ++i) {
    EXPECT_THAT(exchange(get("/healthz")), HasSubstr("ok"));
    EXPECT_THAT(exchange(get("/")), StartsWith("HTTP/1.1 503 "));
  }
  for (const int fd : readers) ::close(fd);
}

TEST_F(HttpServerTest, more_connections_than_allowed_are_closed_at_once) {
  std::vector<int> all;
  for (int i = 0; i < 6; ++i) {
    all.push_back(connect());
    turn();
  }
  EXPECT_EQ(server_.connections(), 3U);
  for (const int fd : all) ::close(fd);
  turn();
  turn();
  EXPECT_THAT(exchange(get("/")), HasSubstr("the page"));
}

TEST_F(HttpServerTest, garbage_is_answered_and_does_no_harm) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    std::string bytes(1 + random() % 300, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    EXPECT_THAT(exchange(bytes + "\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
  }
  EXPECT_EQ(pages_, 0);
}

TEST(HttpServerAddress, is_loopback_unless_there_is_a_token_that_nobody_else_may_read) {
  const TempFolder folder;
  HttpOptions options;
  options.address = "0.0.0.0:0";
  EXPECT_THROW(HttpServer{options}, UsageError);
  options.token_file = folder.path() / "token";
  EXPECT_THROW(HttpServer{options}, IoError) << "no such file";
  std::ofstream(options.token_file) << token << "\n";
  ::chmod(options.token_file.c_str(), 0640);
  EXPECT_THROW(HttpServer{options}, UsageError) << "others may read it";
  ::chmod(options.token_file.c_str(), 0600);
  EXPECT_THAT(HttpServer(options).address(), StartsWith("0.0.0.0:"));
  std::ofstream(options.token_file) << "short\n";
  EXPECT_THROW(HttpServer{options}, UsageError);
}

std::string why_not(const HttpOptions& options) {
  try {
    const HttpServer server(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(HttpServerAddress, is_refused_with_what_is_wrong) {
  const TempFolder folder;
  HttpOptions options;
  options.address = "0.0.0.0:0";
  EXPECT_EQ(why_not(options),
            "0.0.0.0:0: other hosts can connect: give a file with a token (--http-token)");
  options.address = "127.0.0.1";
  EXPECT_EQ(why_not(options), "127.0.0.1: is not an address and port such as 127.0.0.1:8080");
  options.address = "localhost:0";
  EXPECT_EQ(why_not(options), "");
  EXPECT_THAT(HttpServer(options).address(), StartsWith("127.0.0.1:"));
  options.address = "[::1]:0";
  EXPECT_THAT(HttpServer(options).address(), StartsWith("[::1]:"));
  options.token_file = folder.path() / "token";
  const std::string file = options.token_file.string();
  EXPECT_EQ(why_not(options), file + ": cannot read: No such file or directory");
  const auto write = [&options](const std::string& text, mode_t mode) {
    std::ofstream(options.token_file) << text;
    ::chmod(options.token_file.c_str(), mode);
  };
  write("0123456789abcde \n\n", 0600);
  EXPECT_EQ(why_not(options), file +
                                  ": a token must have at least 16 characters; make one with "
                                  "`head -c 24 /dev/urandom | base64`");
  write("0123456789abcdef\n", 0600);
  EXPECT_EQ(why_not(options), "");
  for (const mode_t mode : {0640, 0620, 0604, 0601}) {
    write("0123456789abcdef\n", mode);
    EXPECT_EQ(why_not(options), file + ": other users may read this token: run chmod 600 on it");
    ::chmod(file.c_str(), 0600);
  }
}

TEST(HttpServerToken, is_asked_for_without_the_line_end_of_its_file) {
  const TempFolder folder;
  HttpOptions options;
  options.address = "127.0.0.1:0";
  options.token_file = folder.path() / "token";
  std::ofstream(options.token_file) << "0123456789abcdef \n";
  ::chmod(options.token_file.c_str(), 0600);
  HttpServer server(options);
  const auto answer_to = [&server](const std::string& request) {
    const int fd = connect_to(server.address());
    EXPECT_EQ(::send(fd, request.data(), request.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(request.size()));
    server.serve(0, [](const std::string&) { return HttpAnswer{200, "text/plain", "page"}; });
    char buffer[4096];
    const ssize_t n = ::recv(fd, buffer, sizeof buffer, MSG_DONTWAIT);
    ::close(fd);
    server.serve(1, [](const std::string&) { return HttpAnswer{}; });
    return std::string(buffer, static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  };
  EXPECT_THAT(answer_to(get("/", "Authorization: Bearer 0123456789abcdef\r\n")),
              StartsWith("HTTP/1.1 200 OK\r\n"));
  const std::string refused = answer_to(get("/", ""));
  EXPECT_THAT(refused, StartsWith("HTTP/1.1 401 Unauthorized\r\n"));
  EXPECT_THAT(refused, HasSubstr("\r\nWWW-Authenticate: Basic realm=\"tetfarm\"\r\n\r\n"));
}

/// An address of this machine that is not loopback, with no port.
std::optional<sockaddr_in> outer_address() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return std::nullopt;
  std::optional<sockaddr_in> found;
  for (const ifaddrs* next = list; next != nullptr && !found; next = next->ifa_next) {
    const bool is_outer = (next->ifa_flags & IFF_LOOPBACK) == 0 && next->ifa_addr != nullptr;
    if (is_outer && next->ifa_addr->sa_family == AF_INET) {
      found = *reinterpret_cast<const sockaddr_in*>(next->ifa_addr);
    }
  }
  ::freeifaddrs(list);
  return found;
}

TEST(HttpServerAddress, of_another_host_has_no_more_connections_than_allowed) {
  std::optional<sockaddr_in> where = outer_address();
  if (!where) GTEST_SKIP() << "this machine has no address but its own";
  const TempFolder folder;
  HttpOptions options;
  options.address = "0.0.0.0:0";
  options.token_file = folder.path() / "token";
  options.max_of_address = 2;
  std::ofstream(options.token_file) << token << "\n";
  ::chmod(options.token_file.c_str(), 0600);
  HttpServer server(options);
  const std::string& address = server.address();
  where->sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
  std::vector<int> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    ASSERT_EQ(::connect(clients.back(), reinterpret_cast<const sockaddr*>(&*where), sizeof *where),
              0);
    server.serve(i, [](const std::string&) { return HttpAnswer{}; });
    EXPECT_LE(server.connections(), 2U);
  }
  EXPECT_EQ(server.connections(), 2U);
  for (const int client : clients) ::close(client);
}

TEST(HttpServerAddress, has_to_be_numbers_and_free) {
  HttpOptions options;
  for (const char* address : {"", "8080", "example.org:80", "127.0.0.1:x", "127.0.0.1"}) {
    options.address = address;
    EXPECT_THROW(HttpServer{options}, UsageError) << address;
  }
  options.address = "[::1]:0";
  const HttpServer first(options);
  options.address = first.address();
  EXPECT_THROW(HttpServer{options}, UsageError) << "in use";
}

}  // namespace
}  // namespace tetfarm
