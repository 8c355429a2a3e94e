// What a person sees: the commands that look, at a store at rest and at a coordinator, and HTTP.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>

#include "base/sanitizers.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using test::Ended;
using test::Program;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
  return lines;
}

/// A job of three sub-domains that is done, its store at rest.
class Views : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const std::string input = test::sphere_in_box(folder_->path(), 4, 1);
    const Ended ended = run_program(test::run_words(input, "out", 2, 3), folder_->path());
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static Ended look(std::vector<std::string> words) {
    words.insert(words.end(), {"--store", "out"});
    Ended ended = run_program(words, folder_->path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }
  static std::vector<json> look_json(std::vector<std::string> words) {
    words.emplace_back("--json");
    return lines_of(look(std::move(words)).out);
  }

  static std::unique_ptr<TemporaryFolder> folder_;
};

std::unique_ptr<TemporaryFolder> Views::folder_;

TEST_F(Views, of_a_store_at_rest_tell_jobs_tasks_workers_and_events) {
  EXPECT_THAT(look({"jobs"}).err, HasSubstr("no coordinator answers"));
  const std::vector<json> jobs = look_json({"jobs"});
  ASSERT_EQ(jobs.size(), 1U);
  EXPECT_EQ(jobs[0]["state"], "done");
  EXPECT_EQ(jobs[0]["tasks_ready"], 0);
  const std::vector<json> tasks = look_json({"tasks", "job-1"});
  EXPECT_EQ(tasks.size(), jobs[0]["tasks_done"]);
  EXPECT_EQ(look_json({"tasks", "--kind", "mesh"}).size(), 3U);
  EXPECT_TRUE(look_json({"tasks", "--state", "failed"}).empty());
  EXPECT_TRUE(look_json({"workers"}).empty()) << "nobody is here";
  EXPECT_GE(look_json({"workers", "--all"}).size(), 2U);
  EXPECT_EQ(look_json({"events", "-n", "3"}).size(), 3U);
  EXPECT_GT(look_json({"events", "job-1", "--all"}).size(), 2 * tasks.size());
  EXPECT_EQ(look_json({"status"}).size(), 2U);
  EXPECT_THAT(look({"tasks"}).out, HasSubstr("SUB-DOMAIN"));
}

TEST_F(Views, quality_measures_edges_by_the_spacing_of_the_run) {
  const Ended ended = run_program({"quality", "out", "--json"}, folder_->path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const json quality = lines_of(ended.out).at(0);
  const json& edges = quality["edge_over_spacing"];
  ASSERT_TRUE(edges.is_object());
  EXPECT_GT(edges["edges"], quality["elements"]);
  EXPECT_NEAR(edges["mean"], 1, 0.15);
  EXPECT_EQ(quality["time_step"], quality["smallest_height"]);
  EXPECT_EQ(quality["worst"].size(), 20U);
  EXPECT_EQ(quality["worst"][0]["at"], quality["worst_at"]);
  EXPECT_EQ(quality["subdomain_elements"].size(), 3U);
  const std::string mesh = (folder_->path() / "elsewhere.vtkhdf").string();
  std::filesystem::copy_file(quality["file"].get<std::string>().starts_with("/")
                                 ? std::filesystem::path(quality["file"].get<std::string>())
                                 : folder_->path() / quality["file"].get<std::string>(),
                             mesh);
  const Ended alone = run_program({"quality", mesh, "--json"}, folder_->path());
  EXPECT_TRUE(lines_of(alone.out).at(0)["edge_over_spacing"].is_null());
  const Ended with_run = run_program({"quality", mesh, "--run", "out", "--json"}, folder_->path());
  EXPECT_EQ(lines_of(with_run.out).at(0)["edge_over_spacing"], edges);
}

TEST_F(Views, a_report_says_the_same_of_the_mesh_whoever_made_it) {
  const std::string input = test::sphere_in_box(folder_->path(), 4, 1);
  ASSERT_EQ(run_program(test::run_words(input, "alone", 1, 3), folder_->path()).code, 0);
  std::vector<std::string> of_mesh;
  for (const char* run : {"out", "alone"}) {
    const Ended ended = run_program({"report", run, "-o", "page.html", "--json"}, folder_->path());
    ASSERT_EQ(ended.code, 0) << ended.err;
    const std::string page = test::contents(folder_->path() / "page.html");
    EXPECT_THAT(page, HasSubstr("Edge length over spacing"));
    EXPECT_THAT(page, HasSubstr("estimated before"));
    EXPECT_THAT(page, HasSubstr("The sub-domains, moved apart"));
    const std::size_t work = page.find("<section id=\"work\">");
    ASSERT_NE(work, std::string::npos);
    EXPECT_THAT(page.substr(work), HasSubstr("assemble"));
    of_mesh.push_back(page.substr(0, work));
  }
  EXPECT_EQ(of_mesh[0], of_mesh[1]);
  EXPECT_EQ(
      run_program({"report", "job-1", "--store", "out", "-o", "b.html"}, folder_->path()).code, 0);
  EXPECT_EQ(
      run_program({"report", "job-9", "--store", "out", "-o", "c.html"}, folder_->path()).code, 5);
  EXPECT_EQ(run_program({"report", "nowhere", "-o", "c.html"}, folder_->path()).code, 5);
}

TEST_F(Views, tasks_tell_what_was_expected_of_them) {
  for (const json& task : look_json({"tasks", "--kind", "mesh"})) {
    EXPECT_GT(task["expected_seconds"], 0);
    EXPECT_GT(task["expected_bytes"], 1 << 20);
    if (!is_sanitized) {
      EXPECT_GT(task["expected_bytes"], task["peak_rss_bytes"]);
    }
    EXPECT_GT(task["expected_elements"], 0);
    EXPECT_NEAR(task["elements"].get<double>() / task["expected_elements"].get<double>(), 1, 0.3);
  }
}

TEST_F(Views, explain_a_task_and_show_what_its_process_said) {
  const json mesh = look_json({"tasks", "--kind", "mesh"}).at(0);
  const std::string number = mesh["task"].dump();
  const json explained = look_json({"explain", number}).at(0);
  EXPECT_EQ(explained["kind"], "mesh");
  EXPECT_EQ(explained["subdomain"], "leaf");
  EXPECT_TRUE(explained["reasons"].empty());
  ASSERT_FALSE(explained["attempts"].empty());
  const json& attempt = explained["attempts"].back();
  EXPECT_EQ(attempt["state"], "done");
  EXPECT_GT(attempt["peak_rss_bytes"], 0);
  EXPECT_NE(attempt["host"], "");
  EXPECT_GE(attempt["ended_ms"], attempt["started_ms"]);
  EXPECT_THAT(look({"explain", number}).out, HasSubstr("in the tree"));
  EXPECT_THAT(look_json({"logs", number}).at(0)["log"], HasSubstr("done, "));
  EXPECT_GE(look_json({"logs", "job-1"}).size(), look_json({"tasks"}).size());
  EXPECT_EQ(run_program({"explain", "999", "--store", "out"}, folder_->path()).code, 5);
}

TEST_F(Views, trace_every_attempt) {
  look({"trace", "job-1", "-o", "trace.json"});
  const json trace = json::parse(test::contents(folder_->path() / "trace.json"));
  std::size_t slices = 0;
  for (const json& event : trace["traceEvents"]) slices += event["ph"] == "X" ? 1 : 0;
  EXPECT_GE(slices, look_json({"tasks"}).size());
}

TEST_F(Views, a_backup_brings_back_a_lost_database) {
  const std::filesystem::path store = folder_->path() / "out" / ".tetfarm";
  const auto run = [&](const std::vector<std::string>& words) {
    return run_program(words, folder_->path());
  };
  ASSERT_EQ(run({"backup", "out/.tetfarm", "-o", "copy"}).code, 0);
  for (const char* part : {"", "-wal", "-shm"}) {
    std::filesystem::remove(store / (std::string("tetfarm.db") + part));
  }
  EXPECT_EQ(run({"jobs", "--store", "out"}).code, 5);
  ASSERT_EQ(run({"restore", "copy", "out/.tetfarm"}).code, 0);
  EXPECT_EQ(look_json({"jobs"}).at(0)["state"], "done");
  EXPECT_EQ(run({"restore", "nothing", "out/.tetfarm"}).code, 5);
}

/// A running coordinator that shows itself.
class ShownFarm : public ::testing::Test {
 protected:
  ShownFarm() : coordinator_(words(), folder_.path()) {
    while (coordinator_.is_running() && said("status page on http://").empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  static std::vector<std::string> words() {
    return {"coordinator",       "--store", "store",      "--listen",
            "tcp://127.0.0.1:*", "--http",  "127.0.0.1:0"};
  }
  /// The rest of the line that begins so, "" while it is not there.
  std::string said(const std::string& begin) const {
    const std::string all = coordinator_.out_so_far();
    const std::size_t at = all.find(begin);
    const std::size_t end = all.find('\n', at);
    if (at == std::string::npos || end == std::string::npos) return {};
    return all.substr(at + begin.size(), end - at - begin.size());
  }
  int connect() const {
    const std::string address = said("status page on http://");
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.find(':') + 1))));
    ::inet_pton(AF_INET, "127.0.0.1", &where.sin_addr);
    EXPECT_EQ(::connect(fd, reinterpret_cast<sockaddr*>(&where), sizeof where), 0);
    return fd;
  }
  std::string get(const std::string& path) const {
    const int fd = connect();
    const std::string request = "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    ::send(fd, request.data(), request.size(), MSG_NOSIGNAL);
    std::string answer;
    char buffer[4096];
    for (ssize_t n = 0; (n = ::recv(fd, buffer, sizeof buffer, 0)) > 0;) {
      answer.append(buffer, static_cast<std::size_t>(n));
    }
    ::close(fd);
    return answer;
  }

  TemporaryFolder folder_;
  Program coordinator_;
};

TEST_F(ShownFarm, has_a_page_figures_and_health) {
  EXPECT_THAT(get("/healthz"), HasSubstr("\r\n\r\nok\n"));
  EXPECT_THAT(get("/readyz"), HasSubstr("\r\n\r\nready\n"));
  EXPECT_THAT(get("/metrics"), HasSubstr("\ntetfarm_workers{state=\"idle\"} 0\n"));
  EXPECT_THAT(get("/"), HasSubstr("<h2>Jobs</h2>"));
  EXPECT_THAT(get("/../etc/passwd"), HasSubstr("404"));
}

TEST_F(ShownFarm, has_health_while_slow_clients_take_every_place_again_and_again) {
  std::vector<int> slow;
  const std::string begin = "GET / HTTP/1.1\r\nX-Slow: ";
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < 20; ++i) {
      slow.push_back(connect());
      ::send(slow.back(), begin.data(), begin.size(), MSG_NOSIGNAL);
    }
    EXPECT_THAT(get("/healthz"), HasSubstr("\r\n\r\nok\n")) << round;
    EXPECT_THAT(get("/readyz"), HasSubstr("\r\n\r\nready\n")) << round;
  }
  for (const int fd : slow) ::close(fd);
}

TEST_F(ShownFarm, says_that_its_database_was_removed_and_takes_no_job_until_it_is_back) {
  const std::string input = test::sphere_in_box(folder_.path(), 4, 1);
  const std::string endpoint = said("listening on ");
  const auto ask = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--connect", endpoint});
    return run_program(words, folder_.path());
  };
  const std::filesystem::path database = folder_.path() / "store/tetfarm.db";
  const std::filesystem::path elsewhere = folder_.path() / "elsewhere";
  const std::string reason = database.filename().string() + ": the database was removed";
  ASSERT_EQ(ask({"submit", input, "--store", "store"}).code, 0);
  std::filesystem::rename(database, elsewhere);
  const Ended refused = ask({"submit", input, "--size", "0.5", "--store", "store"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr(reason));
  for (const char* command : {"jobs", "status"}) {
    const Ended shown = ask({command});
    EXPECT_EQ(shown.code, 0) << shown.err;
    EXPECT_THAT(shown.out, HasSubstr(reason)) << command;
    EXPECT_THAT(shown.out, HasSubstr("stuck")) << command;
  }
  EXPECT_THAT(get("/readyz"), HasSubstr("503"));
  std::filesystem::rename(elsewhere, database);
  while (get("/readyz").find("200 OK") == std::string::npos) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_THAT(ask({"submit", input, "--size", "0.5", "--store", "store"}).out, HasSubstr("job-2"));
}

TEST_F(ShownFarm, says_why_a_task_waits_and_escapes_what_strangers_wrote) {
  const std::string input = test::sphere_in_box(folder_.path(), 4, 1);
  std::filesystem::rename(folder_.path() / input, folder_.path() / "a <b> & c.off");
  const std::string endpoint = said("listening on ");
  const auto ask = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--connect", endpoint});
    return run_program(words, folder_.path());
  };
  const Ended submitted = ask({"submit", "a <b> & c.off", "--store", "store"});
  ASSERT_EQ(submitted.code, 0) << submitted.err;
  EXPECT_THAT(ask({"explain", "1"}).out, HasSubstr("why: no worker is connected"));
  EXPECT_THAT(run_program({"explain", "1", "--store", "store"}, folder_.path()).err,
              ::testing::IsEmpty())
      << "the store names its coordinator, which answers";
  const std::string page = get("/");
  EXPECT_THAT(page, HasSubstr("a &lt;b&gt; &amp; c"));
  EXPECT_EQ(page.find("<b> &"), std::string::npos);
  EXPECT_THAT(get("/metrics"), HasSubstr("tetfarm_queue_tasks 1\n"));
}

}  // namespace
}  // namespace tetfarm
