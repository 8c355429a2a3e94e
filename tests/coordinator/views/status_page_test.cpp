#include "coordinator/views/status_page.h"

#include <gmock/gmock.h>

#include "store/job_database.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

std::size_t count_of(const std::string& text, const std::string& wanted) {
  std::size_t count = 0;
  for (auto at = text.find(wanted); at != text.npos; at = text.find(wanted, at + 1)) ++count;
  return count;
}

TEST(StatusPage, draws_the_newest_attempts_though_they_are_more_than_a_page_of_answers) {
  constexpr std::uint64_t attempts = 1700;
  constexpr std::uint64_t drawn = 1500;
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  ChangeSet changes;
  changes.jobs = {{JobId{1}, "key", "wing", "toml", JobPhase::running, 0, "", 5, 0}};
  TaskRow task;
  task.id = TaskId{1};
  task.job = JobId{1};
  changes.tasks = {task};
  WorkerRow worker;
  worker.id = WorkerId{1};
  worker.host = "host";
  changes.workers = {worker};
  for (std::uint64_t i = 1; i <= attempts; ++i) {
    AttemptRow attempt;
    attempt.id = AttemptId{i};
    attempt.task = TaskId{1};
    attempt.worker = WorkerId{1};
    attempt.state = AttemptState::lost;
    attempt.started_ms = static_cast<std::int64_t>(10 * i);
    attempt.ended_ms = attempt.started_ms + 5;
    attempt.message = "attempt " + std::to_string(i) + ".";
    changes.attempts.push_back(attempt);
  }
  database.apply(changes);
  const Moment now{20'000, 20'000};
  const JobState state(
      database.load(), {}, [](const ArtifactRef&) { return true; }, now);
  const JobHistory history = database.history();
  const std::string page = status_page({state, history, now});
  EXPECT_EQ(count_of(page, ", task 1 on host: lost attempt "), drawn);
  EXPECT_THAT(page, testing::HasSubstr("lost attempt 1700."));
  EXPECT_THAT(page, testing::Not(testing::HasSubstr("lost attempt 200.")));
}

}  // namespace
}  // namespace tetfarm
