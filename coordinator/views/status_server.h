/// What the coordinator shows over HTTP: /, /metrics, /healthz, /readyz.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coordinator/views/farm_metrics.h"
#include "coordinator/views/http_server.h"
#include "coordinator/views/query_answers.h"

namespace tetfarm {

class StatusServer {
 public:
  /// Listens when the address is not ""; counts all the same. @throws as HttpServer does.
  StatusServer(const HttpOptions& options, const std::filesystem::path& store,
               std::int64_t now_wall_ms);

  /// "" when it does not listen.
  std::string address() const { return http_ ? http_->address() : ""; }
  void add_poll_items(std::vector<zmq::pollitem_t>& items) const;

  /// What was committed; nothing when it could not be.
  void note(const ChangeSet& changes, double commit_seconds);
  void note_failed_commit();

  struct Surroundings {
    const Refusals& refusals;
    const std::string& database_trouble;  ///< "": none
    std::size_t connections = 0;
  };
  /// Answers requests; never waits.
  void serve(const QueryContext& context, const Surroundings& surroundings);

 private:
  HttpAnswer page(const std::string& path, const QueryContext& context,
                  const Surroundings& surroundings) const;

  std::filesystem::path store_;
  FarmMetrics metrics_;
  std::string trouble_;  ///< with the last commit, "": none
  std::optional<HttpServer> http_;
};

}  // namespace tetfarm
