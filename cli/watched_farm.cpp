#include "cli/watched_farm.h"

#include <algorithm>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "cli/coordinator_connection.h"
#include "cli/run_folder.h"

namespace tetfarm {
namespace {

/// Between two times that a store at rest is read, which may have a coordinator by then.
constexpr std::int64_t reopen_ms = 3'000;
/// For a coordinator that a store names, and that is probably not there.
constexpr double probe_s = 0.3;
/// How long to wait at once: a command that is to end is not held up longer.
constexpr std::int64_t slice_ms = 1'000;

ViewOptions in_slices(ViewOptions options) {
  options.client.timeout_s =
      std::min(options.client.timeout_s, static_cast<double>(slice_ms) / 1000);
  options.is_quiet = true;
  return options;
}

}  // namespace

WatchedFarm::WatchedFarm(const ViewOptions& options)
    : options_(in_slices(options)),
      timeout_ms_(static_cast<std::int64_t>(options.client.timeout_s * 1000)),
      opened_ms_(steady_ms()) {
  TF_CHECK(timeout_ms_ >= 0);
  view_.emplace(options_);
  const auto store = options.store.empty() ? std::nullopt : store_of(options.store);
  if (store) files_.emplace(ArtifactStore::open_existing(*store));
}

/// @throws as FarmView.
FarmView& WatchedFarm::view() {
  if (!view_) {
    view_.emplace(options_);
    opened_ms_ = steady_ms();
  }
  return *view_;
}

std::string WatchedFarm::endpoint() const {
  if (view_) return view_->endpoint();
  return options_.client.endpoint.empty() ? options_.store : options_.client.endpoint;
}

/// Of a store at rest: its rows may have changed, and somebody may have begun to use it.
void WatchedFarm::look_for_coordinator() {
  if (!is_at_rest() || steady_ms() - opened_ms_ < reopen_ms) return;
  ViewOptions quickly = options_;
  quickly.client.timeout_s = std::min(quickly.client.timeout_s, probe_s);
  view_.emplace(quickly);
  opened_ms_ = steady_ms();
  if (!is_at_rest()) view_.emplace(options_);
}

/// Asks until there is an answer, it is over, or the time is up.
template <class Question>
auto WatchedFarm::patiently(const Question& question) {
  const std::int64_t until = steady_ms() + timeout_ms_;
  while (true) {
    if (has_given_up_) throw NoAnswer("the dashboard is ending");
    try {
      return question();
    } catch (const NoAnswer&) {
      if (has_given_up_ || steady_ms() < until) continue;
      // The store may tell of another coordinator the next time, or of none.
      if (options_.client.endpoint.empty()) view_.reset();
      throw;
    }
  }
}

wire::StatusReply WatchedFarm::farm() {
  look_for_coordinator();
  return patiently([&] { return view().farm(); });
}

wire::StatusReply WatchedFarm::job(const std::string& job) {
  return patiently([&] { return view().status_of(job); });
}

wire::QueryReply WatchedFarm::page(const wire::Query& query) {
  return patiently([&] { return view().page(query); });
}

/// @throws Error at rest.
CoordinatorConnection& WatchedFarm::coordinator() {
  CoordinatorConnection* connection = view().connection();
  if (connection == nullptr) {
    throw Error(ExitCode::failed, "no coordinator uses this store: there is nobody to do it");
  }
  return *connection;
}

std::optional<std::filesystem::path> WatchedFarm::find_file(const wire::Artifact& file) {
  if (!files_ || !files_->has(file.hash(), file.size())) return std::nullopt;
  return files_->path_of(file.hash());
}

bool WatchedFarm::cancel(const std::string& job) {
  return patiently([&] { return coordinator().cancel(job, slice_ms).found(); });
}

std::string WatchedFarm::set_priority(const std::string& job, int priority) {
  return patiently([&] {
    const wire::PrioritySet set = coordinator().set_priority(job, priority, slice_ms);
    return set.found() ? set.state() : std::string();
  });
}

std::uint64_t WatchedFarm::retry(const wire::Retry& retry) {
  return patiently([&] { return coordinator().retry(retry, slice_ms).count(); });
}

std::uint64_t WatchedFarm::drain(std::uint64_t worker) {
  TF_CHECK(worker != 0);  // 0 is all of them
  return patiently([&] { return coordinator().drain(worker, slice_ms).count(); });
}

}  // namespace tetfarm
