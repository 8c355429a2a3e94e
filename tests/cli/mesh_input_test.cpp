#include "cli/mesh_input.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "base/hash.h"
#include "cli/commands.h"
#include "proto/file_chunks.h"
#include "store/artifact_store.h"
#include "store/job_database.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// A job and its store, which may be seen or not.
class MeshOfAJob : public ::testing::Test {
 protected:
  MeshOfAJob() {
    status_.set_job("job-7");
    status_.set_state("done");
  }
  StoredArtifact add(const std::string& name, const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact& file = *status_.add_files();
    file.set_name(name);
    file.set_hash(stored.hash);
    file.set_size(stored.size);
    return stored;
  }
  ViewOptions seen() const {
    ViewOptions view;
    view.store = store_.folder().string();
    return view;
  }
  Said trouble(const wire::JobStatus& status) const {
    return said_by([&] {
      mesh_of_job(status, seen(), folder_.path());
      return ExitCode::ok;
    });
  }

  const TempFolder folder_;
  ArtifactStore store_{folder_.path() / "farm"};
  wire::JobStatus status_;
};

TEST_F(MeshOfAJob, is_its_vtkhdf_file_wherever_that_stands_among_its_results) {
  add("wing.lb8.ugrid", "a ugrid");
  const StoredArtifact best = add("folder/wing.vtkhdf", "a vtkhdf");
  const MeshInput mesh = mesh_of_job(status_, seen(), folder_.path());
  EXPECT_EQ(mesh.file, store_.path_of(best.hash));
  EXPECT_EQ(mesh.name, "job-7/wing.vtkhdf");
  EXPECT_EQ(mesh.job, "job-7");
  EXPECT_EQ(mesh.store, store_.folder());
  EXPECT_EQ(mesh.fetched.path(), "");
}

TEST_F(MeshOfAJob, may_be_its_ugrid_file_and_nothing_else) {
  add("wing.defects.vtp", "a picture");
  const Said none = trouble(status_);
  EXPECT_EQ(none.code, ExitCode::not_found);
  EXPECT_EQ(none.error, "job-7 has no mesh that can be read (.vtkhdf or .lb8.ugrid)");
  const StoredArtifact mesh = add("wing.lb8.ugrid", "a ugrid");
  EXPECT_EQ(mesh_of_job(status_, seen(), folder_.path()).file, store_.path_of(mesh.hash));
}

TEST_F(MeshOfAJob, is_not_there_before_the_job_is_done) {
  add("wing.vtkhdf", "a vtkhdf");
  status_.set_state("running");
  status_.set_stage("mesh");
  EXPECT_EQ(trouble(status_).error,
            "job-7 is not finished (running, stage mesh); wait for it: `tetfarm wait job-7`");
  status_.set_message("open edge");
  status_.set_state("failed");
  EXPECT_EQ(trouble(status_).error, "job-7 has no mesh: it failed: open edge");
  status_.set_state("cancelled");
  EXPECT_EQ(trouble(status_).error, "job-7 has no mesh: it was cancelled");
  EXPECT_EQ(trouble(status_).code, ExitCode::not_found);
}

TEST_F(MeshOfAJob, that_is_damaged_is_not_taken) {
  const StoredArtifact mesh = add("wing.vtkhdf", "a vtkhdf");
  std::filesystem::remove(store_.path_of(mesh.hash));
  write_file_atomically(store_.path_of(mesh.hash), "a vtkhdg");
  EXPECT_EQ(trouble(status_).code, ExitCode::failed);
}

TEST_F(MeshOfAJob, comes_over_the_connection_where_no_store_is_seen) {
  add("wing.vtkhdf", "a vtkhdf");
  FakeCoordinator coordinator([&](const wire::Envelope& said) {
    std::vector<wire::Envelope> answers(1);
    if (said.has_status_request()) {
      answers[0] = reply_with({});
      if (said.status_request().job() == "job-7") answers[0] = reply_with({status_});
    }
    if (said.has_fetch_file()) {
      wire::FileChunk& chunk = *answers[0].mutable_file_chunk();
      chunk.set_hash(said.fetch_file().hash());
      fill_chunk(chunk, "a vtkhdf");
    }
    return answers;
  });
  ViewOptions view;
  view.client.endpoint = coordinator.endpoint();
  view.client.timeout_s = 5;
  view.client.progress = ProgressStyle::none;
  const MeshInput mesh = find_mesh("job-7", view, folder_.path());
  EXPECT_EQ(mesh.file.parent_path(), folder_.path());
  EXPECT_EQ(read_file(mesh.file), "a vtkhdf");
  EXPECT_EQ(mesh.name, "job-7/wing.vtkhdf");
  EXPECT_EQ(mesh.store, "");
  EXPECT_FALSE(spacing_of(mesh, view)) << "it is in the store";
  const Said unknown = said_by([&] {
    find_mesh("job-8", view, folder_.path());
    return ExitCode::ok;
  });
  EXPECT_EQ(unknown.code, ExitCode::not_found);
  EXPECT_EQ(unknown.error, "no job job-8 at " + coordinator.endpoint());
}

TEST_F(MeshOfAJob, of_a_store_that_does_not_know_it_is_not_found) {
  ChangeSet changes;
  JobRow job;
  job.id = JobId{1};
  changes.jobs = {job};
  JobDatabase(store_.folder() / "tetfarm.db").apply(changes);
  const Said unknown = said_by([&] {
    find_mesh("job-7", seen(), folder_.path());
    return ExitCode::ok;
  });
  EXPECT_EQ(unknown.error, "no job job-7 in " + store_.folder().string());
  EXPECT_EQ(unknown.err, "") << "not that no coordinator answers";
}

TEST_F(MeshOfAJob, is_looked_for_only_when_it_is_said_where) {
  const auto trouble_with = [&](const std::string& subject) {
    return said_by([&] {
      find_mesh(subject, {}, folder_.path());
      return ExitCode::ok;
    });
  };
  EXPECT_EQ(trouble_with("job-7").code, ExitCode::usage);
  EXPECT_EQ(trouble_with("job-7").error,
            "job-7: no such file; for the mesh of a job, say where the job is with --connect or "
            "--store");
  EXPECT_EQ(trouble_with("wing.vtkhdf").code, ExitCode::not_found);
  EXPECT_EQ(trouble_with("wing.vtkhdf").error, "wing.vtkhdf: no such file");
}

TEST_F(MeshOfAJob, a_path_is_a_path_and_a_folder_the_mesh_in_it) {
  const std::filesystem::path out = folder_.path() / "out";
  make_folders(out);
  const Said empty = said_by([&] {
    find_mesh(out.string(), {}, folder_.path());
    return ExitCode::ok;
  });
  EXPECT_EQ(empty.code, ExitCode::not_found);
  EXPECT_EQ(empty.error, out.string() + ": has no mesh (.vtkhdf, .lb8.ugrid)");
  for (const char* name : {"b.lb8.ugrid", "a.lb8.ugrid", "notes.txt"}) {
    write_file_atomically(out / name, "x");
  }
  EXPECT_EQ(mesh_file(out), out / "a.lb8.ugrid");
  for (const char* name : {"d.vtkhdf", "c.vtkhdf"}) write_file_atomically(out / name, "x");
  EXPECT_EQ(mesh_file(out), out / "c.vtkhdf") << "it knows the sub-domains";
  EXPECT_EQ(mesh_file(out / "b.lb8.ugrid"), out / "b.lb8.ugrid");
  const MeshInput mesh = find_mesh(out.string(), {}, folder_.path());
  EXPECT_EQ(mesh.file, out / "c.vtkhdf");
  EXPECT_EQ(mesh.name, (out / "c.vtkhdf").string());
  EXPECT_EQ(mesh.job, "");
}

}  // namespace
}  // namespace tetfarm
