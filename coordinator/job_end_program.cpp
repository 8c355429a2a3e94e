#include "coordinator/job_end_program.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "base/check.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/printable_text.h"
#include "base/thread_without_signals.h"
#include "base/utf8.h"
#include "coordinator/limited_program.h"

namespace tetfarm {
namespace {

constexpr std::size_t longest_told_message = 2000;

/// Of the coordinator's own environment what any program may want.
std::vector<std::string> own_environment() {
  std::vector<std::string> variables;
  for (const char* name : {"PATH", "HOME", "LANG", "TZ"}) {
    const char* value = std::getenv(name);
    if (value != nullptr) variables.push_back(std::string(name) + "=" + value);
  }
  if (std::getenv("PATH") == nullptr) variables.emplace_back("PATH=/usr/local/bin:/usr/bin:/bin");
  return variables;
}

}  // namespace

std::filesystem::path checked_job_end_program(const std::filesystem::path& program) {
  const std::filesystem::path path = std::filesystem::absolute(program).lexically_normal();
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) {
    throw UsageError("--on-job-end: " + std::string(std::strerror(errno)), path.string());
  }
  if (!S_ISREG(about.st_mode) || ::access(path.c_str(), X_OK) != 0) {
    throw UsageError("--on-job-end: is no program that may be executed (chmod +x)", path.string());
  }
  if ((about.st_mode & S_IWOTH) != 0) {
    throw UsageError("--on-job-end: everybody may write to this program (chmod o-w)",
                     path.string());
  }
  return path;
}

std::vector<std::string> environment_of_end(const JobRow& job, const JobEndOptions& options) {
  TF_CHECK(is_end(job.phase));
  const std::string message(cut_utf8(printable(job.message), longest_told_message));
  const std::int64_t took_ms = std::max<std::int64_t>(0, job.finished_ms - job.created_ms);
  return {"TETFARM_JOB=" + job_name(job.id),
          "TETFARM_JOB_NAME=" + printable(job.name),
          "TETFARM_JOB_STATE=" + std::string(name_of(job.phase)),
          "TETFARM_JOB_EXIT_CODE=" + std::to_string(job.exit_code),
          "TETFARM_JOB_MESSAGE=" + message,
          "TETFARM_JOB_SECONDS=" + std::to_string(took_ms / 1000),
          "TETFARM_STORE=" + options.store.string(),
          "TETFARM_COORDINATOR=" + options.endpoint};
}

JobEndProgram::JobEndProgram(JobEndOptions options) : options_(std::move(options)) {
  TF_CHECK(options_.tries > 0 && options_.program.is_absolute());
  thread_ = thread_without_signals([this] { run(); });
}

JobEndProgram::~JobEndProgram() {
  stop_ = true;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  has_work_.notify_one();
  thread_.join();
}

void JobEndProgram::give(const JobRow& job) {
  const Key key{job.id, job.finished_ms};
  {
    const std::lock_guard lock(mutex_);
    if (!known_.insert(key).second) return;
    orders_.push_back({key, environment_of_end(job, options_), 0, 0});
  }
  has_work_.notify_one();
}

std::vector<ToldEnd> JobEndProgram::take_told() {
  const std::lock_guard lock(mutex_);
  for (const ToldEnd& told : told_) known_.erase({told.job, told.finished_ms});
  return std::exchange(told_, {});
}

std::vector<std::string> JobEndProgram::take_troubles() {
  const std::lock_guard lock(mutex_);
  return std::exchange(troubles_, {});
}

/// The one that is due first. @pre there are orders.
JobEndProgram::Order* JobEndProgram::next_order() {
  return &*std::min_element(orders_.begin(), orders_.end(), [](const Order& a, const Order& b) {
    return a.not_before_ms < b.not_before_ms;
  });
}

void JobEndProgram::run() {
  std::unique_lock lock(mutex_);
  while (!is_over_) {
    if (orders_.empty()) {
      has_work_.wait(lock);
      continue;
    }
    Order* const next = next_order();
    const std::int64_t wait_ms = next->not_before_ms - steady_ms();
    if (wait_ms > 0) {
      has_work_.wait_for(lock, std::chrono::milliseconds(wait_ms));
      continue;
    }
    std::swap(*next, orders_.front());
    Order order = std::move(orders_.front());
    orders_.pop_front();
    lock.unlock();
    std::vector<std::string> environment = own_environment();
    environment.insert(environment.end(), order.environment.begin(), order.environment.end());
    const std::string trouble = run_limited(
        {options_.program, std::move(environment), options_.limit_ms, options_.grace_ms}, stop_);
    lock.lock();
    if (!is_over_) note(std::move(order), trouble);
  }
}

/// @pre the lock is held.
void JobEndProgram::note(Order order, const std::string& trouble) {
  ++order.tries;
  const auto& [job, finished_ms] = order.key;
  if (trouble.empty()) {
    told_.push_back({job, finished_ms, {}});
    return;
  }
  const std::string what = options_.program.string() + " for " + job_name(job) + " " + trouble;
  if (order.tries >= options_.tries) {
    told_.push_back(
        {job, finished_ms, what + "; given up after " + std::to_string(order.tries) + " tries"});
    return;
  }
  troubles_.push_back(what + "; it is tried again");
  order.not_before_ms = steady_ms() + options_.again_ms;
  orders_.push_back(std::move(order));
}

}  // namespace tetfarm
