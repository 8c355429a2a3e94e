#include "cli/farm_view.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/file_system.h"
#include "coordinator/server.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A store with three jobs, and a coordinator that knows another.
class ViewOfAFarm : public ::testing::Test {
 protected:
  ViewOfAFarm() {
    ChangeSet changes;
    for (std::uint64_t id = 1; id <= 3; ++id) {
      JobRow job;
      job.id = JobId{id};
      job.key = std::to_string(id);
      job.phase = JobPhase::done;
      changes.jobs.push_back(job);
    }
    JobDatabase(store_.folder() / "tetfarm.db").apply(changes);
  }
  ViewOptions of_store() const {
    ViewOptions options;
    options.store = store_.folder().string();
    options.client.timeout_s = 0.05;
    return options;
  }
  void write_endpoints(const std::string& text) const {
    write_file_atomically(endpoints_file(store_.folder()), text);
  }
  static std::vector<std::string> jobs_of(FarmView& view, std::uint32_t limit = 0) {
    std::vector<std::string> jobs;
    wire::Query query;
    query.set_subject(wire::Query::JOBS);
    query.set_limit(limit);
    view.ask(query, [&](const wire::QueryReply& page) {
      for (const wire::JobStatus& job : page.jobs()) jobs.push_back(job.job());
    });
    return jobs;
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path() / "farm"};
  int refuses_with_ = 0;
  FakeCoordinator coordinator_{[this](const wire::Envelope& said) {
    wire::Envelope answer;
    if (refuses_with_ != 0) {
      answer.mutable_refused()->set_reason("no");
      answer.mutable_refused()->set_exit_code(refuses_with_);
    } else if (said.has_query()) {
      answer.mutable_query_reply()->add_jobs()->set_job("job-77");
    } else {
      answer.mutable_status_reply()->add_jobs()->set_job(said.status_request().job());
    }
    return std::vector<wire::Envelope>{answer};
  }};
};

TEST_F(ViewOfAFarm, is_of_the_coordinator_that_is_named) {
  ViewOptions options = of_store();
  options.client.endpoint = coordinator_.endpoint();
  options.client.timeout_s = 5;
  options.client.job = "job-5";
  FarmView view(options);
  EXPECT_FALSE(view.is_at_rest());
  EXPECT_THAT(jobs_of(view), ElementsAre("job-77"));
  EXPECT_EQ(view.status().jobs(0).job(), "job-5");
}

TEST_F(ViewOfAFarm, is_of_nobody_else_when_that_one_is_silent) {
  ViewOptions options = of_store();
  options.client.endpoint = "ipc://" + (folder_.path() / "nobody").string();
  FarmView view(options);
  try {
    view.status();
    FAIL() << "somebody answered";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::not_found);
  }
}

TEST_F(ViewOfAFarm, is_of_the_coordinator_that_the_store_names_first) {
  write_endpoints(coordinator_.endpoint() + "\nipc:///nobody\n");
  ViewOptions options = of_store();
  options.client.timeout_s = 5;
  const Said said = said_by([&] {
    FarmView view(options);
    EXPECT_FALSE(view.is_at_rest());
    EXPECT_THAT(jobs_of(view), ElementsAre("job-77"));
    return ExitCode::ok;
  });
  EXPECT_EQ(said.err, "");
}

TEST_F(ViewOfAFarm, is_of_the_rows_where_no_coordinator_answers_and_says_so) {
  for (const bool has_stale_endpoint : {false, true}) {
    if (has_stale_endpoint) write_endpoints("ipc://" + (folder_.path() / "dead").string() + "\n");
    const Said said = said_by([&] {
      FarmView view(of_store());
      EXPECT_TRUE(view.is_at_rest());
      EXPECT_THAT(jobs_of(view), ElementsAre("job-1", "job-2", "job-3"));
      EXPECT_THAT(jobs_of(view, 1), ElementsAre("job-1", "job-2", "job-3")) << "page by page";
      EXPECT_EQ(view.status().jobs_size(), 3);
      return ExitCode::ok;
    });
    EXPECT_EQ(said.err, "note: no coordinator answers; this is what " + store_.folder().string() +
                            " recorded\n");
  }
  ViewOptions quiet = of_store();
  quiet.is_quiet = true;
  quiet.client.job = "job-2";
  const Said said = said_by([&] {
    EXPECT_EQ(FarmView(quiet).status().jobs(0).job(), "job-2");
    return ExitCode::ok;
  });
  EXPECT_EQ(said.err, "");
}

TEST_F(ViewOfAFarm, a_coordinator_of_the_store_that_refuses_is_not_passed_over) {
  write_endpoints(coordinator_.endpoint() + "\n");
  refuses_with_ = 1;
  ViewOptions options = of_store();
  options.client.timeout_s = 5;
  EXPECT_EQ(said_by([&] {
              FarmView view(options);
              return ExitCode::ok;
            }).error,
            "the coordinator refused: no");
}

TEST_F(ViewOfAFarm, needs_a_coordinator_or_a_store) {
  const Said nowhere = said_by([] {
    FarmView view(ViewOptions{});
    return ExitCode::ok;
  });
  EXPECT_EQ(nowhere.code, ExitCode::usage);
  EXPECT_EQ(nowhere.error,
            "give a coordinator (--connect, or $TETFARM_COORDINATOR) or a store (--store)");
  ViewOptions options;
  options.store = folder_.path().string();
  EXPECT_EQ(said_by([&] {
              FarmView view(options);
              return ExitCode::ok;
            }).error,
            folder_.path().string() + ": not a store or the output folder of a run");
}

TEST_F(ViewOfAFarm, reads_rows_where_the_database_is) {
  const std::filesystem::path elsewhere = folder_.path() / "database";
  make_folders(elsewhere);
  std::filesystem::rename(store_.folder() / "tetfarm.db", elsewhere / "tetfarm.db");
  ViewOptions options = of_store();
  options.is_quiet = true;
  EXPECT_THROW(FarmView{options}, Error);
  options.database = elsewhere.string();
  FarmView view(options);
  EXPECT_THAT(jobs_of(view), ElementsAre("job-1", "job-2", "job-3"));
}

}  // namespace
}  // namespace tetfarm
