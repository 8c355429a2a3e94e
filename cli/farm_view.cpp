#include "cli/farm_view.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "base/error.h"
#include "base/file_system.h"
#include "cli/coordinator_connection.h"
#include "cli/run_folder.h"
#include "coordinator/server.h"
#include "coordinator/views/store_at_rest.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// The store's own endpoint may be that of a coordinator that was killed.
constexpr std::int64_t patience_with_a_store_ms = 2'000;

std::string first_endpoint(const fs::path& store) {
  if (!size_of_file(endpoints_file(store))) return {};
  std::istringstream lines(read_file(endpoints_file(store)));
  std::string line;
  std::getline(lines, line);
  return line;
}

}  // namespace

struct FarmView::Live {
  Live(const std::string& endpoint, const std::optional<PeerKeys>& keys, std::int64_t patience_ms)
      : connection(endpoint, keys), timeout_ms(patience_ms) {}
  CoordinatorConnection connection;
  std::int64_t timeout_ms;
};

FarmView::FarmView(const ViewOptions& options) : options_(options) {
  const auto timeout_ms = static_cast<std::int64_t>(options.client.timeout_s * 1000);
  if (!options.client.endpoint.empty()) {
    connect(options.client.endpoint, timeout_ms);
    return;
  }
  if (options.store.empty()) {
    throw UsageError("give a coordinator (--connect, or $TETFARM_COORDINATOR) or a store (--store)",
                     "");
  }
  const fs::path store = require_store_of(options.store);
  const std::string endpoint = first_endpoint(store);
  if (!endpoint.empty()) {
    connect(endpoint, std::min(timeout_ms, patience_with_a_store_ms));
    try {
      wire::Query any;
      any.set_subject(wire::Query::JOBS);
      any.set_limit(1);
      page(any);
      live_->timeout_ms = timeout_ms;
      return;
    } catch (const Error& error) {
      if (error.code() != ExitCode::not_found) throw;
      live_.reset();
    }
  }
  read_rows(store.string());
}

FarmView::~FarmView() = default;

void FarmView::connect(const std::string& endpoint, std::int64_t timeout_ms) {
  const std::string store =
      options_.store.empty() ? "" : store_of(options_.store).value_or(options_.store).string();
  endpoint_ = endpoint;
  const bool is_ipc = endpoint.starts_with("ipc://");
  live_ = std::make_unique<Live>(
      endpoint, is_ipc ? std::nullopt : read_peer_keys(options_.client.keys, store), timeout_ms);
}

void FarmView::read_rows(const std::string& folder) {
  const fs::path database = options_.database.empty() ? folder : options_.database;
  rows_ = std::make_unique<StoreAtRest>(folder, database);
  endpoint_ = folder;
  if (options_.is_quiet) return;
  std::fprintf(stderr, "note: no coordinator answers; this is what %s recorded\n", folder.c_str());
}

wire::QueryReply FarmView::page(const wire::Query& query) {
  if (live_) return live_->connection.query(query, live_->timeout_ms);
  return rows_->answer(query);
}

void FarmView::ask(wire::Query query, const std::function<void(const wire::QueryReply&)>& take) {
  while (true) {
    const wire::QueryReply reply = page(query);
    take(reply);
    if (reply.next() == 0) return;
    query.set_after(reply.next());
  }
}

wire::StatusReply FarmView::status() { return status_of(options_.client.job); }

wire::StatusReply FarmView::status_of(const std::string& job) {
  if (live_) return live_->connection.status(job, live_->timeout_ms);
  return rows_->status(job);
}

wire::StatusReply FarmView::farm() {
  if (live_) return live_->connection.farm(live_->timeout_ms);
  wire::StatusReply reply = rows_->status("");
  reply.clear_jobs();
  return reply;
}

CoordinatorConnection* FarmView::connection() { return live_ ? &live_->connection : nullptr; }

}  // namespace tetfarm
