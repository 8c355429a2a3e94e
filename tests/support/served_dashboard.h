/// `tetfarm dashboard` as a process, and what it answers. Nothing here waits longer than its
/// patience.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/security/attacker.h"
#include "tests/support/program.h"

namespace tetfarm::test {

struct WebReply {
  int status = 0;  ///< 0: none came
  std::string head;
  std::string body;
  nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
};

class ServedDashboard {
 public:
  /// Started in `folder` with these words; at a free port, and quick to say that nobody answers.
  ServedDashboard(std::vector<std::string> words, const std::filesystem::path& folder)
      : program_(with_usual(std::move(words)), folder) {
    for (int i = 0; i < patience_ms / 10 && url().empty() && program_.is_running(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_NE(url(), "") << program_.wait(0).err;
  }

  std::string url() const {
    const std::string said = program_.out_so_far();
    return said.substr(0, said.find('\n') == std::string::npos ? 0 : said.find('\n'));
  }
  int port() const {
    const std::string text = url();
    return text.empty() ? 0 : port_of(text.substr(0, text.size() - 1));
  }
  Program& program() { return program_; }

  WebReply ask(const std::string& method, const std::string& target,
               const std::string& fields = "") const {
    const RawConnection connection(port());
    const bool names_host = fields.find("Host:") != std::string::npos;
    connection.send(method + " " + target + " HTTP/1.1\r\nConnection: close\r\n" +
                    (names_host ? "" : "Host: localhost\r\n") + fields + "\r\n");
    return reply_of(connection.hear());
  }
  WebReply get(const std::string& target, const std::string& fields = "") const {
    return ask("GET", target, fields);
  }
  WebReply act(const std::string& target, const std::string& fields = "") const {
    return ask("POST", target, "X-Tetfarm-Act: yes\r\n" + fields);
  }
  /// Asks again and again until the answer is as wished.
  template <class Wish>
  bool comes_true(const std::string& target, const Wish& wish) const {
    for (int i = 0; i < patience_ms / 50; ++i) {
      const WebReply reply = get(target);
      if (reply.status == 200 && wish(reply.json())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  static WebReply reply_of(const std::string& bytes) {
    WebReply reply;
    const std::size_t end = bytes.find("\r\n\r\n");
    if (!bytes.starts_with("HTTP/1.1 ") || end == std::string::npos) return reply;
    reply.status = std::stoi(bytes.substr(9, 3));
    reply.head = bytes.substr(0, end);
    reply.body = bytes.substr(end + 4);
    return reply;
  }

 private:
  static std::vector<std::string> with_usual(std::vector<std::string> words) {
    const bool has_timeout = std::find(words.begin(), words.end(), "--timeout") != words.end();
    if (!has_timeout) words.insert(words.end(), {"--timeout", "1"});
    words.insert(words.begin(), {"dashboard", "--http", "127.0.0.1:0"});
    return words;
  }

  Program program_;
};

}  // namespace tetfarm::test
