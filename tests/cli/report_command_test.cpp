// One page about a mesh or a job, written as main does it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/file_system.h"
#include "cli/commands.h"
#include "mesh/formats/registry/export_mesh.h"
#include "store/artifact_store.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Reported : public ::testing::Test {
 protected:
  Reported() { command_.output = (folder_.path() / "report.html").string(); }
  Said report(const std::string& subject) {
    command_.view.client.job = subject;
    return said_by([&] { return report_command(command_); });
  }
  std::string page() const { return read_file(command_.output); }
  std::string write_grid(const std::string& name, int n = 2) const {
    const std::filesystem::path file = folder_.path() / name;
    export_mesh(GridSource(cut_grid(n)), find_mesh_format("", file), file);
    return file.string();
  }

  const TempFolder folder_;
  ReportCommand command_;
};

TEST_F(Reported, a_mesh_has_pictures_and_figures_and_no_work) {
  const Said said = report(write_grid("wing.vtkhdf"));
  EXPECT_EQ(said.error, "");
  EXPECT_EQ(said.err, command_.output + ": 48 tets\n");
  EXPECT_EQ(said.out, "");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<title>wing.vtkhdf – Tetfarm</title>"));
  for (const char* caption : {"The surface, coloured by sub-domain",
                              "The mesh cut open through its middle, coloured by sub-domain",
                              "The sub-domains, moved apart"}) {
    EXPECT_THAT(html, HasSubstr(std::string("<figcaption>") + caption + "</figcaption>"));
  }
  EXPECT_THAT(html, Not(HasSubstr("id=\"work\"")));
}

TEST_F(Reported, a_mesh_without_sub_domains_is_coloured_by_patch) {
  command_.view.client.json = true;
  const Said said = report(write_grid("wing.meshb"));
  EXPECT_EQ(said.err, "");
  EXPECT_EQ(nlohmann::json::parse(said.out),
            nlohmann::json({{"type", "report"}, {"file", command_.output}}));
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("The surface, coloured by patch<"));
  EXPECT_THAT(html, HasSubstr("The mesh cut open through its middle, coloured by patch<"));
  EXPECT_THAT(html, Not(HasSubstr("moved apart")));
}

TEST_F(Reported, a_job_has_its_tasks_and_attempts_of_all_pages) {
  const ArtifactStore store(folder_.path() / "farm");
  const StoredArtifact mesh = store.publish(read_file(write_grid("wing.vtkhdf")));
  FakeCoordinator coordinator([&](const wire::Envelope& said) {
    wire::Envelope answer;
    if (said.has_status_request()) {
      wire::JobStatus job;
      job.set_job("job-7");
      job.set_name("wing of a farm");
      job.set_state("done");
      wire::Artifact& file = *job.add_files();
      file.set_name("wing.vtkhdf");
      file.set_hash(mesh.hash);
      file.set_size(mesh.size);
      if (said.status_request().job() == "job-7") answer = reply_with({job});
      if (said.status_request().job() != "job-7") answer = reply_with({});
    }
    if (said.has_query()) {
      wire::QueryReply& reply = *answer.mutable_query_reply();
      const bool is_first = said.query().after() == 0;
      if (said.query().subject() == wire::Query::TASKS) {
        wire::TaskLine& task = *reply.add_tasks();
        task.set_kind("mesh");
        task.set_state("done");
        task.set_path(is_first ? 2 : 3);
        reply.set_next(is_first ? 1 : 0);
      }
      if (said.query().subject() == wire::Query::ATTEMPTS) {
        wire::AttemptLine& attempt = *reply.add_attempts();
        attempt.set_kind(is_first ? "mesh" : "write");
        attempt.set_state("done");
        attempt.set_started_ms(1000);
        attempt.set_ended_ms(2000);
        reply.set_next(is_first ? 1 : 0);
      }
    }
    return std::vector<wire::Envelope>{answer};
  });
  command_.view.client.endpoint = coordinator.endpoint();
  command_.view.client.timeout_s = 5;
  command_.view.store = store.folder().string();
  EXPECT_EQ(report("job-7").error, "");
  const std::string html = page();
  EXPECT_THAT(html, HasSubstr("<title>wing of a farm – Tetfarm</title>"));
  EXPECT_THAT(html, HasSubstr("Each task (2 of 2)"));
  EXPECT_THAT(html, HasSubstr("<tr><td>attempts</td><td>2</td></tr>"));
  for (const wire::Envelope& envelope : coordinator.heard()) {
    if (envelope.has_query() && envelope.query().subject() != wire::Query::JOBS) {
      EXPECT_EQ(envelope.query().job(), "job-7");
    }
  }
  EXPECT_EQ(report("job-8").error, "no job job-8");
}

TEST_F(Reported, what_is_not_there_is_not_found) {
  const Said said = report("job-7");
  EXPECT_EQ(said.code, ExitCode::not_found);
  EXPECT_EQ(said.error,
            "job-7: no such folder or mesh; for a job, say where it is with --connect or --store");
  const Said empty = report(folder_.path().string());
  EXPECT_EQ(empty.error, folder_.path().string() + ": has no mesh (.vtkhdf, .lb8.ugrid)");
}

}  // namespace
}  // namespace tetfarm
