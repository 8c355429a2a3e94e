/// Where the dashboard's answers come from: a coordinator, or the rows of a store at rest. The
/// command line implements it (cli/watched_farm.h); tests have farms of their own.
///
/// All but give_up() are called by one thread. @throws of all that ask: NoAnswer when nobody
/// answers in time, Error (not_found, usage) for what is not there or senseless, (failed) when the
/// coordinator refuses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

class FarmSource {
 public:
  virtual ~FarmSource() = default;

  /// Who works, and what is wrong; no jobs.
  virtual wire::StatusReply farm() = 0;
  /// All that is known of one job; no jobs where it is not there.
  virtual wire::StatusReply job(const std::string& job) = 0;
  /// One page of rows.
  virtual wire::QueryReply page(const wire::Query& query) = 0;

  /// Where a file of the store lies, when it is there and of that size; nothing when it is not, or
  /// the store is not seen.
  virtual std::optional<std::filesystem::path> find_file(const wire::Artifact& file) = 0;
  /// Whether the store is seen.
  virtual bool sees_files() const = 0;

  /// False when there is no such job.
  virtual bool cancel(const std::string& job) = 0;
  /// The state of the job whose tasks are handed out by that priority from now on: of one that has
  /// ended it stays as it was. "": there is no such job.
  virtual std::string set_priority(const std::string& job, int priority) = 0;
  /// How many tasks were taken out of quarantine.
  virtual std::uint64_t retry(const wire::Retry& retry) = 0;
  /// How many workers take no more tasks: 1, or 0 when there is no such worker.
  virtual std::uint64_t drain(std::uint64_t worker) = 0;

  /// The answers are rows of a store that no coordinator uses.
  virtual bool is_at_rest() const = 0;
  /// Who answers: "tcp://head:5555", or the folder of the store.
  virtual std::string endpoint() const = 0;
  /// Ends what waits for an answer with NoAnswer, now and from now on; from any thread.
  virtual void give_up() = 0;
};

}  // namespace tetfarm
