#include "dashboard/api_request.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

ApiRequest asked(const std::string& target, const std::string& method = "GET") {
  const std::variant<ApiRequest, ApiError> parsed = parse_api_request(method, target);
  const auto* wrong = std::get_if<ApiError>(&parsed);
  EXPECT_EQ(wrong, nullptr) << target << ": " << (wrong == nullptr ? "" : wrong->error);
  return wrong == nullptr ? std::get<ApiRequest>(parsed) : ApiRequest();
}

int refusal(const std::string& target, const std::string& method = "GET") {
  const std::variant<ApiRequest, ApiError> parsed = parse_api_request(method, target);
  const auto* wrong = std::get_if<ApiError>(&parsed);
  if (wrong == nullptr) return 200;
  EXPECT_FALSE(wrong->error.empty() || wrong->help.empty()) << target;
  return wrong->status;
}

TEST(ApiRequest, names_the_job_task_or_worker_of_its_path) {
  EXPECT_EQ(asked("/api/v1").subject, ApiSubject::about);
  EXPECT_EQ(asked("/api/v1/jobs/job-7").job, "job-7");
  EXPECT_EQ(asked("/api/v1/jobs/job-7/tasks").subject, ApiSubject::tasks);
  EXPECT_EQ(asked("/api/v1/tasks/31/logs").number, 31U);
  EXPECT_EQ(asked("/api/v1/jobs/job-7/surfaces").subject, ApiSubject::surfaces);
  EXPECT_EQ(asked("/api/v1/jobs/job-7/surfaces/12").number, 12U);
  EXPECT_EQ(asked("/api/v1/jobs/job-7/surfaces/12").job, "job-7");
  EXPECT_EQ(asked("/api/v1/jobs/job-7/maps").subject, ApiSubject::maps);
  EXPECT_EQ(asked("/api/v1/jobs/job-7/maps/2?triangles=64").number, 2U);
  EXPECT_EQ(asked("/api/v1/workers/worker-3/drain", "POST").number, 3U);
  EXPECT_EQ(asked("/api/v1/workers/3/drain", "POST").subject, ApiSubject::drain_worker);
}

TEST(ApiRequest, names_a_host_by_any_text) {
  EXPECT_EQ(asked("/api/v1/hosts/node-7.farm/retry", "POST").host, "node-7.farm");
  EXPECT_EQ(asked("/api/v1/hosts/a%2Fb%20c/retry", "POST").host, "a/b c");
  EXPECT_EQ(refusal("/api/v1/hosts//retry", "POST"), 404);
  EXPECT_EQ(refusal("/api/v1/hosts/" + std::string(256, 'x') + "/retry", "POST"), 404);
  EXPECT_EQ(refusal("/api/v1/hosts/a/b/retry", "POST"), 404);
}

TEST(ApiRequest, reads_the_parameters_of_a_table) {
  const ApiRequest request =
      asked("/api/v1/jobs/job-1/tasks?columns=task,kind%2Cstate&after=40&limit=10");
  EXPECT_THAT(request.columns, ElementsAre("task", "kind", "state"));
  EXPECT_EQ(request.after, 40U);
  EXPECT_EQ(request.limit, 10U);
  EXPECT_EQ(asked("/api/v1/jobs/job-1/tasks").limit, most_rows);
  EXPECT_EQ(asked("/api/v1/events?last=3").last, 3U);
  EXPECT_TRUE(asked("/api/v1/workers?gone=1").with_gone);
  EXPECT_FALSE(asked("/api/v1/workers?gone=0").with_gone);
}

TEST(ApiRequest, asks_for_triangles_by_powers_of_two_so_that_answers_serve_many) {
  const std::string surface = "/api/v1/jobs/job-1/surfaces/5";
  EXPECT_EQ(asked(surface).triangles, 16'384U);
  EXPECT_EQ(asked(surface + "?triangles=1").triangles, 1U);
  EXPECT_EQ(asked(surface + "?triangles=2047").triangles, 1'024U);
  EXPECT_EQ(asked(surface + "?triangles=131072").triangles, most_shown_triangles);
}

TEST(ApiRequest, a_priority_is_a_whole_number_that_has_to_be_said) {
  const std::string priority = "/api/v1/jobs/job-1/priority";
  EXPECT_EQ(asked(priority + "?priority=10", "POST").priority, 10);
  EXPECT_EQ(asked(priority + "?priority=-1000", "POST").priority, -highest_priority);
  for (const char* wrong : {"", "?", "?priority=", "?priority=-", "?priority=1001",
                            "?priority=-1001", "?priority=--1", "?priority=1.5", "?last=1"}) {
    EXPECT_EQ(refusal(priority + wrong, "POST"), 400) << wrong;
  }
  EXPECT_EQ(refusal("/api/v1/jobs/job-1/cancel?priority=1", "POST"), 400);
}

TEST(ApiRequest, is_refused_where_a_parameter_is_unknown_or_out_of_bounds) {
  for (const char* target :
       {"/api/v1/events?last=0", "/api/v1/events?last=1001", "/api/v1/events?last=x",
        "/api/v1/events?last=", "/api/v1/events?columns=task", "/api/v1/jobs?after=1",
        "/api/v1/jobs/job-1/tasks?limit=20001", "/api/v1/jobs/job-1/tasks?after=-1",
        "/api/v1/jobs/job-1/surfaces/5?triangles=0",
        "/api/v1/jobs/job-1/surfaces/5?triangles=131073", "/api/v1/jobs/job-1/surfaces?triangles=5",
        "/api/v1/workers?gone=yes", "/api/v1/farm?x=1", "/api/v1/farm?&"}) {
    EXPECT_EQ(refusal(target), 400) << target;
  }
  EXPECT_EQ(refusal("/api/v1/jobs/job-1/tasks?columns=" + std::string(200, ',')), 400);
}

TEST(ApiRequest, of_a_path_that_is_none_is_not_found) {
  for (const char* target : {"/api",
                             "/api/",
                             "/api/v2",
                             "/api/v1/",
                             "/api/v1/jobs/",
                             "/api/v1/jobs/7",
                             "/api/v1/jobs/job-",
                             "/api/v1/jobs/job-1x",
                             "/api/v1/jobs/job-1/",
                             "/api/v1/tasks/0",
                             "/api/v1/jobs/job-1/surfaces/0",
                             "/api/v1/jobs/job-1/surfaces/LR",
                             "/api/v1/jobs/job-1/surfaces/../5",
                             "/api/v1/jobs/job-1/surfaces/5/",
                             "/api/v1/jobs/job-1/surfaces/%2e%2e",
                             "/api/v1/tasks/-1",
                             "/api/v1/tasks/99999999999999999999",
                             "/api/v1/jobs/../farm",
                             "/api/v1/jobs/job-1%2ftasks",
                             "/api//v1/farm"}) {
    EXPECT_EQ(refusal(target), 404) << target;
  }
}

TEST(ApiRequest, of_another_method_is_told_so) {
  EXPECT_EQ(refusal("/api/v1/farm", "POST"), 405);
  EXPECT_EQ(refusal("/api/v1/jobs/job-1/cancel", "GET"), 405);
  EXPECT_EQ(asked("/api/v1/farm", "HEAD").subject, ApiSubject::farm);
}

TEST(ApiRequest, acts_only_with_post) {
  for (const std::string& path : api_paths()) {
    std::string target = path.substr(path.find(' ') + 1);
    if (target.ends_with("/priority")) target += "?priority=1";
    for (const auto& [word, name] :
         {std::pair{"JOB", "job-1"}, std::pair{"TASK", "1"}, std::pair{"WORKER", "1"},
          std::pair{"SUBDOMAIN", "1"}, std::pair{"MAP", "1"}, std::pair{"HOST", "node"}}) {
      const std::size_t at = target.find(word);
      if (at != std::string::npos) target.replace(at, std::string(word).size(), name);
    }
    const std::string method = path.substr(0, path.find(' '));
    EXPECT_EQ(is_act(asked(target, method).subject), method == "POST") << path;
  }
}

TEST(ApiRequest, paths_are_those_below_api) {
  EXPECT_TRUE(is_api_path("/api/v1/farm") && is_api_path("/api?x") && is_api_path("/api"));
  EXPECT_FALSE(is_api_path("/") || is_api_path("/apis") || is_api_path("/jobs/api/"));
}

}  // namespace
}  // namespace tetfarm
