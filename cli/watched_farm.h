/// The farm that a dashboard shows, asked as the commands that look ask it (cli/farm_view.h), for
/// as long as the dashboard serves: it waits for a coordinator that does not answer, and turns from
/// a store at rest to the coordinator that begins to use it, and back.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "cli/farm_view.h"
#include "dashboard/farm_source.h"
#include "store/artifact_store.h"

namespace tetfarm {

class WatchedFarm : public FarmSource {
 public:
  /// @throws as FarmView.
  explicit WatchedFarm(const ViewOptions& options);

  wire::StatusReply farm() override;
  wire::StatusReply job(const std::string& job) override;
  wire::QueryReply page(const wire::Query& query) override;
  std::optional<std::filesystem::path> find_file(const wire::Artifact& file) override;
  bool sees_files() const override { return files_.has_value(); }
  bool cancel(const std::string& job) override;
  std::string set_priority(const std::string& job, int priority) override;
  std::uint64_t retry(const wire::Retry& retry) override;
  std::uint64_t drain(std::uint64_t worker) override;
  bool is_at_rest() const override { return view_ && view_->is_at_rest(); }
  std::string endpoint() const override;
  void give_up() override { has_given_up_ = true; }

 private:
  FarmView& view();
  void look_for_coordinator();
  CoordinatorConnection& coordinator();
  template <class Question>
  auto patiently(const Question& question);

  ViewOptions options_;
  std::int64_t timeout_ms_;
  std::optional<FarmView> view_;
  std::optional<ArtifactStore> files_;  ///< of the store, where one is named
  std::int64_t opened_ms_ = 0;
  std::atomic<bool> has_given_up_ = false;
};

}  // namespace tetfarm
