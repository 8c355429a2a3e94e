// What is said of results that cannot be used, and of hosts that are left out: whole sentences.
#include <gmock/gmock.h>

#include "coordinator/decisions/host_crashes.h"
#include "coordinator/decisions/task_graph.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

TaskRow task_with(TaskKind kind, const std::vector<std::string>& inputs) {
  TaskRow task;
  task.kind = kind;
  for (const std::string& name : inputs) task.inputs.push_back(fake_file(name, name));
  return task;
}

TaskResult result_with(const std::vector<std::string>& outputs,
                       const std::map<std::string, double>& numbers,
                       const std::map<std::string, std::string>& texts) {
  TaskResult result;
  for (const std::string& name : outputs) result.outputs.push_back(fake_file(name, name));
  result.numbers = numbers;
  result.texts = texts;
  return result;
}

TEST(ProblemWith, a_result_names_what_is_missing_or_makes_no_sense) {
  const TaskRow inspect = task_with(TaskKind::inspect, {"job"});
  const std::map<std::string, double> numbers = {{"parts", 1},      {"total_work", 0},
                                                 {"groups", 0},     {"needles", 0},
                                                 {"most_bytes", 0}, {"across_cuts", 0}};
  const std::vector<std::string> files = {"surface", "spacing", "root", "settings"};
  EXPECT_EQ(problem_with(inspect, result_with(files, numbers, {})), std::nullopt);
  EXPECT_EQ(problem_with(inspect, result_with({"surface", "spacing", "settings"}, numbers, {})),
            "the output 'root' is missing");
  auto none = numbers;
  none["parts"] = 0;
  EXPECT_EQ(problem_with(inspect, result_with(files, none, {})), "the number of parts is 0");
  none.erase("parts");
  EXPECT_EQ(problem_with(inspect, result_with(files, none, {})), "the number 'parts' is missing");
  EXPECT_EQ(problem_with(task_with(TaskKind::decompose, {}), result_with({"left"}, {}, {})),
            "the output 'right' is missing");
  EXPECT_EQ(problem_with(task_with(TaskKind::write, {}), result_with({"portion"}, {}, {})),
            "the output 'tets' is missing");
  EXPECT_EQ(problem_with(task_with(TaskKind::assemble, {}), result_with({}, {}, {})), std::nullopt);
}

TEST(ProblemWith, an_order_has_every_leaf_of_the_tree_and_no_other) {
  const TaskRow order = task_with(TaskKind::order, {"subdomain:4", "subdomain:5"});
  const auto problem = [&order](const char* text) {
    return problem_with(order, result_with({"shared:4", "shared:5"}, {}, {{"order", text}}));
  };
  EXPECT_EQ(problem("4 0 5\n5 1 4\n"), std::nullopt);
  EXPECT_EQ(problem("4 x\n"), "the order is missing or makes no sense");
  EXPECT_EQ(problem("4 0\n"), "the order has different leaves from the tree");
  EXPECT_EQ(problem("4 0\n7 0\n"), "the order has a leaf that the tree does not have");
  EXPECT_EQ(problem_with(order, result_with({"shared:4"}, {}, {{"order", "4 0\n5 0\n"}})),
            "the output 'shared:5' is missing");
}

TEST(ProblemWith, groups_have_every_leaf_once_and_files_of_their_own) {
  TaskRow task = task_with(TaskKind::assimilate, {"job", "subdomain:4", "subdomain:5"});
  task.parameters["table"] = "4 1\n5 1\n";
  const auto problem = [&task](const char* groups, const std::vector<std::string>& files) {
    return problem_with(task, result_with(files, {}, {{"groups", groups}}));
  };
  const std::vector<std::string> both = {"dropped", "group:4", "group:5"};
  EXPECT_EQ(problem("4 4\n5 4\n", both), std::nullopt);
  EXPECT_EQ(problem("4 4\n5 x\n", both), "the groups cannot be read");
  EXPECT_EQ(problem("4 4\n4 4\n", both), "the groups cannot be read");
  EXPECT_EQ(problem("4 4\n", both), "the leaf 5 is in no group");
  EXPECT_EQ(problem("4 5\n5 4\n", both), "the group 5 is not named by a leaf of its own");
  EXPECT_EQ(problem("4 4\n5 5\n", {"dropped", "group:4"}), "the group 5 has no file");
  EXPECT_EQ(problem("4 4\n5 4\n6 4\n", both), "there are groups of unknown leaves");
  EXPECT_EQ(problem("4 4\n5 4\n", {"group:4"}), "the output 'dropped' is missing");
}

TEST(ProofAgainst, a_host_counts_tasks_and_jobs_and_has_the_last_words) {
  HostCrashes crashes;
  const auto at_hand = [](TaskId) { return true; };
  for (std::uint64_t i = 1; i <= 3; ++i) {
    TaskRow task;
    task.id = TaskId{i};
    task.job = JobId{i < 3 ? 1U : 2U};
    crashes.note_crash("bad", task, "signal " + std::to_string(i), at_hand);
    EXPECT_EQ(crashes.note_done("good", task.id), "bad");
  }
  EXPECT_FALSE(crashes.proof_against("bad", 4));
  EXPECT_FALSE(crashes.proof_against("good", 1));
  const auto proof = crashes.proof_against("bad", 3);
  ASSERT_TRUE(proof);
  EXPECT_EQ(proof->reason,
            "3 tasks of 2 jobs failed there and were done elsewhere; last failure: signal 3");
}

class OutlookWords : public JobStateTest {
 protected:
  std::vector<std::string> reasons(std::uint64_t id = 1) const {
    return state_->outlook(TaskId{id}, now_).reasons;
  }
};

TEST_F(OutlookWords, say_what_keeps_a_task_from_each_worker) {
  submit();
  commit();
  EXPECT_THAT(reasons(), ElementsAre("no worker is connected"));
  worker_ = new_worker();
  commit();
  EXPECT_THAT(reasons(), ElementsAre("a worker may take it at any moment"));
  const SendAssign assign = next(worker_);
  EXPECT_THAT(reasons(), testing::IsEmpty()) << "it runs";
  TaskFailure failure;
  failure.cause = FailureCause::error;
  failure.message = "signal 11";
  fail(worker_, assign, failure);
  EXPECT_THAT(reasons(),
              ElementsAre("after 1 error it waits another 1 s; last failure: signal 11"));
  failure.cause = FailureCause::killed;
  wait(60'000);
  fail(worker_, next(worker_), failure);
  EXPECT_THAT(reasons(),
              ElementsAre("after 1 error, 1 loss it waits another 1 s; last failure: signal 11"));
  wait(60'000);
  state_->drain(worker_);
  EXPECT_THAT(reasons(), ElementsAre("1 of 1 workers: about to leave"));
  state_->out_of_resources("full", now_);
  EXPECT_THAT(reasons(), ElementsAre("no room on the disk (full); next try in 1 s"));
  state_->cancel(JobId{1}, now_);
  EXPECT_THAT(reasons(), ElementsAre("its job is cancelled"));
}

TEST_F(OutlookWords, say_which_input_is_missing_and_who_makes_it) {
  submit();
  files_.erase(surface_.hash);
  EXPECT_THAT(reasons(),
              ElementsAre("its input 'input_surface' is not in the store, or damaged; it came with "
                          "the job: submit the job again"));
}

TEST_F(OutlookWords, count_the_tasks_that_come_before) {
  submit("a");
  submit("b");
  submit("c");
  commit();
  worker_ = new_worker();
  next(worker_);
  EXPECT_THAT(reasons(2), ElementsAre("1 of 1 workers: busy"));
  EXPECT_THAT(reasons(3), ElementsAre("1 of 1 workers: busy", "1 ready task comes before it"));
  submit("d");
  EXPECT_THAT(reasons(4), ElementsAre("1 of 1 workers: busy", "2 ready tasks come before it"));
}

}  // namespace
}  // namespace tetfarm
