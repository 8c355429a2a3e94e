/// The part of http_server.h that reads requests: no sockets.
#include <optional>
#include <sstream>

#include "base/check.h"
#include "coordinator/views/http_server.h"
#include "http/http_access.h"

namespace tetfarm {
namespace {

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
    const std::string name = lower_case(line.substr(0, colon));
    if (name == "host") fields.host = lower_case(without_blanks(line.substr(colon + 1)));
    if (name == "authorization") fields.authorization = without_blanks(line.substr(colon + 1));
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
             !has_http_token(fields->authorization, token)) {
    request.refusal = 401;
  }
  TF_CHECK(!request.path.empty() && request.path.front() == '/');
  return request;
}

}  // namespace tetfarm
