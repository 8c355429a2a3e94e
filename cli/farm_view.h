/// Where commands that only look get their answers: from a running coordinator, or, where none
/// answers, from the rows of the store itself, which are read and never changed.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "proto/messages.pb.h"

namespace tetfarm {

class CoordinatorConnection;
class StoreAtRest;

class FarmView {
 public:
  /// With an endpoint that coordinator is asked, and nobody else. Without, the one that the store
  /// names, and when it does not answer the store's rows are read; standard error says so.
  /// @throws UsageError when neither endpoint nor store is named, Error (not_found) when nothing
  /// answers or there is no database.
  explicit FarmView(const ViewOptions& options);
  ~FarmView();

  wire::StatusReply status();
  /// Of one job or ("") all.
  wire::StatusReply status_of(const std::string& job);
  /// Who works, and what is wrong; no jobs.
  wire::StatusReply farm();
  /// One page.
  wire::QueryReply page(const wire::Query& query);
  /// Every page, one after the other. @throws Error.
  void ask(wire::Query query, const std::function<void(const wire::QueryReply&)>& take);
  bool is_at_rest() const { return rows_ != nullptr; }
  /// Who answers: the coordinator's address, or the folder of the store.
  const std::string& endpoint() const { return endpoint_; }
  /// To the coordinator that answers; nothing at rest.
  CoordinatorConnection* connection();

 private:
  struct Live;
  void connect(const std::string& endpoint, std::int64_t timeout_ms);
  void read_rows(const std::string& store);

  ViewOptions options_;
  std::string endpoint_;
  std::unique_ptr<Live> live_;
  std::unique_ptr<StoreAtRest> rows_;
};

}  // namespace tetfarm
