/// The part of http_server.h that reads requests: no sockets.
#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include "base/check.h"
#include "coordinator/views/http_server.h"

namespace tetfarm {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return text;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Takes as long for a wrong text as for the right one.
bool is_same(const std::string& said, const std::string& secret) {
  TF_CHECK(!secret.empty());
  unsigned difference = said.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < said.size(); ++i) {
    difference |=
        static_cast<unsigned char>(said[i]) ^ static_cast<unsigned char>(secret[i % secret.size()]);
  }
  return difference == 0;
}

std::string from_base64(const std::string& text) {
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    static const std::string alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const std::size_t value = alphabet.find(c);
    if (value == std::string::npos) break;
    bits = (bits << 6U | static_cast<unsigned>(value)) & 0xFFFFFFU;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  return bytes;
}

/// "Bearer TOKEN" of programs, or "Basic …" of browsers, where the token is the password.
bool has_token(const std::string& authorization, const std::string& token) {
  const std::size_t space = authorization.find(' ');
  if (space == std::string::npos) return false;
  const std::string scheme = lower(authorization.substr(0, space));
  const std::string said = trimmed(authorization.substr(space));
  if (scheme == "bearer") return is_same(said, token);
  if (scheme != "basic") return false;
  const std::string pair = from_base64(said);
  const std::size_t colon = pair.find(':');
  return colon != std::string::npos && is_same(pair.substr(colon + 1), token);
}

/// A page of a stranger must not read ours through a name that leads here.
bool is_loopback_name(const std::string& host) {
  if (host.starts_with("[")) return host.starts_with("[::1]");
  const std::string name = host.substr(0, host.find(':'));
  return name == "localhost" ||
         (name.starts_with("127.") && name.find_first_not_of("0123456789.") == std::string::npos);
}

struct Fields {
  std::string host;
  std::string authorization;
};

/// Nothing when a line is no field.
std::optional<Fields> read_fields(std::istringstream& lines) {
  Fields fields;
  std::string line;
  while (std::getline(lines, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) return fields;
    const std::size_t colon = line.find(':');
    if (colon == 0 || colon == std::string::npos) return std::nullopt;
    const std::string name = lower(line.substr(0, colon));
    if (name == "host") fields.host = lower(trimmed(line.substr(colon + 1)));
    if (name == "authorization") fields.authorization = trimmed(line.substr(colon + 1));
  }
  return std::nullopt;
}

HttpRequest refused(int status) {
  TF_CHECK(status >= 400);
  HttpRequest request;
  request.refusal = status;
  return request;
}

}  // namespace

HttpRequest parse_http_request(const std::string& head, const std::string& token) {
  std::istringstream lines(head);
  std::string first;
  std::getline(lines, first);
  std::istringstream words(first);
  std::string method;
  std::string target;
  std::string version;
  if (!(words >> method >> target >> version) || !version.starts_with("HTTP/1.") ||
      !target.starts_with("/")) {
    return refused(400);
  }
  const std::optional<Fields> fields = read_fields(lines);
  if (!fields) return refused(400);
  HttpRequest request;
  request.is_head = method == "HEAD";
  request.path = target.substr(0, target.find('?'));
  if (method != "GET" && method != "HEAD") {
    request.refusal = 405;
  } else if (token.empty() && !is_loopback_name(fields->host)) {
    request.refusal = 403;
  } else if (!token.empty() && request.path != "/healthz" &&
             !has_token(fields->authorization, token)) {
    request.refusal = 401;
  }
  TF_CHECK(!request.path.empty() && request.path.front() == '/');
  return request;
}

}  // namespace tetfarm
