#include "dashboard/web_request.h"

#include "base/check.h"
#include "http/http_access.h"

namespace tetfarm {
namespace {

/// Pages of strangers can send a POST, but not with a field of our own, and not without saying
/// where they are from.
std::optional<ApiError> refusal_of_post(const WebRequest& request, const WebRules& rules) {
  TF_CHECK(request.method == "POST");
  if (!is_api_path(request.target)) return ApiError{405, "pages are only read", "use GET"};
  if (lower_case(request.act) != "yes") {
    return ApiError{403, "this changes something, and the field X-Tetfarm-Act is not there",
                    "send X-Tetfarm-Act: yes"};
  }
  if (!request.origin.empty() && !is_same_origin(request.origin, lower_case(request.host))) {
    return ApiError{403, "this comes from a page of another server",
                    "act from the dashboard's own page"};
  }
  if (!rules.acts) {
    return ApiError{403, "this dashboard only looks", "start it with --acts to let it act"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<ApiError> refusal_of(const WebRequest& request, const WebRules& rules) {
  if (!request.target.starts_with("/")) {
    return ApiError{400, "the target is not a path", "ask for a path such as /api/v1"};
  }
  if (rules.token.empty() && !is_loopback_name(lower_case(request.host))) {
    return ApiError{403, "the field Host does not name this host",
                    "use http://127.0.0.1 or http://localhost, or start the dashboard with "
                    "--http-token"};
  }
  if (!rules.token.empty() && !has_http_token(request.authorization, rules.token)) {
    return ApiError{401, "the token is missing or wrong",
                    "send Authorization: Bearer TOKEN, or give it as the password"};
  }
  if (request.method == "POST") return refusal_of_post(request, rules);
  if (request.method != "GET" && request.method != "HEAD") {
    return ApiError{405, "there is no such method here", "use GET"};
  }
  return std::nullopt;
}

}  // namespace tetfarm
