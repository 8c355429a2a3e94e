#include "dashboard/fetched_answers.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "base/check.h"
#include "base/error.h"
#include "json/json_line.h"
#include "json/query_json.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_rows_of_table = 1'000'000;

wire::Query query_about(wire::Query::Subject subject, const ApiRequest& request) {
  wire::Query query;
  query.set_subject(subject);
  query.set_job(request.job);
  return query;
}

template <class Take>
void each_page(FarmSource& source, wire::Query query, const Take& take) {
  while (true) {
    const wire::QueryReply page = source.page(query);
    take(page);
    if (page.next() == 0) return;
    query.set_after(page.next());
  }
}

std::string events_of_job(const ApiRequest& request, FarmSource& source) {
  wire::Query query = query_about(wire::Query::EVENTS, request);
  query.set_newest(true);
  query.set_limit(request.last);
  const wire::QueryReply page = source.page(query);
  JsonList list("events");
  for (const wire::EventLine& event : page.events()) list.add(event_json(event));
  return list.take();
}

std::string explanation_of(const ApiRequest& request, FarmSource& source) {
  wire::Query query = query_about(wire::Query::EXPLAIN, request);
  query.set_task(request.number);
  return explanation_json(source.page(query).explanation());
}

std::string logs_of(const ApiRequest& request, FarmSource& source) {
  wire::Query query = query_about(wire::Query::LOGS, request);
  query.set_task(request.number);
  JsonList list("attempts");
  each_page(source, query, [&](const wire::QueryReply& page) {
    for (const wire::AttemptLine& attempt : page.attempts()) list.add(attempt_json(attempt, true));
  });
  return list.take();
}

std::string all_workers(const ApiRequest& request, FarmSource& source) {
  wire::Query query = query_about(wire::Query::WORKERS, request);
  query.set_with_gone(true);
  JsonList list("workers");
  each_page(source, query, [&](const wire::QueryReply& page) {
    for (const wire::WorkerLine& worker : page.workers()) list.add(worker_json(worker));
  });
  return list.take();
}

RowTable rows_of(const ApiRequest& request, FarmSource& source) {
  const bool is_tasks = request.subject == ApiSubject::tasks;
  RowTable table;
  each_page(source, query_about(is_tasks ? wire::Query::TASKS : wire::Query::ATTEMPTS, request),
            [&](const wire::QueryReply& page) {
              for (const wire::TaskLine& task : page.tasks()) table.add(task.task(), task);
              for (const wire::AttemptLine& attempt : page.attempts()) {
                table.add(attempt.attempt(), attempt);
              }
              if (table.size() > most_rows_of_table) {
                throw Error(ExitCode::out_of_resources,
                            request.job + " has more rows than this can hold");
              }
            });
  return table;
}

/// @throws Error (not_found).
std::string priority_json(const ApiRequest& request, FarmSource& source) {
  const std::string state = source.set_priority(request.job, request.priority);
  if (state.empty()) throw Error(ExitCode::not_found, "no job " + request.job);
  const bool counts = state == "running" || state == "waiting";
  return json_line({{"set", counts}, {"priority", request.priority}, {"state", state}});
}

std::string count_json(std::uint64_t count) { return json_line({{"count", count}}); }

/// What a request does that changes something.
std::string done_by(const ApiRequest& request, FarmSource& source) {
  TF_CHECK(is_act(request.subject));
  wire::Retry retry;
  retry.set_job(request.job);
  retry.set_host(request.host);
  switch (request.subject) {
    case ApiSubject::cancel_job:
      return json_line({{"found", source.cancel(request.job)}});
    case ApiSubject::set_priority:
      return priority_json(request, source);
    case ApiSubject::drain_worker:
      return count_json(source.drain(request.number));
    case ApiSubject::retry_task: {
      wire::Query query = query_about(wire::Query::EXPLAIN, request);
      query.set_task(request.number);
      retry.set_job(source.page(query).explanation().task().job());
      retry.set_task(request.number);
      return count_json(source.retry(retry));
    }
    default:
      return count_json(source.retry(retry));
  }
}

/// What the farm refused, in words of HTTP.
ApiError error_of(const Error& error, ApiSubject subject) {
  const bool is_of_surface = subject == ApiSubject::surface || subject == ApiSubject::surfaces;
  const bool is_of_map = subject == ApiSubject::map;
  switch (error.code()) {
    case ExitCode::not_found:
      return {404, error.what(),
              is_of_surface ? "GET /api/v1/jobs/JOB/surfaces lists what can be drawn"
              : is_of_map   ? "GET /api/v1/jobs/JOB/maps lists what can be drawn"
                            : "GET /api/v1/jobs lists the jobs that are there"};
    case ExitCode::usage:
      return {400, error.what(), "docs/api.md says what may be asked"};
    case ExitCode::out_of_resources:
      return {503, error.what(),
              is_of_surface ? "look at the mesh itself: tetfarm render"
              : is_of_map   ? "open the file itself with ParaView"
                            : "use the command line: tetfarm tasks --json"};
    default:
      return is_act(subject) ? ApiError{403, error.what(),
                                        "give the dashboard a key whose role may do this (--key)"}
                             : ApiError{502, error.what(), "the log of the coordinator says more"};
  }
}

}  // namespace

std::string name_of_request(const ApiRequest& request) {
  std::string name = std::to_string(static_cast<int>(request.subject)) + " " + request.job + " " +
                     std::to_string(request.number) + " " + std::to_string(request.last) + " " +
                     std::to_string(request.after) + " " + std::to_string(request.limit);
  for (const std::string& column : request.columns) name += " " + column;
  return name;
}

KeptThings<RowTable>::Kept FetchedAnswers::table(const ApiRequest& request, FarmSource& source) {
  const std::string name =
      (request.subject == ApiSubject::tasks ? "tasks " : "attempts ") + request.job;
  const std::int64_t begin_ms = clock_().steady_ms;
  if (const auto* kept = tables_.find(name, begin_ms)) return *kept;
  auto table = std::make_shared<const RowTable>(rows_of(request, source));
  const std::int64_t end_ms = clock_().steady_ms;
  KeptThings<RowTable>::Kept kept{name, {end_ms, end_ms - begin_ms}, table->size(), table};
  tables_.keep(kept);
  return kept;
}

ApiAnswer FetchedAnswers::page(const ApiRequest& request, FarmSource& source) {
  const KeptThings<RowTable>::Kept rows = table(request, source);
  const RowKind kind = request.subject == ApiSubject::tasks ? RowKind::task : RowKind::attempt;
  std::variant<std::string, ApiError> made = table_page(*rows.thing, kind, request);
  if (const auto* wrong = std::get_if<ApiError>(&made)) return answer_of(*wrong);
  ApiAnswer answer = answer_of(std::get<std::string>(std::move(made)));
  answers_.keep({name_of_request(request), rows.fetched, answer.body->size(), answer.body});
  return answer;
}

std::string FetchedAnswers::fetched(const ApiRequest& request, FarmSource& source, FarmLook& look) {
  switch (request.subject) {
    case ApiSubject::job: {
      const wire::StatusReply reply = source.job(request.job);
      if (reply.jobs_size() != 1) throw Error(ExitCode::not_found, "no job " + request.job);
      return look.job_body(reply, clock_());
    }
    case ApiSubject::task:
      return explanation_of(request, source);
    case ApiSubject::task_logs:
      return logs_of(request, source);
    case ApiSubject::workers:
      return all_workers(request, source);
    case ApiSubject::surfaces:
      return surfaces_.list(request.job, source);
    case ApiSubject::maps:
      return maps_.list(request.job, source);
    default:
      TF_CHECK(request.subject == ApiSubject::job_events || request.subject == ApiSubject::events);
      return events_of_job(request, source);
  }
}

ApiAnswer FetchedAnswers::answer(const ApiRequest& request, FarmSource& source, FarmLook& look) {
  const std::string name = name_of_request(request);
  const std::int64_t begin_ms = clock_().steady_ms;
  const bool acts = is_act(request.subject);
  if (!acts) {
    if (const auto* kept = answers_.find(name, begin_ms)) return {200, kept->thing, ApiForm::json};
  }
  try {
    if (acts) return answer_of(done_by(request, source));
    if (request.subject == ApiSubject::surface) return surfaces_.surface(request, source);
    if (request.subject == ApiSubject::map) return maps_.map(request, source);
    if (request.subject == ApiSubject::tasks || request.subject == ApiSubject::attempts) {
      return page(request, source);
    }
    ApiAnswer answer = answer_of(fetched(request, source, look));
    const std::int64_t end_ms = clock_().steady_ms;
    answers_.keep({name, {end_ms, end_ms - begin_ms}, answer.body->size(), answer.body});
    return answer;
  } catch (const NoAnswer&) {
    throw;
  } catch (const Error& error) {
    return answer_of(error_of(error, request.subject));
  }
}

}  // namespace tetfarm
