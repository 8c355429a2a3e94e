#include "dashboard/farm_look.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "base/check.h"
#include "json/job_json.h"
#include "json/job_share.h"
#include "json/json_line.h"
#include "json/progress_json.h"
#include "json/query_json.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_running_jobs = 16;
constexpr std::int64_t shortest_rest_ms = 1'000;
constexpr std::int64_t longest_rest_ms = 60'000;
constexpr std::int64_t rest_in_looks = 10;

/// Jobs are numbered by their names: "job-7".
std::uint64_t number_of_job(const std::string& name) {
  std::uint64_t number = 0;
  for (const char c : name) {
    if (c >= '0' && c <= '9') number = number * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return number;
}

std::string with_share(const std::string& line, double share,
                       const std::optional<double>& eta_seconds = {}) {
  TF_CHECK(share >= 0 && share <= 1);
  Json json = Json::parse(line);
  json["share"] = share;
  json["eta_seconds"] = eta_seconds ? Json(*eta_seconds) : Json(nullptr);
  return json_line(json);
}

/// Its results, or what shows why it failed.
Json files_of_job(const wire::JobStatus& status) {
  Json files = Json::array();
  for (const wire::Artifact& file : status.files()) {
    files.push_back({{"name", file.name()}, {"size", file.size()}});
  }
  return files;
}

/// How many tasks wait, by the memory that they want.
Json demand_of(const wire::StatusReply& farm) {
  Json demand = Json::array();
  for (const wire::TaskDemand& tasks : farm.demand()) {
    demand.push_back({{"memory_bytes", tasks.memory_bytes()},
                      {"tasks", tasks.tasks()},
                      {"of_solvers", tasks.of_solvers()}});
  }
  return demand;
}

/// Calls `take` with every page.
template <class Take>
void all_pages(FarmSource& source, wire::Query query, const Take& take) {
  while (true) {
    const wire::QueryReply page = source.page(query);
    take(page);
    if (page.next() == 0) return;
    query.set_after(page.next());
  }
}

void add_workers(FarmSource& source, FarmSnapshot& snapshot) {
  wire::Query query;
  query.set_subject(wire::Query::WORKERS);
  all_pages(source, query, [&](const wire::QueryReply& page) {
    for (const wire::WorkerLine& worker : page.workers()) {
      snapshot.workers.push_back(worker_json(worker));
    }
  });
}

void append_events(const wire::QueryReply& page, FarmSnapshot& snapshot) {
  for (const wire::EventLine& event : page.events()) {
    const bool is_known =
        !snapshot.events.empty() && event.event() <= snapshot.events.back().number;
    if (!is_known) snapshot.events.push_back({event.event(), event_json(event)});
  }
}

/// Those that came since `before`; only the newest where there are more of them than are kept.
void add_events(FarmSource& source, const FarmSnapshot& before, FarmSnapshot& snapshot) {
  wire::Query query;
  query.set_subject(wire::Query::EVENTS);
  query.set_limit(most_events_seen);
  snapshot.events = before.events;
  bool has_missed = snapshot.events.empty();
  if (!has_missed) {
    query.set_after(snapshot.events.back().number);
    const wire::QueryReply page = source.page(query);
    has_missed = page.next() != 0;
    if (!has_missed) append_events(page, snapshot);
  }
  if (has_missed) {
    query.set_after(0);
    query.set_newest(true);
    append_events(source.page(query), snapshot);
  }
  if (snapshot.events.size() <= most_events_seen) return;
  snapshot.events.erase(snapshot.events.begin(), snapshot.events.end() - most_events_seen);
}

}  // namespace

std::string FarmLook::job_body(const wire::StatusReply& reply, const LookTime& now) {
  TF_CHECK(reply.jobs_size() == 1);
  const wire::JobStatus& status = reply.jobs(0);
  MeshingRate rate;
  if (const auto known = rates_.find(status.job()); known != rates_.end()) rate = known->second;
  rate.note(status, now.steady_ms);
  Json json = Json::parse(status_json(status));
  const Json progress = Json::parse(progress_json(
      status, {.wall_ms = now.wall_ms,
               .share = share_of_job(status, rate.share()),
               .workers = reply.workers(),
               .eta_seconds = seconds_of_meshing_left(status, rate.tets_per_second())}));
  for (const auto& item : progress.items()) {
    if (!json.contains(item.key())) json[item.key()] = item.value();
  }
  json["files"] = files_of_job(status);
  if (status.state() == "done") {
    json["result"] = Json::parse(result_json(status, status.seconds(), {}));
    json["result"].erase("files");
  }
  return json_line(json);
}

/// The line of a job that runs, whose share is known from all that is told of it alone.
std::string FarmLook::running_line(FarmSource& source, const wire::JobStatus& line,
                                   const LookTime& now, FarmSnapshot& snapshot) {
  const wire::StatusReply reply = source.job(line.job());
  if (reply.jobs_size() != 1) return with_share(job_json(line), share_of_job(line, 0));
  MeshingRate& rate = rates_[line.job()];
  rate.note(reply.jobs(0), now.steady_ms);
  snapshot.running_jobs[line.job()] = job_body(reply, now);
  return with_share(job_json(line), share_of_job(reply.jobs(0), rate.share()),
                    seconds_of_meshing_left(reply.jobs(0), rate.tets_per_second()));
}

/// How many there are.
std::size_t FarmLook::add_jobs(FarmSource& source, const LookTime& now, FarmSnapshot& snapshot) {
  wire::Query query;
  query.set_subject(wire::Query::JOBS);
  std::deque<wire::JobStatus> newest;
  std::size_t count = 0;
  all_pages(source, query, [&](const wire::QueryReply& page) {
    count += static_cast<std::size_t>(page.jobs_size());
    for (const wire::JobStatus& job : page.jobs()) newest.push_back(job);
    while (newest.size() > most_jobs_seen) newest.pop_front();
  });
  std::reverse(newest.begin(), newest.end());
  std::set<std::string> running;
  for (const wire::JobStatus& job : newest) {
    const bool is_asked_for = job.state() == "running" && running.size() < most_running_jobs;
    if (is_asked_for) running.insert(job.job());
    snapshot.jobs.push_back(
        {number_of_job(job.job()), is_asked_for ? running_line(source, job, now, snapshot)
                                                : with_share(job_json(job), share_of_job(job, 0))});
  }
  std::erase_if(rates_, [&](const auto& rate) { return !running.contains(rate.first); });
  return count;
}

FarmSnapshot FarmLook::look(FarmSource& source, const FarmSnapshot& before, const LookTime& now) {
  FarmSnapshot snapshot;
  const wire::StatusReply said = source.farm();
  Json farm = Json::parse(farm_json(said));
  farm["demand"] = demand_of(said);
  farm["jobs"] = add_jobs(source, now, snapshot);
  snapshot.farm = json_line(farm);
  add_workers(source, snapshot);
  const bool is_same_farm = before.endpoint == source.endpoint();
  add_events(source, is_same_farm ? before : FarmSnapshot(), snapshot);
  snapshot.has_seen = true;
  snapshot.at_rest = source.is_at_rest();
  snapshot.connected = !snapshot.at_rest;
  snapshot.endpoint = source.endpoint();
  snapshot.time_ms = now.wall_ms;
  return snapshot;
}

FarmSnapshot snapshot_without_answer(const FarmSnapshot& before, const std::string& trouble) {
  TF_CHECK(!trouble.empty());
  FarmSnapshot snapshot = before;
  snapshot.connected = false;
  snapshot.at_rest = false;
  snapshot.trouble = trouble;
  return snapshot;
}

std::int64_t rest_after_look_ms(std::int64_t took_ms) {
  return std::clamp(rest_in_looks * took_ms, shortest_rest_ms, longest_rest_ms);
}

}  // namespace tetfarm
