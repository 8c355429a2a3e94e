#include "json/progress_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tetfarm {
namespace {

using nlohmann::json;

TEST(ProgressJson, tells_a_job_by_its_stage_share_tasks_and_workers) {
  wire::JobStatus status;
  status.set_job("job-7");
  status.set_name("wing");
  status.set_state("running");
  status.set_stage("mesh");
  status.set_leaves_made(8);
  status.set_leaves_meshed(3);
  status.set_elements(300'000);
  status.set_estimated_elements(8e5);
  status.set_tasks_done(12);
  status.set_tasks_running(2);
  status.set_tasks_ready(4);
  status.add_quarantine()->set_task(31);
  status.set_attempts_lost(1);
  EXPECT_EQ(progress_json(status, {1'700'000'000'000, 0.5, 2, 12.5}),
            "{\"type\":\"progress\",\"version\":1,\"time_ms\":1700000000000,\"job\":\"job-7\","
            "\"name\":\"wing\",\"state\":\"running\",\"stage\":\"mesh\",\"share\":0.5,"
            "\"tasks\":{\"done\":12,\"total\":19,\"running\":2,\"waiting\":4,\"failed\":1},"
            "\"subdomains\":8,\"subdomains_meshed\":3,\"elements\":300000,"
            "\"estimated_elements\":800000.0,\"workers\":2,\"eta_seconds\":12.5,"
            "\"attempts_lost\":1}");
  const json unknown = json::parse(progress_json(status, {}));
  EXPECT_TRUE(unknown["eta_seconds"].is_null());
  EXPECT_TRUE(unknown.contains("eta_seconds"));
}

TEST(ProgressJson, tells_transfers_and_messages) {
  EXPECT_EQ(transfer_json("fetching wing.vtkhdf", {5, 100, 400}),
            "{\"type\":\"transfer\",\"version\":1,\"time_ms\":5,\"what\":\"fetching wing.vtkhdf\","
            "\"there_bytes\":100,\"size_bytes\":400}");
  EXPECT_EQ(message_json("a \"note\"\t", 5),
            "{\"type\":\"message\",\"version\":1,\"time_ms\":5,\"text\":\"a \\\"note\\\"\\t\"}");
  EXPECT_EQ(json::parse(message_json("no\xff\x1b[2J", 5))["text"], "no\xEF\xBF\xBD\x1b[2J")
      << "bytes that are no text are replaced";
}

TEST(ProgressJson, tells_the_end_with_files_or_with_what_was_wrong) {
  CommandEnd done;
  done.wall_ms = 5;
  done.state = "done";
  done.job = "job-7";
  done.files = {"/out/wing.vtkhdf", "/out/wing.su2"};
  EXPECT_EQ(end_json(done),
            "{\"type\":\"end\",\"version\":1,\"time_ms\":5,\"state\":\"done\",\"job\":\"job-7\","
            "\"exit_code\":0,\"message\":\"\",\"help\":\"\","
            "\"files\":[\"/out/wing.vtkhdf\",\"/out/wing.su2\"]}");
  CommandEnd failed;
  failed.state = "failed";
  failed.exit_code = 3;
  failed.message = "open edge\n  see wing.vtp";
  failed.help = "repair the input there";
  const json end = json::parse(end_json(failed));
  EXPECT_EQ(end["message"], failed.message);
  EXPECT_EQ(end["help"], failed.help);
  EXPECT_EQ(end["exit_code"], 3);
  EXPECT_EQ(end["files"], json::array());
}

}  // namespace
}  // namespace tetfarm
