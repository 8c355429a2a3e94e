#include "coordinator/views/status_page.h"

#include <gmock/gmock.h>

#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/views/farm_in_rows.h"

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

/// The page without its head, which is the same always.
class ShownFarm : public FarmInRows {
 protected:
  std::string shown() const {
    const JobHistory history = database_.history();
    const std::string page = status_page(context(history));
    const std::string title = "<h1>Tetfarm</h1>\n";
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>\n"));
    const std::size_t at = page.find(title);
    return at == page.npos ? page : page.substr(at + title.size());
  }
};

TEST_F(ShownFarm, has_its_jobs_the_tree_of_the_one_that_runs_its_workers_and_all_attempts) {
  const std::string svg_end = "</svg>\n";
  const auto box = [](const std::string& look, const std::string& place, const char* title) {
    return "<rect class=\"" + look + "\" " + place + "><title>" + title + "</title></rect>\n";
  };
  const std::string jobs =
      "<h2>Jobs</h2><table><tr><th>job<th>name<th>state<th>stage<th>tasks done<th>running"
      "<th>ready<th>quarantine<th>tets<th>seconds<th></tr>\n"
      "<tr><td>job-1</td><td>wing &lt;1&gt;</td><td>running</td><td>mesh</td><td>4</td><td>1</td>"
      "<td>1</td><td>0</td><td>120</td><td>9.0</td><td></td></tr>\n"
      "<tr><td>job-2</td><td>duct</td><td>failed</td><td>inspect</td><td>0</td><td>0</td>"
      "<td>0</td><td>1</td><td>0</td><td>3.5</td><td>the surface is open</td></tr>\n"
      "</table>\n";
  const std::string tree =
      "<h2>Tree of job-1</h2>\n<svg width=\"1000.0\" height=\"42.0\">\n" +
      box("cut", R"(x="0.0" y="0.0" width="999.0" height="12.0")", "sub-domain root: cut") +
      box("meshed", R"(x="0.0" y="14.0" width="499.0" height="12.0")", "sub-domain L: 120 tets") +
      box("cut", R"(x="500.0" y="14.0" width="499.0" height="12.0")", "sub-domain R: cut") +
      box("leaf", R"(x="500.0" y="28.0" width="249.0" height="12.0")", "sub-domain RL: leaf") +
      box("leaf", R"(x="750.0" y="28.0" width="249.0" height="12.0")", "sub-domain RR: leaf") +
      svg_end;
  const std::string workers =
      "<h2>Workers</h2><table><tr><th>worker<th>host<th>state<th>task<th>doing<th>done"
      "<th>failed attempts<th>busy seconds</tr>\n"
      "<tr><td>worker-4</td><td>gamma</td><td>busy</td><td>5</td><td>points pass 2: 30 of 60</td>"
      "<td>0</td><td>0</td><td>0.0</td></tr>\n"
      "<tr><td>worker-5</td><td>beta</td><td>idle</td><td></td><td></td>"
      "<td>0</td><td>0</td><td>0.0</td></tr>\n"
      "<tr><td>worker-6</td><td>delta</td><td>idle</td><td></td><td></td>"
      "<td>0</td><td>0</td><td>0.0</td></tr>\n"
      "<tr><td>worker-7</td><td>eps</td><td>drains</td><td></td><td></td>"
      "<td>0</td><td>0</td><td>0.0</td></tr>\n"
      "</table>\n";
  const std::string attempts =
      "<h2>The last 9.0 s</h2>\n<svg width=\"1000.0\" height=\"42.0\">\n" +
      box("inspect", R"(x="0.0" y="0.0" width="166.7" height="12.0")",
          "inspect, task 1 on alpha: done ") +
      box("bad", R"(x="177.8" y="0.0" width="33.3" height="12.0")",
          "decompose root, task 2 on alpha: crashed signal 11") +
      box("decompose", R"(x="333.3" y="14.0" width="55.6" height="12.0")",
          "decompose root, task 2 on beta: done ") +
      box("mesh", R"(x="400.0" y="14.0" width="194.4" height="12.0")",
          "mesh L, task 3 on beta: done ") +
      box("decompose", R"(x="400.0" y="0.0" width="44.4" height="12.0")",
          "decompose R, task 4 on alpha: done ") +
      box("bad", R"(x="444.4" y="0.0" width="88.9" height="12.0")",
          "mesh L, task 3 on alpha: revoked another attempt was faster") +
      box("mesh running", R"(x="666.7" y="28.0" width="333.3" height="12.0")",
          "mesh RL, task 5 on gamma: running ") +
      box("bad", R"(x="211.1" y="0.0" width="1.0" height="12.0")",
          "inspect, task 7 on alpha: failed ") +
      svg_end;
  state_->note_work(WorkerId{4}, TaskId{5}, AttemptId{7}, {WorkStage::points, 2, 30, 60});
  EXPECT_EQ(shown(), jobs + tree + workers + attempts +
                         "<p>For programs: <code>/metrics</code>, <code>/healthz</code>, "
                         "<code>/readyz</code></p></body></html>\n");
}

TEST_F(ShownFarm, says_first_that_there_is_no_room) {
  state_->out_of_resources("quota of <all>", now_);
  EXPECT_THAT(
      shown(),
      testing::StartsWith("<p><b>No tasks are handed out: quota of &lt;all&gt;</b></p>\n<h2>Jobs"));
}

TEST_F(ShownFarm, has_the_tree_of_the_newest_job_when_none_runs) {
  state_->cancel(JobId{1}, now_);
  ChangeSet changes = state_->take_changes();
  SubdomainRow root;
  root.job = JobId{2};
  root.state = SubdomainState::open;
  root.hash = hash_of('9');
  changes.subdomains = {root};
  database_.apply(changes);
  EXPECT_THAT(shown(), testing::HasSubstr("<h2>Tree of job-2</h2>\n"));
  EXPECT_THAT(shown(), testing::HasSubstr("sub-domain root: open"));
}

TEST_F(ShownFarm, has_a_part_of_a_large_tree_and_says_so) {
  ChangeSet changes;
  for (std::uint64_t path = 1; path <= 1030; ++path) {
    SubdomainRow row;
    row.job = JobId{1};
    row.path = path;
    row.hash = hash_of('9');
    changes.subdomains.push_back(row);
  }
  database_.apply(changes);
  const std::string page = shown();
  EXPECT_THAT(page, testing::HasSubstr("<p>the first 1023 of 1030 sub-domains</p>\n"));
  EXPECT_EQ(count_of(page, "<title>sub-domain "), 1023U);
  EXPECT_THAT(page, testing::HasSubstr("<svg width=\"1000.0\" height=\"140.0\">\n"))
      << "of ten levels";
}

TEST_F(ShownFarm, says_when_there_are_more_jobs_and_workers_than_are_shown) {
  EXPECT_EQ(count_of(shown(), "<p>… and more</p>"), 0U);
  for (int i = 0; i < 1000; ++i) {
    WorkerInfo info;
    info.nonce = std::to_string(i);
    state_->add_worker(info, {}, {}, now_);
  }
  database_.apply(state_->take_changes());
  EXPECT_EQ(count_of(shown(), "</table>\n<p>… and more</p>\n<h2>The last"), 1U);
}

TEST(StatusPage, is_short_where_nothing_is) {
  const TempFolder folder;
  const JobDatabase database(folder.path() / "db");
  const JobState state({}, {}, [](const ArtifactRef&) { return true; }, {});
  const JobHistory history = database.history();
  const std::string page = status_page({state, history, {}});
  EXPECT_EQ(count_of(page, "<svg"), 0U) << "neither tree nor attempts";
  EXPECT_EQ(count_of(page, "<h2>"), 2U);
}

TEST(InHtml, replaces_what_means_something_there) {
  EXPECT_EQ(in_html("a<b>&\"c\" 'd'"), "a&lt;b&gt;&amp;&quot;c&quot; 'd'");
}

}  // namespace
}  // namespace tetfarm
