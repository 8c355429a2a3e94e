/// A request as the dashboard's HTTP server read it, and whether it may have an answer. No sockets.
#pragma once

#include <optional>
#include <string>

#include "dashboard/api_request.h"

namespace tetfarm {

struct WebRequest {
  std::string method;  ///< "GET"
  std::string target;  ///< "/api/v1/jobs?…"
  std::string host;    ///< of the fields; "": it is not there
  std::string origin;
  std::string authorization;
  std::string act;  ///< X-Tetfarm-Act
};

struct WebRules {
  std::string
      token;  ///< "": none is asked for, and requests must name this host by a loopback name
  bool acts = false;  ///< POST may change something
};

/// Why it gets none: 400 for a target that is no path, 405 for a method but GET, HEAD and POST, 401
/// without the token, 403 for a name that is not this host's, and for a POST that no page of this
/// server can have sent or that nobody allowed.
std::optional<ApiError> refusal_of(const WebRequest& request, const WebRules& rules);

}  // namespace tetfarm
