#include "dashboard/farm_desk.h"

#include <gmock/gmock.h>

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <nlohmann/json.hpp>

#include "tests/dashboard/fake_farm.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// What a desk published.
class Heard {
 public:
  void note(const std::string& messages) {
    const std::lock_guard<std::mutex> lock(mutex_);
    all_ += messages;
    changed_.notify_all();
  }
  bool comes(const std::string& text) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(20),
                             [&] { return all_.find(text) != std::string::npos; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string all_;
};

struct DeskOfAFarm {
  explicit DeskOfAFarm(std::unique_ptr<FakeFarm> farm)
      : source(*farm),
        desk(std::move(farm), true, [this](const std::string& messages) { heard.note(messages); }) {
  }

  ApiAnswer ask(ApiSubject subject, const std::string& job = "") {
    ApiRequest request;
    request.subject = subject;
    request.job = job;
    auto answer = std::make_shared<std::promise<ApiAnswer>>();
    desk.ask(request, [answer](const ApiAnswer& given) { answer->set_value(given); });
    return answer->get_future().get();
  }

  FakeFarm& source;
  Heard heard;
  FarmDesk desk;
};

std::unique_ptr<FakeFarm> farm_with_a_job() {
  auto farm = std::make_unique<FakeFarm>();
  farm->add_job(1, "done");
  return farm;
}

TEST(FarmDesk, answers_the_first_who_asks_after_a_look_and_the_next_without_one) {
  DeskOfAFarm desk(farm_with_a_job());
  EXPECT_THAT(*desk.ask(ApiSubject::jobs).body, HasSubstr("job-1"));
  for (int i = 0; i < 50; ++i) EXPECT_EQ(desk.ask(ApiSubject::farm).status, 200);
  EXPECT_LE(desk.source.times("farm"), 2);
}

TEST(FarmDesk, does_not_look_when_nobody_asks) {
  DeskOfAFarm desk(farm_with_a_job());
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(desk.source.was_asked());
}

TEST(FarmDesk, tells_watchers_of_what_it_sees) {
  DeskOfAFarm desk(farm_with_a_job());
  EXPECT_EQ(desk.desk.first_messages(), "");
  desk.desk.note_watchers(1);
  EXPECT_TRUE(desk.heard.comes("event: farm"));
  EXPECT_TRUE(desk.heard.comes("job-1"));
  EXPECT_THAT(desk.desk.first_messages(), HasSubstr("job-1"));
}

TEST(FarmDesk, says_that_nobody_answers_and_shows_what_it_saw_last) {
  DeskOfAFarm desk(farm_with_a_job());
  EXPECT_EQ(desk.ask(ApiSubject::jobs).status, 200);
  desk.desk.note_watchers(1);
  desk.source.is_silent = true;
  EXPECT_TRUE(desk.heard.comes(R"("connected":false,"trouble":"no coordinator answers")"));
  EXPECT_THAT(*desk.ask(ApiSubject::jobs).body, HasSubstr("job-1"));
  const ApiAnswer job = desk.ask(ApiSubject::job, "job-1");
  EXPECT_EQ(job.status, 503);
  EXPECT_THAT(*job.body, HasSubstr("no coordinator answers"));
  desk.source.is_silent = false;
  EXPECT_TRUE(desk.heard.comes(R"("connected":true)"));
}

TEST(FarmDesk, without_any_answer_has_no_jobs_to_show) {
  auto farm = std::make_unique<FakeFarm>();
  farm->is_silent = true;
  DeskOfAFarm desk(std::move(farm));
  EXPECT_EQ(desk.ask(ApiSubject::jobs).status, 503);
  EXPECT_EQ(desk.ask(ApiSubject::farm).status, 200);
}

TEST(FarmDesk, tells_what_it_is_without_asking_anybody) {
  DeskOfAFarm desk(farm_with_a_job());
  const auto about = nlohmann::json::parse(*desk.ask(ApiSubject::about).body);
  EXPECT_EQ(about["version"], 1);
  EXPECT_EQ(about["acts"], true);
  EXPECT_FALSE(desk.source.was_asked());
}

}  // namespace
}  // namespace tetfarm
