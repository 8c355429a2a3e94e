#include "coordinator/decisions/message_translation.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(MessageTranslation, a_hello_is_a_worker_with_all_that_it_says) {
  wire::Hello hello;
  hello.set_host("node-1");
  hello.set_process(11);
  hello.set_cores(12);
  hello.set_memory_bytes(13);
  hello.set_program_version("1.4");
  hello.set_nonce("a nonce");
  hello.set_ends_in_ms(15);
  hello.set_tag("pool/7");
  hello.set_pool_memory_bytes(16);
  hello.set_runs_solvers(true);
  const WorkerInfo info = worker_info_of(hello);
  EXPECT_EQ(info.host, "node-1");
  EXPECT_EQ(info.process, 11);
  EXPECT_EQ(info.cores, 12U);
  EXPECT_EQ(info.memory_bytes, 13U);
  EXPECT_EQ(info.program_version, "1.4");
  EXPECT_EQ(info.nonce, "a nonce");
  EXPECT_EQ(info.ends_in_ms, 15);
  EXPECT_EQ(info.tag, "pool/7");
  EXPECT_EQ(info.pool_memory_bytes, 16U);
  EXPECT_TRUE(info.runs_solvers);
  EXPECT_TRUE(info.shares_memory);
  EXPECT_EQ(info.key, "") << "that is not the worker's to say";
  hello.set_own_memory(true);
  hello.set_ends_in_ms(~std::uint64_t{0});
  EXPECT_FALSE(worker_info_of(hello).shares_memory);
  EXPECT_EQ(worker_info_of(hello).ends_in_ms, std::int64_t{1} << 50U)
      << "a sum of times may not overflow";
}

TEST(MessageTranslation, names_of_files_cannot_lead_out_of_a_folder) {
  wire::Done done;
  const auto name_of_file = [&done](const std::string& name) {
    done.clear_outputs();
    done.add_outputs()->set_name(name);
    return files_of(done.outputs()).at(0).name;
  };
  EXPECT_EQ(name_of_file("mesh:5"), "mesh:5");
  EXPECT_EQ(name_of_file("../../etc/passwd"), ".._.._etc_passwd");
  EXPECT_EQ(name_of_file("a\nb\tc\x7f\x1b"), "a_b_c__");
  EXPECT_EQ(name_of_file("Fl\xc3\xbcgel ~"), "Fl\xc3\xbcgel ~");
  for (const char* name : {"", ".", ".."}) EXPECT_EQ(name_of_file(name), "_") << name;
  EXPECT_EQ(name_of_file("..."), "...");
}

TEST(MessageTranslation, a_result_is_as_it_was_said) {
  wire::Done done;
  wire::Artifact& file = *done.add_outputs();
  file.set_name("mesh");
  file.set_hash("hash");
  file.set_size(5);
  (*done.mutable_numbers())["tets"] = 6;
  (*done.mutable_texts())["reason"] = "none";
  done.set_seconds(7.5);
  done.set_peak_rss_bytes(8);
  done.set_log("its words");
  const TaskResult result = result_of(done);
  EXPECT_THAT(result.outputs, ElementsAre(ArtifactRef{"mesh", "hash", 5}));
  EXPECT_THAT(result.numbers, ElementsAre(Pair("tets", 6)));
  EXPECT_THAT(result.texts, ElementsAre(Pair("reason", "none")));
  EXPECT_EQ(result.seconds, 7.5);
  EXPECT_EQ(result.peak_rss_bytes, 8U);
  EXPECT_EQ(result.log, "its words");
}

TEST(MessageTranslation, a_failure_is_as_it_was_said_but_for_what_only_the_store_knows) {
  wire::Failed failed;
  failed.set_exit_code(3);
  failed.set_message("open");
  failed.set_cause(6);
  failed.set_peak_rss_bytes(4);
  failed.set_log("its words");
  failed.add_damaged_inputs("hash");
  failed.add_evidence()->set_name("a/b");
  const TaskFailure failure = failure_of(failed);
  EXPECT_EQ(failure.exit_code, 3);
  EXPECT_EQ(failure.message, "open");
  EXPECT_EQ(failure.cause, FailureCause::damaged_input);
  EXPECT_EQ(failure.peak_rss_bytes, 4U);
  EXPECT_EQ(failure.log, "its words");
  EXPECT_TRUE(failure.damaged_inputs.empty());
  ASSERT_EQ(failure.evidence.size(), 1U);
  EXPECT_EQ(failure.evidence[0].name, "a_b");
  for (const std::uint32_t unknown : {0U, 7U}) {
    failed.set_cause(unknown);
    EXPECT_EQ(failure_of(failed).cause, FailureCause::error) << "worth another try";
  }
}

TEST(MessageTranslation, an_assignment_has_all_that_the_task_was_made_with) {
  TaskRow task;
  task.id = TaskId{5};
  task.job = JobId{2};
  task.kind = TaskKind::cosmetic;
  task.path = 9;
  task.inputs = {{"own", "a", 1}, {"spacing", "b", 2}};
  task.parameters = {{"colours", "9 0"}};
  EXPECT_EQ(assign_message(task, AttemptId{7}).ShortDebugString(),
            R"(assign { task: 5 attempt: 7 job: "job-2" kind: 9 path: 9 )"
            R"(inputs { name: "own" hash: "a" size: 1 } inputs { name: "spacing" hash: "b" )"
            R"(size: 2 } parameters { key: "colours" value: "9 0" } })");
}

TEST(MessageTranslation, answers_to_workers_and_clients_say_what_was_decided) {
  EXPECT_EQ(accepted_message({WorkerId{1}, TaskId{2}, AttemptId{3}, true}).ShortDebugString(),
            "accepted { task: 2 attempt: 3 taken: true }");
  EXPECT_EQ(accepted_message({WorkerId{1}, TaskId{2}, AttemptId{3}, false}).ShortDebugString(),
            "accepted { task: 2 attempt: 3 }");
  EXPECT_EQ(refused_message("no", true, 5).ShortDebugString(),
            R"(refused { reason: "no" hello_again: true exit_code: 5 })");
  EXPECT_EQ(refused_message("no", false, 0).ShortDebugString(), R"(refused { reason: "no" })");
}

TEST(MessageTranslation, a_status_has_every_figure_under_its_own_name) {
  JobSummary summary;
  summary.job = JobId{1};
  summary.name = "wing";
  summary.state = "failed";
  summary.stage = "mesh";
  summary.leaves_made = 2;
  summary.leaves_meshed = 3;
  summary.leaves_mended = 4;
  summary.elements = 5;
  summary.estimated_elements = 6.5;
  summary.message = "why";
  summary.exit_code = 7;
  summary.numbers = {{"volume", 8}};
  summary.texts = {{"digest", "d"}};
  summary.files = {{"a.vtp", "h", 9}};
  summary.tasks_done = 10;
  summary.tasks_ready = 11;
  summary.tasks_running = 12;
  summary.attempts_lost = 13;
  summary.crashes = 14;
  summary.oom_count = 15;
  TaskRow failed;
  failed.id = TaskId{16};
  failed.kind = TaskKind::mesh;
  failed.path = 17;
  failed.message = "its last words";
  failed.exit_code = 18;
  summary.quarantine = {failed};
  summary.peak_rss_bytes_worker = 19;
  summary.seconds = 20.5;
  summary.created_ms = 21;
  summary.finished_ms = 22;
  EXPECT_EQ(
      status_message(summary).ShortDebugString(),
      R"(job: "job-1" name: "wing" state: "failed" stage: "mesh" leaves_made: 2 )"
      R"(leaves_meshed: 3 elements: 5 estimated_elements: 6.5 message: "why" exit_code: 7 )"
      R"(numbers { key: "volume" value: 8 } texts { key: "digest" value: "d" } )"
      R"(files { name: "a.vtp" hash: "h" size: 9 } tasks_done: 10 tasks_ready: 11 )"
      R"(tasks_running: 12 attempts_lost: 13 peak_rss_bytes_worker: 19 seconds: 20.5 crashes: 14 )"
      R"(leaves_mended: 4 quarantine { task: 16 kind: "mesh" path: 17 reason: "its last words" )"
      R"(exit_code: 18 } oom_count: 15 created_ms: 21 finished_ms: 22)");
}

}  // namespace
}  // namespace tetfarm
