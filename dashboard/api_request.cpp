#include "dashboard/api_request.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <optional>

#include "base/check.h"

namespace tetfarm {
namespace {

struct ApiRoute {
  const char* method = "";
  std::string_view path;  ///< JOB, TASK, WORKER, HOST, SUBDOMAIN and MAP stand for one
  ApiSubject subject = ApiSubject::about;
};

constexpr std::array<ApiRoute, 22> api_routes = {{
    {"GET", "/api/v1", ApiSubject::about},
    {"GET", "/api/v1/farm", ApiSubject::farm},
    {"GET", "/api/v1/jobs", ApiSubject::jobs},
    {"GET", "/api/v1/jobs/JOB", ApiSubject::job},
    {"GET", "/api/v1/jobs/JOB/tasks", ApiSubject::tasks},
    {"GET", "/api/v1/jobs/JOB/attempts", ApiSubject::attempts},
    {"GET", "/api/v1/jobs/JOB/events", ApiSubject::job_events},
    {"GET", "/api/v1/jobs/JOB/surfaces", ApiSubject::surfaces},
    {"GET", "/api/v1/jobs/JOB/surfaces/SUBDOMAIN", ApiSubject::surface},
    {"GET", "/api/v1/jobs/JOB/maps", ApiSubject::maps},
    {"GET", "/api/v1/jobs/JOB/maps/MAP", ApiSubject::map},
    {"GET", "/api/v1/tasks/TASK", ApiSubject::task},
    {"GET", "/api/v1/tasks/TASK/logs", ApiSubject::task_logs},
    {"GET", "/api/v1/workers", ApiSubject::workers},
    {"GET", "/api/v1/events", ApiSubject::events},
    {"GET", "/api/v1/changes", ApiSubject::changes},
    {"POST", "/api/v1/jobs/JOB/cancel", ApiSubject::cancel_job},
    {"POST", "/api/v1/jobs/JOB/retry", ApiSubject::retry_job},
    {"POST", "/api/v1/jobs/JOB/priority", ApiSubject::set_priority},
    {"POST", "/api/v1/tasks/TASK/retry", ApiSubject::retry_task},
    {"POST", "/api/v1/hosts/HOST/retry", ApiSubject::retry_host},
    {"POST", "/api/v1/workers/WORKER/drain", ApiSubject::drain_worker},
}};

std::vector<std::string_view> split(std::string_view text, char between) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(between);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || error != std::errc{} || stopped != end) return std::nullopt;
  return number;
}

/// The number of "job-7" or "worker-7"; nothing of anything else.
std::optional<std::uint64_t> number_after(std::string_view prefix, std::string_view text) {
  if (!text.starts_with(prefix)) return std::nullopt;
  return number_in(text.substr(prefix.size()));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// What "%2C" stands for; what is malformed stays as it is.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool has_digits = text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
                            hex_digit(text[i + 2]) >= 0;
    if (!has_digits) {
      plain += text[i];
      continue;
    }
    plain += static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2]));
    i += 2;
  }
  return plain;
}

/// Of a host, as the path has it.
bool read_host(std::string_view part, std::string& host) {
  constexpr std::size_t longest_host = 255;
  host = decoded(part);
  return !host.empty() && host.size() <= longest_host;
}

/// Whether a part of a path is what stands in its place in the route; notes what it names.
bool takes_part(std::string_view wanted, std::string_view part, ApiRequest& request) {
  if (wanted == "JOB") {
    if (!number_after("job-", part)) return false;
    request.job = part;
    return true;
  }
  if (wanted == "HOST") return read_host(part, request.host);
  const bool is_number =
      wanted == "TASK" || wanted == "WORKER" || wanted == "SUBDOMAIN" || wanted == "MAP";
  if (!is_number) return wanted == part;
  std::optional<std::uint64_t> number = number_in(part);
  if (wanted == "WORKER" && !number) number = number_after("worker-", part);
  if (!number || *number == 0) return false;  // 0 stands for all of them elsewhere
  request.number = *number;
  return true;
}

std::optional<ApiRequest> taken(const ApiRoute& route, std::string_view path) {
  const std::vector<std::string_view> wanted = split(route.path, '/');
  const std::vector<std::string_view> parts = split(path, '/');
  if (wanted.size() != parts.size()) return std::nullopt;
  ApiRequest request;
  request.subject = route.subject;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!takes_part(wanted[i], parts[i], request)) return std::nullopt;
  }
  return request;
}

/// A number from 1 to `most`.
bool read_bounded(std::string_view text, std::uint32_t most, std::uint32_t& number) {
  const std::optional<std::uint64_t> read = number_in(text);
  if (!read || *read < 1 || *read > most) return false;
  number = static_cast<std::uint32_t>(*read);
  return true;
}

ApiError out_of_bounds(std::string_view name, std::uint32_t most) {
  return {400, std::string(name) + " is not a number from 1 to " + std::to_string(most),
          "give a number in these bounds, or leave it out"};
}

bool read_columns(const std::string& text, std::vector<std::string>& columns) {
  constexpr std::size_t most_columns = 64;
  for (const std::string_view name : split(text, ',')) columns.emplace_back(name);
  return columns.size() <= most_columns;
}

/// How many of a surface or a map.
std::optional<ApiError> read_triangles(const std::string& value, ApiRequest& request) {
  if (!read_bounded(value, most_shown_triangles, request.triangles)) {
    return out_of_bounds("triangles", most_shown_triangles);
  }
  request.triangles = std::bit_floor(request.triangles);
  return std::nullopt;
}

ApiError no_priority() {
  const std::string most = std::to_string(highest_priority);
  return {400, "the priority is missing, or no whole number from -" + most + " to " + most,
          "say which the job is to have: ?priority=10"};
}

std::optional<ApiError> read_priority(std::string_view value, ApiRequest& request) {
  const bool is_below_0 = value.starts_with('-');
  const std::optional<std::uint64_t> size = number_in(value.substr(is_below_0 ? 1 : 0));
  if (!size || *size > static_cast<std::uint64_t>(highest_priority)) return no_priority();
  request.priority = is_below_0 ? -static_cast<int>(*size) : static_cast<int>(*size);
  return std::nullopt;
}

/// What is wrong with "name=value"; nothing when it is read.
std::optional<ApiError> read_parameter(std::string_view name, const std::string& value,
                                       ApiRequest& request) {
  const bool is_table =
      request.subject == ApiSubject::tasks || request.subject == ApiSubject::attempts;
  const bool is_surface =
      request.subject == ApiSubject::surface || request.subject == ApiSubject::map;
  const bool is_events =
      request.subject == ApiSubject::events || request.subject == ApiSubject::job_events;
  if (name == "columns" && is_table) {
    if (read_columns(value, request.columns)) return std::nullopt;
    return ApiError{400, "too many columns", "name each once, or leave them out"};
  }
  if (name == "after" && is_table) {
    const std::optional<std::uint64_t> after = number_in(value);
    if (!after) return ApiError{400, "after is not a number", "give `next` of the page before"};
    request.after = *after;
    return std::nullopt;
  }
  if (name == "limit" && is_table) {
    if (read_bounded(value, most_rows, request.limit)) return std::nullopt;
    return out_of_bounds(name, most_rows);
  }
  if (name == "last" && is_events) {
    if (read_bounded(value, most_events, request.last)) return std::nullopt;
    return out_of_bounds(name, most_events);
  }
  if (name == "triangles" && is_surface) return read_triangles(value, request);
  if (name == "priority" && request.subject == ApiSubject::set_priority) {
    return read_priority(value, request);
  }
  if (name == "gone" && request.subject == ApiSubject::workers && (value == "0" || value == "1")) {
    request.with_gone = value == "1";
    return std::nullopt;
  }
  return ApiError{400, "no such parameter here: " + std::string(name),
                  "docs/api.md lists the parameters of each path"};
}

std::optional<ApiError> read_parameters(std::string_view query, ApiRequest& request) {
  if (query.empty()) {
    if (request.subject == ApiSubject::set_priority) return no_priority();
    return std::nullopt;
  }
  for (const std::string_view part : split(query, '&')) {
    const std::size_t equals = part.find('=');
    const std::string_view value =
        equals == std::string_view::npos ? std::string_view() : part.substr(equals + 1);
    std::optional<ApiError> wrong = read_parameter(part.substr(0, equals), decoded(value), request);
    if (wrong) return wrong;
  }
  return std::nullopt;
}

}  // namespace

bool is_api_path(std::string_view target) {
  const std::string_view path = target.substr(0, target.find('?'));
  return path == "/api" || path.starts_with("/api/");
}

bool is_act(ApiSubject subject) { return subject >= ApiSubject::cancel_job; }

std::variant<ApiRequest, ApiError> parse_api_request(const std::string& method,
                                                     const std::string& target) {
  TF_CHECK(is_api_path(target));
  const std::string_view whole = target;
  const std::size_t mark = whole.find('?');
  const std::string_view path = whole.substr(0, mark);
  const std::string_view wanted = method == "HEAD" ? "GET" : std::string_view(method);
  const ApiRoute* other = nullptr;
  for (const ApiRoute& route : api_routes) {
    std::optional<ApiRequest> request = taken(route, path);
    if (!request) continue;
    other = &route;
    if (wanted != route.method) continue;
    const std::string_view query =
        mark == std::string_view::npos ? std::string_view() : whole.substr(mark + 1);
    if (std::optional<ApiError> wrong = read_parameters(query, *request)) return std::move(*wrong);
    return std::move(*request);
  }
  if (other != nullptr) {
    return ApiError{405, "this path has no such method", std::string("use ") + other->method};
  }
  return ApiError{404, "no such path", "GET /api/v1 lists the paths"};
}

std::vector<std::string> api_paths() {
  std::vector<std::string> paths;
  for (const ApiRoute& route : api_routes) {
    paths.push_back(std::string(route.method) + " " + std::string(route.path));
  }
  return paths;
}

}  // namespace tetfarm
