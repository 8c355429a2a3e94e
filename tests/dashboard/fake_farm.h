// A farm in memory that answers as a test wants, and counts what it is asked.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file_system.h"
#include "dashboard/farm_source.h"

namespace tetfarm {

class FakeFarm : public FarmSource {
 public:
  std::vector<wire::JobStatus> jobs;  ///< by rising number
  std::vector<wire::WorkerLine> workers;
  std::vector<wire::EventLine> events;
  std::vector<wire::TaskLine> tasks;
  std::vector<wire::SubdomainLine> subdomains;  ///< by rising path
  wire::Artifact surface;                       ///< of the job
  std::filesystem::path files;                  ///< folder of its store; "": it is not seen
  std::uint32_t rows_of_page = 1000;
  std::atomic<bool> is_silent = false;
  bool rests = false;
  std::string refuses;  ///< "": nothing

  /// How often it was asked that, and anything; from any thread.
  int times(const std::string& what) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = asked_.find(what);
    return found == asked_.end() ? 0 : found->second;
  }
  bool was_asked() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !asked_.empty();
  }

  void add_job(int number, const std::string& state) {
    wire::JobStatus& job = jobs.emplace_back();
    job.set_job("job-" + std::to_string(number));
    job.set_state(state);
    job.set_stage("mesh");
  }
  void add_event(std::uint64_t number) { events.emplace_back().set_event(number); }
  void add_tasks(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) tasks.emplace_back().set_task(tasks.size());
  }

  wire::StatusReply farm() override {
    note("farm");
    wire::StatusReply reply;
    reply.set_workers(static_cast<std::uint32_t>(workers.size()));
    return reply;
  }
  wire::StatusReply job(const std::string& name) override {
    note("job");
    wire::StatusReply reply;
    for (const wire::JobStatus& job : jobs) {
      if (job.job() == name) *reply.add_jobs() = job;
    }
    return reply;
  }
  wire::QueryReply page(const wire::Query& query) override {
    note(wire::Query::Subject_Name(query.subject()));
    wire::QueryReply reply;
    if (query.subject() == wire::Query::WORKERS) {
      for (const wire::WorkerLine& worker : workers) *reply.add_workers() = worker;
    } else if (query.subject() == wire::Query::EVENTS) {
      add_events(query, reply);
    } else if (query.subject() == wire::Query::TASKS) {
      add_rows(query, tasks, *reply.mutable_tasks(), reply);
    } else if (query.subject() == wire::Query::JOBS) {
      add_rows(query, jobs, *reply.mutable_jobs(), reply);
    } else if (query.subject() == wire::Query::TREE) {
      add_rows(query, subdomains, *reply.mutable_subdomains(), reply);
      if (!surface.hash().empty()) *reply.mutable_surface() = surface;
    } else if (query.subject() == wire::Query::EXPLAIN) {
      if (query.task() == 99) throw Error(ExitCode::not_found, "no task 99");
      reply.mutable_explanation()->mutable_task()->set_task(query.task());
      reply.mutable_explanation()->mutable_task()->set_job("job-5");
    }
    return reply;
  }
  std::optional<std::filesystem::path> find_file(const wire::Artifact& file) override {
    const std::filesystem::path path = files / file.hash();
    if (!sees_files() || size_of_file(path) != file.size()) return std::nullopt;
    return path;
  }
  bool sees_files() const override { return !files.empty(); }
  bool cancel(const std::string& name) override {
    note("cancel " + name);
    return true;
  }
  std::string set_priority(const std::string& name, int priority) override {
    note("priority " + name + " " + std::to_string(priority));
    return name == "job-404" ? "" : "running";
  }
  std::uint64_t retry(const wire::Retry& retry) override {
    note("retry " + retry.job() + " " + std::to_string(retry.task()) + retry.host());
    return retry.host().empty() ? 2 : 1;
  }
  std::uint64_t drain(std::uint64_t worker) override {
    note("drain " + std::to_string(worker));
    return 1;
  }
  bool is_at_rest() const override { return rests; }
  std::string endpoint() const override { return "tcp://head:5555"; }
  void give_up() override { is_silent = true; }

 private:
  void note(const std::string& what) {
    if (is_silent) throw NoAnswer("no coordinator answers");
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++asked_[what];
    }
    if (!refuses.empty()) throw Error(ExitCode::failed, refuses);
  }
  /// Rows are told apart by where they lie.
  template <class Rows, class Field>
  void add_rows(const wire::Query& query, const Rows& rows, Field& field, wire::QueryReply& reply) {
    std::uint64_t row = query.after();
    for (; row < rows.size() && row < query.after() + rows_of_page; ++row) {
      *field.Add() = rows[row];
    }
    reply.set_next(row < rows.size() ? row : 0);
  }
  void add_events(const wire::Query& query, wire::QueryReply& reply) const {
    std::vector<wire::EventLine> found;
    for (const wire::EventLine& event : events) {
      if (event.event() > query.after()) found.push_back(event);
    }
    if (found.size() > query.limit() && query.newest()) {
      found.erase(found.begin(), found.end() - query.limit());
    } else if (found.size() > query.limit()) {
      found.resize(query.limit());
      reply.set_next(found.back().event());
    }
    for (const wire::EventLine& event : found) *reply.add_events() = event;
  }

  mutable std::mutex mutex_;
  std::map<std::string, int> asked_;
};

}  // namespace tetfarm
