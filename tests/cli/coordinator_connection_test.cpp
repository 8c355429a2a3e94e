#include "cli/coordinator_connection.h"

#include <gmock/gmock.h>

#include "base/clock.h"
#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "tests/cli/fake_coordinator.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

using Answers = std::vector<wire::Envelope>;

wire::Envelope refusal(int code) {
  wire::Envelope envelope;
  envelope.mutable_refused()->set_reason("it is full");
  envelope.mutable_refused()->set_exit_code(code);
  return envelope;
}

TEST(CoordinatorConnection, puts_the_pages_of_a_status_together) {
  FakeCoordinator coordinator([](const wire::Envelope& said) {
    wire::Envelope answer;
    const std::uint64_t after = said.status_request().after();
    wire::StatusReply& reply = *answer.mutable_status_reply();
    reply.add_jobs()->set_job("job-" + std::to_string(after + 1));
    if (after == 0) reply.set_workers(4);
    reply.set_next(after < 2 ? after + 1 : 0);
    return Answers{answer};
  });
  CoordinatorConnection connection(coordinator.endpoint());
  const wire::StatusReply all = connection.status("", 5'000);
  ASSERT_EQ(all.jobs_size(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(all.jobs(i).job(), "job-" + std::to_string(i + 1));
  EXPECT_EQ(all.workers(), 4U);
  EXPECT_EQ(all.next(), 0U);
  connection.status("job-1", 5'000);
  EXPECT_EQ(coordinator.heard().back().status_request().job(), "job-1");
  EXPECT_FALSE(coordinator.heard().back().status_request().farm_only());
  connection.farm(5'000);
  EXPECT_TRUE(coordinator.heard().back().status_request().farm_only());
}

TEST(CoordinatorConnection, a_refusal_is_an_error_with_the_code_of_the_coordinator) {
  int code = 6;
  FakeCoordinator coordinator([&code](const wire::Envelope&) { return Answers{refusal(code)}; });
  CoordinatorConnection connection(coordinator.endpoint());
  const auto code_of = [&](int refused_with) {
    code = refused_with;
    try {
      connection.cancel("job-1", 5'000);
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "the coordinator refused: it is full");
      return static_cast<int>(error.code());
    }
    return 0;
  };
  EXPECT_EQ(code_of(6), 6);
  EXPECT_EQ(code_of(1), 1);
  EXPECT_EQ(code_of(255), 255);
  for (const int none : {0, -1, 256}) EXPECT_EQ(code_of(none), 1) << none;
}

TEST(CoordinatorConnection, passes_over_answers_to_other_questions) {
  FakeCoordinator coordinator([](const wire::Envelope&) {
    wire::Envelope other;
    other.mutable_submitted()->set_job("job-1");
    wire::Envelope answer;
    answer.mutable_cancelled()->set_found(true);
    return Answers{other, answer};
  });
  CoordinatorConnection connection(coordinator.endpoint());
  EXPECT_TRUE(connection.cancel("job-1", 5'000).found());
}

TEST(CoordinatorConnection, asks_again_when_an_answer_was_lost) {
  int asked = 0;
  FakeCoordinator coordinator([&asked](const wire::Envelope&) {
    wire::Envelope answer;
    answer.mutable_draining()->set_count(3);
    return ++asked == 1 ? Answers{} : Answers{answer};
  });
  CoordinatorConnection connection(coordinator.endpoint());
  EXPECT_EQ(connection.drain(7, 5'000).count(), 3U);
  ASSERT_THAT(coordinator.heard(), SizeIs(2));
  EXPECT_EQ(coordinator.heard()[1].drain_workers().worker(), 7U);
}

TEST(CoordinatorConnection, gives_up_on_a_silent_coordinator_when_the_time_is_over) {
  FakeCoordinator coordinator([](const wire::Envelope&) { return Answers{}; });
  CoordinatorConnection connection(coordinator.endpoint());
  const std::int64_t begin = steady_ms();
  try {
    connection.retry({}, 120);
    FAIL() << "somebody answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
    EXPECT_EQ(error.what(), coordinator.endpoint() + ": no coordinator answers");
  }
  EXPECT_GE(steady_ms() - begin, 110);
  EXPECT_LT(steady_ms() - begin, 1'000);
}

TEST(CoordinatorConnection, an_address_that_is_none_is_a_mistake_of_the_user) {
  try {
    CoordinatorConnection connection("nonsense");
    FAIL() << "connected to nonsense";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nonsense: is not an address such as tcp://HOST:PORT: "));
  }
}

/// Pieces that never come.
class NothingComes : public PieceExchange {
 public:
  bool is_complete() const override { return false; }
  std::vector<wire::Envelope> due(std::int64_t) override { return {}; }
  bool take(const wire::Envelope&, std::int64_t) override { return false; }
  void ask_again() override { ++asked_again; }
  int asked_again = 0;
};

TEST(CoordinatorConnection, an_exchange_connects_anew_before_it_gives_up) {
  FakeCoordinator coordinator([](const wire::Envelope&) { return Answers{}; });
  CoordinatorConnection connection(coordinator.endpoint());
  NothingComes files;
  int moved = 0;
  try {
    connection.exchange(files, 250, [&moved] { ++moved; });
    FAIL() << "something came";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
    EXPECT_EQ(error.what(), coordinator.endpoint() +
                                ": no coordinator answers; run the same command again to continue");
  }
  EXPECT_GE(files.asked_again, 1);
  EXPECT_EQ(moved, 0);
}

JobInput some_job() {
  JobInput input;
  input.job.name = "wing";
  input.job.surface = "wing.off";
  input.path = "in/wing.off";
  input.surface = "OFF";
  return input;
}

TEST(CoordinatorConnection, a_job_is_published_with_its_surface_or_named_with_its_path) {
  const TempFolder folder;
  const ArtifactStore store(folder.path() / "farm");
  const wire::Submit published = publish_job(store, some_job());
  EXPECT_EQ(published.name(), "wing");
  EXPECT_EQ(published.job_toml(), to_toml(some_job().job));
  EXPECT_EQ(published.key(), key_of(some_job()));
  ASSERT_EQ(published.inputs_size(), 1);
  EXPECT_EQ(store.read(published.inputs(0).hash(), published.inputs(0).size()), "OFF");
  const wire::Submit named = name_job(some_job());
  EXPECT_EQ(named.name(), "wing");
  EXPECT_EQ(named.job_toml(), to_toml(some_job().job));
  EXPECT_EQ(named.surface_path(), (std::filesystem::current_path() / "in/wing.off").string());
  EXPECT_EQ(named.key(), "");
  JobInput nameless = some_job();
  nameless.job.name = "a\nb";
  EXPECT_THROW(publish_job(store, nameless), UsageError);
  EXPECT_THROW(name_job(nameless), UsageError);
}

}  // namespace
}  // namespace tetfarm
