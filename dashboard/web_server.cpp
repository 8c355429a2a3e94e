#include "dashboard/web_server.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <cerrno>
#include <cstring>
#include <deque>
#include <map>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/thread_without_signals.h"
#include "dashboard/api_answer.h"
#include "http/http_places.h"

namespace tetfarm {
namespace {

namespace beast = boost::beast;
namespace net = boost::asio;
using Tcp = net::ip::tcp;
using ErrorCode = boost::system::error_code;
using Text = std::shared_ptr<const std::string>;

constexpr std::int64_t tick_ms = 250;
constexpr std::int64_t last_words_ms = 1'000;
constexpr std::size_t piece_bytes = std::size_t{64} << 10U;
constexpr std::size_t most_unread_pieces = 256;

Text text_of(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

WebAnswer web_error(const ApiError& error) {
  const ApiAnswer answer = answer_of(error);
  WebAnswer web;
  web.status = answer.status;
  web.body = answer.body;
  return web;
}

/// What all answers say of themselves.
void add_rules_for_browsers(beast::http::response<beast::http::empty_body>& head) {
  head.set("Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
           "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  head.set("X-Content-Type-Options", "nosniff");
  head.set("Referrer-Policy", "no-referrer");
  head.set("Cross-Origin-Opener-Policy", "same-origin");
  head.set("Cross-Origin-Resource-Policy", "same-origin");
  head.set(beast::http::field::cache_control, "no-store");
}

std::string head_of(const WebAnswer& answer, bool keeps_alive) {
  beast::http::response<beast::http::empty_body> head;
  head.version(11);
  head.result(static_cast<unsigned>(answer.status));
  head.set(beast::http::field::content_type, answer.type);
  if (!answer.is_stream) head.content_length(answer.body ? answer.body->size() : 0);
  head.set(beast::http::field::connection, keeps_alive ? "keep-alive" : "close");
  if (answer.status == 401) head.set("WWW-Authenticate", "Basic realm=\"tetfarm\"");
  if (answer.status == 405) head.set("Allow", "GET, HEAD, POST");
  add_rules_for_browsers(head);
  std::ostringstream text;
  text << head.base();
  return text.str();
}

std::string field_of(const beast::http::fields& fields, beast::string_view name) {
  const auto found = fields.find(name);
  if (found == fields.end()) return {};
  return {found->value().data(), found->value().size()};
}

WebRequest request_of(const beast::http::request<beast::http::empty_body>& read) {
  WebRequest request;
  request.method = std::string(read.method_string().data(), read.method_string().size());
  request.target = std::string(read.target().data(), read.target().size());
  request.host = field_of(read, "Host");
  request.origin = field_of(read, "Origin");
  request.authorization = field_of(read, "Authorization");
  request.act = field_of(read, "X-Tetfarm-Act");
  return request;
}

std::string peer_of_socket(const Tcp::socket& socket) {
  ErrorCode error;
  const Tcp::endpoint from = socket.remote_endpoint(error);
  if (error) return {};
  sockaddr_storage address{};
  TF_CHECK(from.size() <= sizeof address);
  std::memcpy(&address, from.data(), from.size());
  return peer_of(address);
}

/// What a session needs of the server.
class Host {
 public:
  virtual ~Host() = default;
  virtual const WebLimits& limits() const = 0;
  virtual void ask(const WebRequest& request, WebSite::Answering done) = 0;
  virtual net::io_context& context() = 0;
  /// Whether there is room for one more watcher, or for so many bytes.
  virtual bool takes_watcher() = 0;
  virtual bool takes_answer(std::size_t bytes) = 0;
  virtual void ended(int descriptor) = 0;
  virtual void watches() = 0;
};

/// One connection, from its first request to its end.
class Session : public std::enable_shared_from_this<Session> {
 public:
  enum class State { idle, asks, waits, answers, watches, over, closed };

  Session(Host& host, Tcp::socket socket, std::string peer, bool is_reserved)
      : host_(host),
        socket_(std::move(socket)),
        descriptor_(socket_.native_handle()),
        peer_(std::move(peer)),
        is_reserved_(is_reserved),
        buffer_(host.limits().head_bytes) {}

  int descriptor() const { return descriptor_; }
  const std::string& peer() const { return peer_; }
  bool is_reserved() const { return is_reserved_; }
  State state() const { return state_; }
  std::size_t unread() const { return unread_; }

  HttpPlace place() const {
    HttpPlace place;
    place.fd = descriptor_;
    place.peer = peer_;
    place.since_ms = since_ms_;
    place.stage = state_ == State::asks                            ? HttpPlace::Stage::asks
                  : state_ == State::idle || state_ == State::over ? HttpPlace::Stage::over
                                                                   : HttpPlace::Stage::listens;
    return place;
  }

  void read_request() {
    enter(State::asks, host_.limits().request_ms);
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(host_.limits().head_bytes));
    parser_->body_limit(0);
    beast::http::async_read_header(
        socket_, buffer_, *parser_,
        [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
          self->take_request(error);
        });
  }

  /// Tells a watcher something.
  void tell(const Text& text) {
    if (state_ != State::watches) return;
    pieces_.push_back(text);
    unread_ += text->size();
    const bool is_slow =
        pieces_.size() > most_unread_pieces || unread_ > host_.limits().unread_bytes;
    if (is_slow) return cut();
    if (!is_writing_) write();
  }

  /// Ends what has taken too long.
  void look_at_clock(std::int64_t now_ms) {
    const bool is_deaf = is_writing_ && now_ms - since_ms_ > host_.limits().deaf_ms;
    if (is_deaf || now_ms >= ends_ms_) cut();
  }

  /// Closes it without sending what is left: the system need not hold that for who does not read.
  void cut() {
    ErrorCode ignored;
    socket_.set_option(net::socket_base::linger(true, 0), ignored);
    close();
  }

  void close() {
    if (state_ == State::closed) return;
    state_ = State::closed;
    ErrorCode ignored;
    socket_.close(ignored);
    pieces_.clear();
    unread_ = 0;
    host_.ended(descriptor_);
  }

 private:
  void enter(State state, std::int64_t for_ms) {
    state_ = state;
    since_ms_ = steady_ms();
    ends_ms_ = since_ms_ + for_ms;
  }

  void take_request(ErrorCode error) {
    if (state_ == State::closed) return;
    keeps_alive_ = false;
    is_head_ = false;
    if (error == beast::http::error::header_limit || error == beast::http::error::buffer_overflow) {
      return give(web_error({431, "the head of the request is too long", "8 KiB is the most"}));
    }
    if (error == beast::http::error::body_limit) return refuse_body();
    const bool is_cut = error == beast::http::error::end_of_stream ||
                        error == beast::http::error::partial_message ||
                        (error && error.category() == boost::system::system_category());
    if (is_cut) return close();
    if (error) return give(web_error({400, "this is not a request of HTTP/1.1", "use HTTP/1.1"}));
    const auto& read = parser_->get();
    is_head_ = read.method() == beast::http::verb::head;
    if (read.count("Host") > 1 || read.count("Authorization") > 1) {
      return give(web_error({400, "a field is there twice", "send it once"}));
    }
    if (parser_->chunked() || parser_->content_length().value_or(0) > 0) return refuse_body();
    keeps_alive_ = read.keep_alive() && !is_reserved_;
    enter(State::waits, host_.limits().thought_ms);
    host_.ask(request_of(read),
              [&context = host_.context(), weak = weak_from_this()](WebAnswer answer) {
                net::post(context, [weak, answer = std::move(answer)] {
                  const std::shared_ptr<Session> self = weak.lock();
                  if (self && self->state_ == State::waits) self->give(answer);
                });
              });
  }

  void refuse_body() { give(web_error({413, "a request has no body here", "leave the body out"})); }

  /// The answer, or why there is no room for it.
  void give(const WebAnswer& answer) {
    const std::size_t bytes = answer.body ? answer.body->size() : 0;
    const bool is_short = !answer.is_stream && bytes <= host_.limits().short_bytes;
    if (answer.is_stream && !is_head_ && (is_reserved_ || !host_.takes_watcher())) {
      return send(web_error({503, "too many watch already", "close other pages of the dashboard"}));
    }
    if (!is_short && (is_reserved_ || !host_.takes_answer(bytes))) {
      return send(web_error({503, "too many are being answered", "ask again in a moment"}));
    }
    send(answer);
  }

  void send(const WebAnswer& answer) {
    const bool is_stream = answer.is_stream && !is_head_;
    if (is_stream || answer.status == 400 || answer.status >= 413) keeps_alive_ = false;
    if (is_stream) {
      enter(State::watches, std::int64_t{1} << 40U);
    } else {
      enter(State::answers, host_.limits().answer_ms);
    }
    push(text_of(head_of(answer, keeps_alive_)));
    if (answer.body && !is_head_ && !answer.body->empty()) push(answer.body);
    if (is_stream) {
      host_.watches();
      listen_for_end();
    }
    write();
  }

  void push(Text text) {
    unread_ += text->size();
    pieces_.push_back(std::move(text));
  }

  void write() {
    TF_CHECK(!is_writing_ && !pieces_.empty());
    const std::string& piece = *pieces_.front();
    const std::size_t count = std::min(piece.size() - sent_, piece_bytes);
    is_writing_ = true;
    since_ms_ = steady_ms();
    socket_.async_write_some(
        net::buffer(piece.data() + sent_, count),
        [self = shared_from_this(), text = pieces_.front()](ErrorCode error, std::size_t bytes) {
          self->wrote(error, bytes);
        });
  }

  void wrote(ErrorCode error, std::size_t bytes) {
    is_writing_ = false;
    if (state_ == State::closed) return;
    if (error) return close();
    since_ms_ = steady_ms();
    sent_ += bytes;
    unread_ -= bytes;
    if (sent_ == pieces_.front()->size()) {
      pieces_.pop_front();
      sent_ = 0;
    }
    if (!pieces_.empty()) return write();
    if (state_ == State::answers) said();
  }

  /// All of the answer is on its way.
  void said() {
    if (!keeps_alive_) return end();
    if (buffer_.size() > 0) return read_request();
    enter(State::idle, host_.limits().idle_ms);
    socket_.async_wait(Tcp::socket::wait_read, [self = shared_from_this()](ErrorCode error) {
      if (self->state_ != State::idle) return;
      if (error) return self->close();
      self->read_request();
    });
  }

  /// A connection that is closed with bytes unread would take the answer along, so the other side
  /// is given a moment to end it.
  void end() {
    enter(State::over, last_words_ms);
    ErrorCode ignored;
    socket_.shutdown(Tcp::socket::shutdown_send, ignored);
    listen_for_end();
  }

  void listen_for_end() {
    socket_.async_read_some(net::buffer(unwanted_),
                            [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
                              if (self->state_ == State::closed) return;
                              if (error) return self->close();
                              self->listen_for_end();
                            });
  }

  Host& host_;
  Tcp::socket socket_;
  const int descriptor_;
  const std::string peer_;
  const bool is_reserved_;
  beast::flat_buffer buffer_;
  std::optional<beast::http::request_parser<beast::http::empty_body>> parser_;
  State state_ = State::asks;
  std::int64_t since_ms_ = 0;  ///< in this state, or when something was read of an answer
  std::int64_t ends_ms_ = 0;
  bool keeps_alive_ = false;
  bool is_head_ = false;
  bool is_writing_ = false;
  std::deque<Text> pieces_;
  std::size_t sent_ = 0;  ///< of the first piece
  std::size_t unread_ = 0;
  std::array<char, 1024> unwanted_{};
};

}  // namespace

class WebServer::Hall : public Host {
 public:
  Hall(const HttpListener& listener, WebSite& site, const WebLimits& limits)
      : site_(site), limits_(limits), acceptor_(context_), timer_(context_) {
    const int descriptor = ::dup(listener.descriptor());
    if (descriptor < 0) throw IoError("cannot listen", listener.address(), errno);
    ErrorCode error;
    acceptor_.assign(listener.is_version_6() ? Tcp::v6() : Tcp::v4(), descriptor, error);
    if (error) throw IoError("cannot listen", listener.address(), error.value());
  }
  ~Hall() override { stop(); }
  Hall(const Hall&) = delete;
  Hall& operator=(const Hall&) = delete;

  void start() {
    TF_CHECK(!thread_.joinable());
    accept();
    tick();
    thread_ = thread_without_signals([this] { context_.run(); });
  }

  void stop() {
    if (!thread_.joinable()) return;
    context_.stop();
    thread_.join();
    // In this thread now, as nothing else runs any more.
    is_over_ = true;
    const std::map<int, std::shared_ptr<Session>> last = std::exchange(sessions_, {});
    for (const auto& entry : last) entry.second->close();
    ErrorCode ignored;
    acceptor_.close(ignored);
  }

  void publish(Text messages) {
    net::post(context_, [this, messages = std::move(messages)] { tell_all(messages); });
  }

  // Of sessions.
  const WebLimits& limits() const override { return limits_; }
  net::io_context& context() override { return context_; }
  void ask(const WebRequest& request, WebSite::Answering done) override {
    site_.answer(request, std::move(done));
  }
  bool takes_watcher() override { return watchers() < limits_.watchers; }
  bool takes_answer(std::size_t bytes) override {
    std::size_t under_way = 0;
    for (const auto& entry : sessions_) under_way += entry.second->unread();
    return under_way + bytes <= limits_.answer_bytes;
  }
  void watches() override { site_.note_watchers(watchers()); }
  void ended(int descriptor) override {
    if (is_over_) return;
    const auto session = sessions_.find(descriptor);
    if (session == sessions_.end()) return;
    // Whoever calls this is still in it.
    net::post(context_, [kept = session->second] {});
    sessions_.erase(session);
    site_.note_watchers(watchers());
  }

 private:
  std::size_t watchers() const {
    return static_cast<std::size_t>(std::count_if(
        sessions_.begin(), sessions_.end(),
        [](const auto& entry) { return entry.second->state() == Session::State::watches; }));
  }

  void tell_all(const Text& messages) {
    const std::map<int, std::shared_ptr<Session>> all = sessions_;  // telling may end some
    for (const auto& entry : all) entry.second->tell(messages);
  }

  void accept() {
    acceptor_.async_accept([this](ErrorCode error, Tcp::socket socket) {
      if (!error) admit(std::move(socket));
      if (error) accept_at_ms_ = steady_ms() + tick_ms;  // too many descriptors, perhaps
      if (!error) accept();
    });
  }

  void admit(Tcp::socket socket) {
    ErrorCode ignored;
    socket.set_option(Tcp::no_delay(true), ignored);
    socket.non_blocking(true, ignored);
    ::fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
    std::string peer = peer_of_socket(socket);
    const std::optional<bool> is_reserved = find_place(peer);
    if (!is_reserved) return;
    const auto session =
        std::make_shared<Session>(*this, std::move(socket), std::move(peer), *is_reserved);
    TF_CHECK(!sessions_.contains(session->descriptor()));
    sessions_[session->descriptor()] = session;
    session->read_request();
  }

  /// Whether the place for a newcomer is one of the reserved ones; nothing when there is none.
  std::optional<bool> find_place(const std::string& peer) {
    if (!peer.empty() && count_of(peer) >= limits_.of_address) {
      if (!make_way(places_of(peer, places(false)))) return std::nullopt;
      return false;
    }
    if (count(false) < limits_.connections || make_way(places(false))) return false;
    if (count(true) < limits_.reserved || make_way(places(true))) return true;
    return std::nullopt;
  }

  bool make_way(const std::vector<HttpPlace>& places) {
    const std::optional<int> descriptor = who_gives_way(places, steady_ms());
    if (!descriptor) return false;
    const std::shared_ptr<Session> session = sessions_.at(*descriptor);
    session->close();
    return true;
  }

  std::size_t count(bool reserved) const {
    return static_cast<std::size_t>(
        std::count_if(sessions_.begin(), sessions_.end(),
                      [&](const auto& entry) { return entry.second->is_reserved() == reserved; }));
  }
  std::size_t count_of(const std::string& peer) const {
    return static_cast<std::size_t>(
        std::count_if(sessions_.begin(), sessions_.end(),
                      [&](const auto& entry) { return entry.second->peer() == peer; }));
  }

  /// Those who may give way: not those who watch, whose number has a bound of its own.
  std::vector<HttpPlace> places(bool reserved) const {
    std::vector<HttpPlace> places;
    for (const auto& entry : sessions_) {
      const Session& session = *entry.second;
      const bool may_go = session.state() != Session::State::watches;
      if (may_go && session.is_reserved() == reserved) places.push_back(session.place());
    }
    return places;
  }

  void tick() {
    timer_.expires_after(std::chrono::milliseconds(tick_ms));
    timer_.async_wait([this](ErrorCode error) {
      if (error) return;
      look_at_clocks(steady_ms());
      tick();
    });
  }

  void look_at_clocks(std::int64_t now_ms) {
    const std::map<int, std::shared_ptr<Session>> all = sessions_;
    for (const auto& entry : all) entry.second->look_at_clock(now_ms);
    if (now_ms - alive_ms_ >= limits_.alive_ms) {
      alive_ms_ = now_ms;
      tell_all(text_of(": alive\n\n"));
    }
    if (accept_at_ms_ != 0 && now_ms >= accept_at_ms_) {
      accept_at_ms_ = 0;
      accept();
    }
  }

  WebSite& site_;
  const WebLimits limits_;
  net::io_context context_{1};
  Tcp::acceptor acceptor_;
  net::steady_timer timer_;
  std::map<int, std::shared_ptr<Session>> sessions_;
  std::int64_t alive_ms_ = steady_ms();
  std::int64_t accept_at_ms_ = 0;  ///< 0: it accepts
  bool is_over_ = false;
  std::thread thread_;
};

WebServer::WebServer(const HttpListener& listener, WebSite& site, const WebLimits& limits)
    : hall_(std::make_unique<Hall>(listener, site, limits)) {}

WebServer::~WebServer() = default;

void WebServer::publish(std::string messages) { hall_->publish(text_of(std::move(messages))); }

void WebServer::start() { hall_->start(); }

void WebServer::stop() { hall_->stop(); }

}  // namespace tetfarm
