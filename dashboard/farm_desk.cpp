#include "dashboard/farm_desk.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/program_version.h"
#include "base/thread_without_signals.h"
#include "json/json_line.h"

namespace tetfarm {
namespace {

constexpr std::int64_t interest_ms = 10'000;   // how long who asked once is shown new figures
constexpr std::int64_t new_enough_ms = 2'500;  // beyond the rest between two looks
constexpr std::int64_t slow_look_ms = 15'000;  // what is older is not shown while a look goes on
constexpr std::int64_t farm_again_ms = 10'000;
constexpr std::int64_t longest_wait_ms = 15'000;
constexpr std::size_t most_questions = 256;
constexpr std::int64_t long_ago_ms = std::int64_t{1} << 40U;

LookTime look_time() { return {steady_ms(), wall_ms()}; }

ApiError silence(const std::string& trouble) {
  return {503, trouble.empty() ? "the coordinator does not answer" : trouble,
          "the dashboard goes on trying; see whether the coordinator runs"};
}

ApiError too_busy() { return {503, "too much is asked at once", "ask again in a moment"}; }

}  // namespace

std::optional<ApiAnswer> answer_from(const FarmSnapshot& snapshot, const ApiRequest& request) {
  if (request.subject == ApiSubject::farm) return answer_of(farm_body(snapshot));
  const bool is_in_snapshot = request.subject == ApiSubject::jobs ||
                              request.subject == ApiSubject::events ||
                              (request.subject == ApiSubject::workers && !request.with_gone);
  if (is_in_snapshot && !snapshot.has_seen) return answer_of(silence(snapshot.trouble));
  switch (request.subject) {
    case ApiSubject::jobs:
      return answer_of(jobs_body(snapshot));
    case ApiSubject::events:
      return answer_of(events_body(snapshot, request.last));
    case ApiSubject::workers:
      if (request.with_gone) return std::nullopt;
      return answer_of(workers_body(snapshot));
    case ApiSubject::job: {
      const auto running = snapshot.running_jobs.find(request.job);
      if (running == snapshot.running_jobs.end()) return std::nullopt;
      return answer_of(running->second);
    }
    default:
      return std::nullopt;
  }
}

FarmDesk::FarmDesk(std::unique_ptr<FarmSource> source, bool acts, Publishing publish)
    : source_(std::move(source)),
      acts_(acts),
      publish_(std::move(publish)),
      answers_(look_time),
      asked_ms_(steady_ms() - long_ago_ms),
      looked_ms_(asked_ms_),
      next_look_ms_(asked_ms_),
      told_farm_ms_(asked_ms_) {
  TF_CHECK(source_ != nullptr);
  thread_ = thread_without_signals([this] { run(); });
}

FarmDesk::~FarmDesk() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  source_->give_up();
  changed_.notify_all();
  thread_.join();
  for (const Question& question : questions_) question.done(answer_of(silence("it is ending")));
}

bool FarmDesk::is_look_new(std::int64_t now_ms) const {
  const std::int64_t age = now_ms - looked_ms_;
  if (is_looking_) return age < slow_look_ms;
  return age < new_enough_ms + std::max<std::int64_t>(0, next_look_ms_ - looked_ms_);
}

void FarmDesk::ask(const ApiRequest& request, const ApiAnswering& done) {
  std::optional<ApiAnswer> known;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::int64_t now = steady_ms();
    if (request.subject != ApiSubject::about) asked_ms_ = now;
    if (request.subject == ApiSubject::about) {
      known = answer_of(json_line({{"version", 1},
                                   {"program_version", program_version},
                                   {"acts", acts_},
                                   {"paths", api_paths()}}));
    } else if (is_look_new(now)) {
      known = answer_from(*snapshot_, request);
    }
    if (!known && questions_.size() >= most_questions) known = answer_of(too_busy());
    if (!known) questions_.push_back({request, done, now});
  }
  changed_.notify_all();
  if (known) done(std::move(*known));
}

void FarmDesk::note_watchers(std::size_t count) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    watchers_ = count;
    if (count > 0) asked_ms_ = steady_ms();
  }
  changed_.notify_all();
}

std::string FarmDesk::first_messages() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tetfarm::first_messages(*snapshot_);
}

bool FarmDesk::is_look_due(std::int64_t now_ms) const {
  const bool is_wanted = watchers_ > 0 || !questions_.empty() || now_ms - asked_ms_ < interest_ms;
  return is_wanted && now_ms >= next_look_ms_;
}

/// Whether there is any; false at the end.
bool FarmDesk::wait_for_work(std::unique_lock<std::mutex>& lock) {
  while (!is_over_) {
    const std::int64_t now = steady_ms();
    if (!questions_.empty() || is_look_due(now)) return true;
    const bool is_wanted = watchers_ > 0 || now - asked_ms_ < interest_ms;
    if (is_wanted) {
      changed_.wait_for(lock, std::chrono::milliseconds(next_look_ms_ - now));
    } else {
      changed_.wait(lock);
    }
  }
  return false;
}

void FarmDesk::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (wait_for_work(lock)) {
    if (is_look_due(steady_ms())) {
      is_looking_ = true;
      lock.unlock();
      take_a_look();
      lock.lock();
      is_looking_ = false;
    }
    const std::deque<Question> questions = std::exchange(questions_, {});
    lock.unlock();
    answer_all(questions);
    lock.lock();
  }
}

void FarmDesk::take_a_look() {
  const std::shared_ptr<const FarmSnapshot> before = snapshot_;  // only this thread changes it
  const std::int64_t begin = steady_ms();
  std::shared_ptr<const FarmSnapshot> now;
  std::int64_t rest = 0;
  try {
    now = std::make_shared<const FarmSnapshot>(look_.look(*source_, *before, look_time()));
    rest = rest_after_look_ms(steady_ms() - begin);
  } catch (const Error& error) {
    now = std::make_shared<const FarmSnapshot>(snapshot_without_answer(*before, error.what()));
    rest = rest_after_look_ms(0);
  }
  const std::int64_t end = steady_ms();
  const bool with_farm = end - told_farm_ms_ >= farm_again_ms;
  std::string messages = messages_of_changes(*before, *now, with_farm);
  if (messages.starts_with("event: farm")) told_farm_ms_ = end;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    snapshot_ = std::move(now);
    looked_ms_ = end;
    next_look_ms_ = end + rest;
  }
  if (!messages.empty()) publish_(std::move(messages));
}

ApiAnswer FarmDesk::answer(const ApiRequest& request) {
  if (std::optional<ApiAnswer> known = answer_from(*snapshot_, request)) return std::move(*known);
  if (!snapshot_->trouble.empty()) return answer_of(silence(snapshot_->trouble));
  try {
    return answers_.answer(request, *source_, look_);
  } catch (const NoAnswer& error) {
    return answer_of(silence(error.what()));
  }
}

void FarmDesk::answer_all(const std::deque<Question>& questions) {
  for (const Question& question : questions) {
    const bool is_late = steady_ms() - question.since_ms > longest_wait_ms;
    question.done(is_late ? answer_of(too_busy()) : answer(question.request));
  }
}

}  // namespace tetfarm
