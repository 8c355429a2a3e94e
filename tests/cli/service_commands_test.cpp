// The commands that act on a farm, called as main calls them: what they ask for, and what they say.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/job_input.h"
#include "store/artifact_store.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* tet_off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
constexpr const char* open_off =
    "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";

wire::JobStatus job_that_is(const std::string& state) {
  wire::JobStatus status;
  status.set_job("job-7");
  status.set_state(state);
  return status;
}

/// Its answers are to be set before anything is asked.
class Served : public ::testing::Test {
 protected:
  ClientOptions client(const std::string& job = "") const {
    ClientOptions options;
    options.endpoint = coordinator_.endpoint();
    options.timeout_s = 5;
    options.job = job;
    options.progress = ProgressStyle::none;
    return options;
  }
  /// What it was asked, without the questions about the status.
  std::vector<wire::Envelope> asked() const {
    std::vector<wire::Envelope> asked;
    for (const wire::Envelope& envelope : coordinator_.heard()) {
      if (!envelope.has_status_request()) asked.push_back(envelope);
    }
    return asked;
  }
  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }

  const TempFolder folder_;
  std::vector<wire::JobStatus> jobs_;  ///< status after status; the last one again and again
  std::size_t told_ = 0;
  bool is_found_ = true;
  std::uint64_t count_ = 1;
  FakeCoordinator coordinator_{[this](const wire::Envelope& said) {
    wire::Envelope answer;
    switch (said.body_case()) {
      case wire::Envelope::kStatusRequest:
        answer = reply_with({});
        if (!jobs_.empty()) {
          *answer.mutable_status_reply()->add_jobs() = jobs_[std::min(told_++, jobs_.size() - 1)];
        }
        break;
      case wire::Envelope::kCancel:
        answer.mutable_cancelled()->set_found(is_found_);
        break;
      case wire::Envelope::kSetPriority:
        answer.mutable_priority_set()->set_found(is_found_);
        answer.mutable_priority_set()->set_state(jobs_.empty() ? "running" : jobs_[0].state());
        break;
      case wire::Envelope::kRetry:
        answer.mutable_retried()->set_count(count_);
        break;
      case wire::Envelope::kDrainWorkers:
        answer.mutable_draining()->set_count(count_);
        break;
      case wire::Envelope::kSubmit:
        answer.mutable_submitted()->set_job("job-7");
        answer.mutable_submitted()->set_existed(!is_found_);
        break;
      case wire::Envelope::kOfferFile:
        answer.mutable_file_stored()->set_hash(said.offer_file().hash());
        answer.mutable_file_stored()->set_resend(true);  // from its beginning
        break;
      case wire::Envelope::kFileChunk:
        answer.mutable_file_stored()->set_hash(said.file_chunk().hash());
        answer.mutable_file_stored()->set_bytes(said.file_chunk().offset() +
                                                said.file_chunk().bytes().size());
        answer.mutable_file_stored()->set_whole(true);
        break;
      default:
        return std::vector<wire::Envelope>();
    }
    return std::vector<wire::Envelope>{answer};
  }};
};

TEST_F(Served, a_job_that_runs_is_cancelled) {
  jobs_ = {job_that_is("running")};
  EXPECT_EQ(said_by([&] { return cancel_command({client("job-7")}); }).out, "job-7 cancelled\n");
  ASSERT_THAT(asked(), SizeIs(1));
  EXPECT_EQ(asked()[0].cancel().job(), "job-7");
  CancelCommand as_json{client("job-7")};
  as_json.client.json = true;
  EXPECT_EQ(said_by([&] { return cancel_command(as_json); }).out,
            "{\"type\":\"cancelled\",\"job\":\"job-7\"}\n");
}

TEST_F(Served, a_job_that_is_over_is_not_cancelled) {
  for (const char* state : {"done", "failed"}) {
    jobs_ = {job_that_is(state)};
    const Said said = said_by([&] { return cancel_command({client("job-7")}); });
    EXPECT_EQ(said.code, ExitCode::failed);
    EXPECT_EQ(said.error,
              std::string("job-7 is already ") + state + ": there is nothing to cancel");
    EXPECT_EQ(said.help, "");
  }
  jobs_ = {job_that_is("cancelled")};
  EXPECT_EQ(said_by([&] { return cancel_command({client("job-7")}); }).out,
            "job-7 was already cancelled\n");
}

TEST_F(Served, a_job_that_is_not_there_is_not_cancelled) {
  is_found_ = false;
  const Said said = said_by([&] { return cancel_command({client("job-7")}); });
  EXPECT_EQ(said.code, ExitCode::not_found);
  EXPECT_EQ(said.error, "no job job-7 at " + coordinator_.endpoint());
}

TEST_F(Served, tasks_and_hosts_are_taken_out_of_quarantine) {
  count_ = 3;
  EXPECT_EQ(said_by([&] {
              return retry_command({client("job-7"), 31, ""});
            }).out,
            "took 3 tasks of job-7 out of quarantine\n");
  EXPECT_EQ(asked().back().retry().job(), "job-7");
  EXPECT_EQ(asked().back().retry().task(), 31U);
  EXPECT_EQ(asked().back().retry().host(), "");
  count_ = 1;
  EXPECT_EQ(said_by([&] {
              return retry_command({client(), 0, "node5"});
            }).out,
            "took node5 out of quarantine\n");
  EXPECT_EQ(asked().back().retry().host(), "node5");
  RetryCommand as_json{client("job-7"), 0, ""};
  as_json.client.json = true;
  EXPECT_EQ(said_by([&] { return retry_command(as_json); }).out,
            "{\"type\":\"retried\",\"count\":1}\n");
}

TEST_F(Served, what_is_not_in_quarantine_is_not_found) {
  count_ = 0;
  const Said of_job = said_by([&] { return retry_command({client("job-7"), 0, ""}); });
  EXPECT_EQ(of_job.code, ExitCode::not_found);
  EXPECT_EQ(of_job.error, "job-7: nothing is in quarantine");
  const Said of_host = said_by([&] { return retry_command({client(), 0, "node5"}); });
  EXPECT_EQ(of_host.code, ExitCode::not_found);
  EXPECT_EQ(of_host.error, "node5: is not in quarantine");
}

TEST_F(Served, either_a_job_or_a_host_is_tried_again) {
  for (const auto& [job, host] : {std::pair{"", ""}, {"job-7", "node5"}}) {
    const RetryCommand command{client(job), 0, host};
    const Said said = said_by([&] { return retry_command(command); });
    EXPECT_EQ(said.code, ExitCode::usage);
    EXPECT_EQ(said.error, "retry: give either a job or --host NAME");
  }
  EXPECT_THAT(asked(), IsEmpty());
}

TEST_F(Served, workers_are_drained_one_or_all) {
  EXPECT_EQ(said_by([&] {
              return drain_command({client(), "worker-7", false});
            }).out,
            "1 worker is draining\n");
  EXPECT_EQ(asked().back().drain_workers().worker(), 7U);
  count_ = 2;
  EXPECT_EQ(said_by([&] {
              return drain_command({client(), "", true});
            }).out,
            "2 workers are draining\n");
  EXPECT_EQ(asked().back().drain_workers().worker(), 0U);
  DrainCommand as_json{client(), "", true};
  as_json.client.json = true;
  EXPECT_EQ(said_by([&] { return drain_command(as_json); }).out,
            "{\"type\":\"draining\",\"count\":2}\n");
}

TEST_F(Served, what_is_no_worker_is_not_drained) {
  for (const char* name : {"", "7", "worker-", "worker-0", "worker-7x", "worker-x", "Worker-7"}) {
    const Said said = said_by([&] { return drain_command({client(), name, false}); });
    EXPECT_EQ(said.code, ExitCode::usage) << name;
    EXPECT_EQ(said.error, "drain: give either a worker or --all") << name;
  }
  const Said both = said_by([&] { return drain_command({client(), "worker-7", true}); });
  EXPECT_EQ(both.error, "drain: give either a worker or --all");
  EXPECT_THAT(asked(), IsEmpty());
  count_ = 0;
  const Said gone = said_by([&] { return drain_command({client(), "worker-7", false}); });
  EXPECT_EQ(gone.code, ExitCode::not_found);
  EXPECT_EQ(gone.error, "no worker-7 at " + coordinator_.endpoint());
  EXPECT_EQ(said_by([&] {
              return drain_command({client(), "", true});
            }).out,
            "0 workers are draining\n");
}

TEST_F(Served, a_surface_is_brought_and_its_job_submitted) {
  SubmitCommand command;
  command.client = client();
  command.job.input = write("tet.off", tet_off);
  const Said said = said_by([&] { return submit_command(command); });
  EXPECT_EQ(said.error, "");
  EXPECT_EQ(said.out, "job-7\n");
  ASSERT_THAT(asked(), SizeIs(3)) << "offered, sent, submitted";
  EXPECT_EQ(asked()[0].offer_file().size(), std::string(tet_off).size());
  EXPECT_EQ(asked()[1].file_chunk().bytes(), tet_off);
  const wire::Submit submit = asked()[2].submit();
  EXPECT_EQ(submit.name(), "tet");
  EXPECT_EQ(submit.surface_path(), "");
  EXPECT_FALSE(submit.replaces_others());
  ASSERT_EQ(submit.inputs_size(), 1);
  EXPECT_EQ(submit.inputs(0).name(), "input_surface");
  EXPECT_EQ(submit.inputs(0).hash(), asked()[0].offer_file().hash());
  EXPECT_EQ(submit.inputs(0).size(), asked()[0].offer_file().size());
  const JobInput input = read_job(command.job);
  EXPECT_EQ(submit.job_toml(), to_toml(input.job));
  EXPECT_EQ(submit.key(), key_of(input));
}

TEST_F(Served, a_submission_tells_programs_whether_the_job_was_there) {
  SubmitCommand command;
  command.client = client();
  command.job.input = write("tet.off", tet_off);
  command.client.json = true;
  EXPECT_EQ(said_by([&] { return submit_command(command); }).out,
            "{\"type\":\"submitted\",\"job\":\"job-7\",\"existed\":false}\n");
  is_found_ = false;
  EXPECT_EQ(said_by([&] { return submit_command(command); }).out,
            "{\"type\":\"submitted\",\"job\":\"job-7\",\"existed\":true}\n");
}

TEST_F(Served, a_surface_goes_into_a_store_that_is_seen_from_here) {
  const ArtifactStore store(folder_.path() / "farm");
  SubmitCommand command;
  command.client = client();
  command.job.input = write("tet.off", tet_off);
  command.job.store = store.folder().string();
  EXPECT_EQ(said_by([&] { return submit_command(command); }).out, "job-7\n");
  ASSERT_THAT(asked(), SizeIs(1)) << "nothing is sent";
  const wire::Artifact surface = asked()[0].submit().inputs(0);
  EXPECT_EQ(store.read(surface.hash(), surface.size()), tet_off);
}

TEST_F(Served, a_surface_that_the_coordinator_reads_goes_by_its_path) {
  SubmitCommand command;
  command.client = client();
  command.coordinator_reads = true;
  command.job.input = write("tet.off", tet_off);
  EXPECT_EQ(said_by([&] { return submit_command(command); }).err, "");
  command.job.input = (folder_.path() / "elsewhere.off").string();
  EXPECT_EQ(said_by([&] { return submit_command(command); }).err,
            "note: " + command.job.input + " cannot be seen from here; the farm will check it\n");
  ASSERT_THAT(asked(), SizeIs(2));
  const wire::Submit submit = asked()[1].submit();
  EXPECT_EQ(submit.surface_path(), command.job.input);
  EXPECT_EQ(submit.name(), "elsewhere");
  EXPECT_EQ(submit.key(), "");
  EXPECT_EQ(submit.inputs_size(), 0);
  EXPECT_EQ(submit.job_toml(), to_toml(describe_job(command.job).job));
}

TEST_F(Served, a_surface_is_checked_before_it_is_submitted_unless_that_is_not_wanted) {
  SubmitCommand command;
  command.client = client();
  command.job.input = write("open.off", open_off);
  const Said refused = said_by([&] { return submit_command(command); });
  EXPECT_EQ(refused.code, ExitCode::bad_geometry);
  EXPECT_THAT(refused.error, HasSubstr("open.off: the surface cannot be meshed"));
  command.coordinator_reads = true;
  EXPECT_EQ(said_by([&] { return submit_command(command); }).code, ExitCode::bad_geometry);
  EXPECT_THAT(asked(), IsEmpty());
  command.check = false;
  EXPECT_EQ(said_by([&] { return submit_command(command); }).code, ExitCode::ok);
  command.coordinator_reads = false;
  EXPECT_EQ(said_by([&] { return submit_command(command); }).code, ExitCode::ok);
  command.job.input = (folder_.path() / "elsewhere.off").string();
  const Said missing = said_by([&] { return submit_command(command); });
  EXPECT_EQ(missing.code, ExitCode::not_found);
  EXPECT_EQ(missing.error, command.job.input + ": no such file");
  EXPECT_EQ(missing.help,
            "check the path; if only the coordinator can see the file, add --coordinator-reads");
}

TEST_F(Served, waiting_ends_with_the_job_and_its_exit_code) {
  wire::JobStatus done = job_that_is("done");
  done.set_seconds(72);
  jobs_ = {job_that_is("running"), done};
  WaitCommand command{client("job-7"), ""};
  command.client.json = true;
  const Said said = said_by([&] { return wait_command(command); });
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_EQ(json::parse(said.out)["seconds"], 72);
  EXPECT_EQ(told_, 2U) << "it was asked again";
  EXPECT_EQ(coordinator_.heard()[0].status_request().job(), "job-7");
  wire::JobStatus failed = job_that_is("failed");
  failed.set_exit_code(3);
  failed.set_message("open edge");
  jobs_ = {failed};
  const Said end = said_by([&] { return wait_command(command); });
  EXPECT_EQ(end.code, ExitCode::bad_geometry);
  EXPECT_EQ(end.error, "open edge");
}

TEST_F(Served, waiting_tells_programs_how_far_the_job_is_and_how_it_ended) {
  wire::JobStatus running = job_that_is("running");
  running.set_stage("mesh");
  jobs_ = {running, job_that_is("done")};
  WaitCommand command{client("job-7"), ""};
  command.client.json = true;
  command.client.progress = ProgressStyle::json;
  std::istringstream lines(said_by([&] { return wait_command(command); }).err);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(json::parse(line)["type"], "progress");
  EXPECT_EQ(json::parse(line)["stage"], "mesh");
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(json::parse(line)["type"], "end");
  EXPECT_EQ(json::parse(line)["job"], "job-7");
  EXPECT_FALSE(std::getline(lines, line)) << line;
}

TEST_F(Served, submitting_tells_programs_the_job_at_its_end) {
  SubmitCommand command;
  command.client = client();
  command.client.progress = ProgressStyle::json;
  command.job.input = write("tet.off", tet_off);
  const json end = json::parse(said_by([&] { return submit_command(command); }).err);
  EXPECT_EQ(end["state"], "submitted");
  EXPECT_EQ(end["job"], "job-7");
}

TEST_F(Served, waiting_for_a_job_that_is_not_there_ends_at_once) {
  const Said said = said_by([&] { return wait_command({client("job-7"), ""}); });
  EXPECT_EQ(said.code, ExitCode::not_found);
  EXPECT_EQ(said.error, "no job job-7 at " + coordinator_.endpoint());
}

TEST_F(Served, results_are_taken_from_the_store_where_it_is_seen) {
  const ArtifactStore store(folder_.path() / "farm");
  const StoredArtifact mesh = store.publish("a mesh");
  wire::JobStatus done = job_that_is("done");
  wire::Artifact& file = *done.add_files();
  file.set_name("tet.lb8.ugrid");
  file.set_hash(mesh.hash);
  file.set_size(mesh.size);
  jobs_ = {done};
  WaitCommand command{client("job-7"), store.folder().string()};
  command.client.output = (folder_.path() / "out").string();
  command.client.json = true;
  const Said said = said_by([&] { return wait_command(command); });
  EXPECT_EQ(said.error, "");
  const std::filesystem::path brought = folder_.path() / "out" / "tet.lb8.ugrid";
  EXPECT_EQ(read_file(brought), "a mesh");
  EXPECT_EQ(json::parse(said.out)["files"], json({brought.string()}));
}

}  // namespace
}  // namespace tetfarm
