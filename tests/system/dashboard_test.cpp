// `tetfarm dashboard` before a coordinator and a worker of its own.
#include <filesystem>
#include <fstream>
#include <memory>

#include "tests/support/served_dashboard.h"
#include "tests/system/daemon_farm.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class DashboardOfADaemon : public test::Daemon {
 protected:
  test::ServedDashboard& serve(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"--connect", endpoint_};
    words.insert(words.end(), more.begin(), more.end());
    dashboard_ = std::make_unique<test::ServedDashboard>(words, folder_.path());
    return *dashboard_;
  }
  std::string small_input() const { return test::sphere_in_box(folder_.path(), 4, 1); }

  std::unique_ptr<test::ServedDashboard> dashboard_;
};

TEST_F(DashboardOfADaemon, shows_a_job_from_its_submission_to_its_mesh) {
  const test::ServedDashboard& dashboard = serve();
  EXPECT_EQ(dashboard.get("/api/v1/jobs").body, R"({"jobs":[]})");
  const std::string job = submit(small_input(), 2);
  const auto worker = start_worker();
  ASSERT_EQ(wait_for(job).code, 0);
  EXPECT_TRUE(dashboard.comes_true("/api/v1/jobs/" + job,
                                   [](const json& seen) { return seen["state"] == "done"; }));
  EXPECT_TRUE(dashboard.comes_true("/api/v1/jobs", [&](const json& seen) {
    return seen["jobs"].size() == 1 && seen["jobs"][0]["job"] == job &&
           seen["jobs"][0]["share"] == 1.0;
  }));
  const json tasks = dashboard.get("/api/v1/jobs/" + job + "/tasks?columns=task,kind,state").json();
  ASSERT_GT(tasks["rows"].size(), 4U);
  EXPECT_EQ(tasks["rows"][0][1], "inspect");
  EXPECT_EQ(tasks["next"], 0);
  const json attempts = dashboard.get("/api/v1/jobs/" + job + "/attempts?limit=2").json();
  EXPECT_EQ(attempts["rows"].size(), 2U);
  EXPECT_NE(attempts["next"], 0);
  EXPECT_FALSE(dashboard.get("/api/v1/jobs/" + job + "/events").json()["events"].empty());
  EXPECT_FALSE(dashboard.get("/api/v1/events?last=5").json()["events"].empty());
  EXPECT_EQ(dashboard.get("/api/v1/tasks/1").json()["kind"], "inspect");
  EXPECT_TRUE(dashboard.get("/api/v1/tasks/1/logs").json()["attempts"][0].contains("log"));
  EXPECT_EQ(dashboard.get("/api/v1/workers").json()["workers"][0]["worker"], "worker-1");
  EXPECT_EQ(dashboard.get("/api/v1/workers?gone=1").json()["workers"].size(), 1U);
  const json farm = dashboard.get("/api/v1/farm").json();
  EXPECT_EQ(farm["connected"], true);
  EXPECT_EQ(farm["endpoint"], endpoint_);
  EXPECT_EQ(farm["jobs"], 1);
}

TEST_F(DashboardOfADaemon, tells_what_it_is_and_shows_a_page_at_every_place) {
  const test::ServedDashboard& dashboard = serve();
  const json about = dashboard.get("/api/v1").json();
  EXPECT_EQ(about["version"], 1);
  EXPECT_EQ(about["acts"], false);
  EXPECT_THAT(about["paths"], ::testing::Contains("GET /api/v1/changes"));
  for (const char* place : {"/", "/jobs/job-7", "/workers", "/events"}) {
    const test::WebReply page = dashboard.get(place);
    EXPECT_EQ(page.status, 200) << place;
    EXPECT_THAT(page.head, HasSubstr("Content-Type: text/html"));
    EXPECT_THAT(page.head, HasSubstr("default-src 'none'; script-src 'self'"));
  }
}

TEST_F(DashboardOfADaemon, answers_what_is_not_there_with_what_is_wrong_and_what_to_do) {
  const test::ServedDashboard& dashboard = serve();
  for (const auto& [target, status] :
       {std::pair{"/api/v1/jobs/job-77", 404}, std::pair{"/api/v1/jobs/job-77/tasks", 404},
        std::pair{"/api/v1/tasks/9999", 404}, std::pair{"/api/v1/tasks/9999/logs", 404},
        std::pair{"/api/v2", 404}, std::pair{"/api/v1/events?last=0", 400},
        std::pair{"/nothing.js", 404}}) {
    const test::WebReply reply = dashboard.get(target);
    EXPECT_EQ(reply.status, status) << target;
    EXPECT_TRUE(reply.json().contains("error") && reply.json().contains("help")) << target;
  }
}

TEST_F(DashboardOfADaemon, tells_watchers_of_a_job_that_is_submitted) {
  const test::ServedDashboard& dashboard = serve();
  const test::RawConnection watcher(dashboard.port());
  watcher.send("GET /api/v1/changes HTTP/1.1\r\nHost: localhost\r\n\r\n");
  std::string heard = watcher.hear(2'500);
  EXPECT_THAT(heard, HasSubstr("Content-Type: text/event-stream"));
  EXPECT_THAT(heard, HasSubstr("event: farm\ndata: {"));
  EXPECT_THAT(heard, HasSubstr("event: jobs\ndata: {\"jobs\":[]}"));
  submit(small_input());
  for (int i = 0; i < 10 && heard.find("event: events") == std::string::npos; ++i) {
    heard += watcher.hear(1'000);
  }
  EXPECT_THAT(heard, HasSubstr("\"job\":\"job-1\""));
  EXPECT_THAT(heard, HasSubstr("event: events\ndata: {\"events\":[{"));
}

TEST_F(DashboardOfADaemon, acts_only_where_it_may_and_only_for_its_own_page) {
  const std::string job = submit(small_input());
  const std::string cancel = "/api/v1/jobs/" + job + "/cancel";
  EXPECT_EQ(serve().act(cancel).status, 403) << "without --acts";
  const test::ServedDashboard& dashboard = serve({"--acts"});
  EXPECT_EQ(dashboard.ask("POST", cancel).status, 403) << "without the field";
  EXPECT_EQ(dashboard.act(cancel, "Origin: http://evil.example\r\n").status, 403);
  EXPECT_EQ(dashboard.act(cancel, "Host: evil.example\r\n").status, 403);
  EXPECT_EQ(dashboard.get(cancel).status, 405);
  EXPECT_EQ(dashboard.get("/api/v1/jobs/" + job).json()["state"], "running");
  EXPECT_EQ(dashboard.act("/api/v1/jobs/" + job + "/priority?priority=-7").body,
            R"({"set":true,"priority":-7,"state":"running"})");
  EXPECT_TRUE(dashboard.comes_true("/api/v1/jobs/" + job,
                                   [](const json& seen) { return seen["priority"] == -7; }));
  EXPECT_EQ(dashboard.act(cancel, "Origin: http://localhost\r\n").body, R"({"found":true})");
  EXPECT_EQ(dashboard.act("/api/v1/jobs/job-77/cancel").body, R"({"found":false})");
  EXPECT_TRUE(dashboard.comes_true("/api/v1/jobs/" + job,
                                   [](const json& seen) { return seen["state"] == "cancelled"; }));
  EXPECT_EQ(dashboard.act("/api/v1/tasks/1/retry").body, R"({"count":0})") << "not in quarantine";
  EXPECT_EQ(dashboard.act("/api/v1/workers/9/drain").body, R"({"count":0})");
  EXPECT_EQ(dashboard.act("/api/v1/hosts/nowhere/retry").body, R"({"count":0})");
  EXPECT_EQ(dashboard.act("/api/v1/jobs/" + job + "/priority?priority=1").body,
            R"({"set":false,"priority":1,"state":"cancelled"})");
  EXPECT_EQ(dashboard.act("/api/v1/jobs/job-77/priority?priority=1").status, 404);
}

TEST_F(DashboardOfADaemon, drains_a_worker) {
  const test::ServedDashboard& dashboard = serve({"--acts"});
  const auto worker = start_worker();
  EXPECT_TRUE(dashboard.comes_true("/api/v1/workers",
                                   [](const json& seen) { return seen["workers"].size() == 1; }));
  EXPECT_EQ(dashboard.act("/api/v1/workers/worker-1/drain").body, R"({"count":1})");
  EXPECT_EQ(worker->wait(30).code, 0);
}

TEST_F(DashboardOfADaemon, outlives_its_coordinator_and_shows_what_it_saw_last) {
  const test::ServedDashboard& dashboard = serve();
  submit(small_input());
  EXPECT_TRUE(dashboard.comes_true("/api/v1/jobs",
                                   [](const json& seen) { return seen["jobs"].size() == 1; }));
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  EXPECT_TRUE(dashboard.comes_true("/api/v1/farm",
                                   [](const json& seen) { return seen["connected"] == false; }));
  EXPECT_THAT(dashboard.get("/api/v1/farm").json()["trouble"].get<std::string>(),
              HasSubstr("no coordinator answers"));
  EXPECT_THAT(dashboard.get("/api/v1/jobs").body, HasSubstr("job-1"));
  EXPECT_EQ(dashboard.get("/api/v1/tasks/1").status, 503);
  coordinator_ = start_coordinator(endpoint_);
  EXPECT_TRUE(dashboard.comes_true("/api/v1/farm",
                                   [](const json& seen) { return seen["connected"] == true; }));
  EXPECT_EQ(dashboard.get("/api/v1/tasks/1").status, 200);
}

TEST_F(DashboardOfADaemon,
       of_a_store_shows_its_rows_when_the_coordinator_is_gone_and_finds_the_next) {
  submit(small_input());
  const test::ServedDashboard dashboard({"--store", "store"}, folder_.path());
  EXPECT_EQ(dashboard.get("/api/v1/farm").json()["connected"], true);
  coordinator_->signal(SIGTERM);
  coordinator_->wait();
  EXPECT_TRUE(dashboard.comes_true("/api/v1/farm",
                                   [](const json& seen) { return seen["at_rest"] == true; }));
  EXPECT_THAT(dashboard.get("/api/v1/jobs/job-1").body, HasSubstr("stopped"));
  EXPECT_EQ(dashboard.get("/api/v1/tasks/1").json()["kind"], "inspect");
  coordinator_ = start_coordinator("tcp://127.0.0.1:*");
  EXPECT_TRUE(dashboard.comes_true("/api/v1/farm",
                                   [](const json& seen) { return seen["connected"] == true; }));
}

TEST_F(DashboardOfADaemon, gives_the_surfaces_of_subdomains_where_it_sees_the_store) {
  const std::string job = submit(small_input(), 2);
  const auto worker = start_worker();
  ASSERT_EQ(wait_for(job).code, 0);
  const std::string surfaces = "/api/v1/jobs/" + job + "/surfaces";
  const test::ServedDashboard seeing({"--connect", endpoint_, "--store", "store"}, folder_.path());
  const json told = seeing.get(surfaces).json();
  EXPECT_EQ(told["sees_files"], true);
  ASSERT_GE(told["surfaces"].size(), 2U);
  for (const json& line : told["surfaces"]) {
    EXPECT_EQ(line["is_there"], true);
    const std::string path = surfaces + "/" + std::to_string(line["path"].get<int>());
    const test::WebReply whole = seeing.get(path);
    EXPECT_EQ(whole.status, 200);
    EXPECT_THAT(whole.head, HasSubstr("Content-Type: application/octet-stream"));
    EXPECT_TRUE(whole.body.starts_with("TFSHOWN\n"));
    const test::WebReply few = seeing.get(path + "?triangles=64");
    EXPECT_EQ(few.status, 200);
    EXPECT_LT(few.body.size(), 48U + 52 * 64);
  }
  const std::string hash = told["surfaces"][0]["hash"];
  const std::string first = surfaces + "/" + std::to_string(told["surfaces"][0]["path"].get<int>());
  const auto file = folder_.path() / "store/artifacts" / hash.substr(0, 2) / hash;
  const auto size = std::filesystem::file_size(file);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  std::ofstream(file) << std::string(size, 'x');
  EXPECT_EQ(seeing.get(first).status, 200) << "it was made before";
  EXPECT_EQ(seeing.get(first + "?triangles=128").status, 502) << "the file is damaged";
  std::filesystem::remove(file);
  EXPECT_EQ(seeing.get(first + "?triangles=128").status, 404);
  EXPECT_EQ(seeing.get(surfaces + "/1").status, 404) << "the root was cut";
}

TEST_F(DashboardOfADaemon, has_no_surfaces_where_it_does_not_see_the_store) {
  const std::string job = submit(small_input(), 2);
  const auto worker = start_worker();
  ASSERT_EQ(wait_for(job).code, 0);
  const test::ServedDashboard& blind = serve();
  const std::string surfaces = "/api/v1/jobs/" + job + "/surfaces";
  const json told = blind.get(surfaces).json();
  EXPECT_EQ(told["sees_files"], false);
  ASSERT_GE(told["surfaces"].size(), 2U);
  EXPECT_EQ(told["surfaces"][0]["is_there"], false);
  const test::WebReply refused =
      blind.get(surfaces + "/" + std::to_string(told["surfaces"][0]["path"].get<int>()));
  EXPECT_EQ(refused.status, 404);
  EXPECT_THAT(refused.json()["error"].get<std::string>(), HasSubstr("--store"));
}

TEST_F(DashboardOfADaemon, ends_with_success_when_it_is_told_to) {
  for (const int signal : {SIGINT, SIGTERM}) {
    test::ServedDashboard& dashboard = serve();
    const test::RawConnection watcher(dashboard.port());
    watcher.send("GET /api/v1/changes HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_THAT(watcher.hear(300), HasSubstr("200 OK"));
    dashboard.program().signal(signal);
    const test::Ended ended = dashboard.program().wait(10);
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
  }
}

TEST_F(DashboardOfADaemon, ends_at_once_also_while_nobody_answers) {
  test::ServedDashboard& dashboard = serve({"--timeout", "60"});
  coordinator_->signal(SIGKILL);
  coordinator_->wait();
  const test::RawConnection asking(dashboard.port());
  asking.send("GET /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\n\r\n");
  pause_ms(200);
  dashboard.program().signal(SIGTERM);
  EXPECT_EQ(dashboard.program().wait(10).code, 0);
}

TEST(Dashboard, is_refused_where_other_hosts_can_reach_it_without_a_token) {
  const test::TemporaryFolder folder;
  const test::Ended ended = test::run_program(
      {"dashboard", "--connect", "tcp://127.0.0.1:1", "--http", "0.0.0.0:0"}, folder.path());
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("--http-token"));
}

TEST(Dashboard, of_nothing_is_a_wrong_command_line_and_of_no_store_not_found) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run_program({"dashboard"}, folder.path()).code, 2);
  EXPECT_EQ(test::run_program({"dashboard", "--store", "nothing"}, folder.path()).code, 5);
}

}  // namespace
}  // namespace tetfarm
