#include "coordinator/views/status_server.h"

#include "base/error.h"
#include "coordinator/views/status_page.h"

namespace tetfarm {
namespace {

constexpr const char* metrics_type = "text/plain; version=0.0.4; charset=utf-8";

FarmSurroundings measured(const std::filesystem::path& store, std::size_t connections) {
  FarmSurroundings figures;
  figures.connections = connections;
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(store, error);
  if (error) return figures;
  figures.store_free_bytes = space.available;
  figures.store_size_bytes = space.capacity;
  return figures;
}

}  // namespace

StatusServer::StatusServer(const HttpOptions& options, const std::filesystem::path& store,
                           std::int64_t now_wall_ms)
    : store_(store), metrics_(now_wall_ms) {
  if (!options.address.empty()) http_.emplace(options);
}

void StatusServer::add_poll_items(std::vector<zmq::pollitem_t>& items) const {
  if (http_) http_->add_poll_items(items);
}

void StatusServer::note(const ChangeSet& changes, double commit_seconds) {
  metrics_.note(changes, commit_seconds);
  trouble_.clear();
}

void StatusServer::note_failed_commit() {
  metrics_.note_failed_commit();
  trouble_ = "the last database transaction failed\n";
}

HttpAnswer StatusServer::page(const std::string& path, const QueryContext& context,
                              const Surroundings& surroundings) const {
  HttpAnswer answer;
  if (path == "/healthz") {
    answer.body = "ok\n";
  } else if (path == "/readyz") {
    const std::string& closed = surroundings.database_trouble;
    const bool is_stuck = context.state.is_stuck();
    answer.body = !closed.empty() ? "not ready: " + closed + "\n"
                  : is_stuck      ? "no room: " + context.state.stuck_message() + "\n"
                                  : trouble_;
    answer.status = answer.body.empty() ? 200 : 503;
    if (answer.body.empty()) answer.body = "ready\n";
  } else if (path == "/metrics") {
    answer.type = metrics_type;
    answer.body = metrics_.text(context.state, surroundings.refusals,
                                measured(store_, surroundings.connections));
  } else if (path == "/") {
    answer.type = "text/html; charset=utf-8";
    answer.body = status_page(context);
  } else {
    answer.status = 404;
    answer.body = "no such page\n";
  }
  return answer;
}

void StatusServer::serve(const QueryContext& context, const Surroundings& surroundings) {
  if (!http_) return;
  http_->serve(context.now.steady_ms, [&](const std::string& path) {
    try {
      return page(path, context, surroundings);
    } catch (const Error& error) {
      return HttpAnswer{503, "text/plain; charset=utf-8", std::string(error.what()) + "\n"};
    }
  });
}

}  // namespace tetfarm
