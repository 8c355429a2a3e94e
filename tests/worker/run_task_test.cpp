#include "worker/run_task.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <stdexcept>
#include <vector>

#include "base/error.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "tasks/extract_contract.h"
#include "tasks/failure_cause.h"
#include "tasks/mesh_contract.h"
#include "worker/evidence.h"
#include "worker/job_forecast.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

class RunTask : public ::testing::Test {
 protected:
  static std::string new_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "run_task-XXXXXX").string();
    return ::mkdtemp(name.data());
  }

  ~RunTask() override { std::filesystem::remove_all(folder_); }

  wire::Envelope run(const TaskBody& body) {
    return run_task(store_, assign_, body,
                    [this](const wire::Doing& progress) { said_.push_back(progress.stage()); });
  }

  TaskFile give(const std::string& name, const std::string& bytes) {
    const StoredArtifact stored = store_.publish(bytes);
    wire::Artifact& input = *assign_.add_inputs();
    input.set_name(name);
    input.set_hash(stored.hash);
    input.set_size(stored.size);
    return {stored.hash, stored.size};
  }

  std::string folder_ = new_folder();
  ArtifactStore store_{folder_};
  wire::Assign assign_;
  std::vector<std::string> said_;
};

TEST_F(RunTask, what_an_attempt_has_in_the_making_goes_with_it_however_it_ends) {
  const auto make = [](TaskIo& io) {
    std::ofstream(io.scratch_path("mesh.vtkhdf")) << "half a mesh";
    EXPECT_EQ(io.scratch_path("mesh.vtkhdf"), io.scratch_path("mesh.vtkhdf"));
    EXPECT_TRUE(std::filesystem::exists(io.scratch_path("mesh.vtkhdf")));
  };
  EXPECT_TRUE(run(make).has_done());
  EXPECT_TRUE(std::filesystem::is_empty(store_.scratch_folder()));
  const wire::Envelope failed = run([&](TaskIo& io) {
    make(io);
    throw IoError("cannot write", "mesh.vtkhdf", ENOSPC);
  });
  EXPECT_EQ(failed.failed().cause(), on_wire(FailureCause::disk_full));
  EXPECT_TRUE(std::filesystem::is_empty(store_.scratch_folder()));
}

TEST_F(RunTask, outputs_lie_in_the_store_under_their_names) {
  const TaskFile word = give("word", "tet");
  const wire::Envelope result = run([&word](TaskIo& io) {
    io.publish("farm", io.read(word) + "farm");
    io.number("tets", 7);
    io.text("reason", "none");
  });
  ASSERT_TRUE(result.has_done());
  ASSERT_EQ(result.done().outputs_size(), 1);
  const wire::Artifact& output = result.done().outputs(0);
  EXPECT_EQ(output.name(), "farm");
  EXPECT_EQ(store_.read(output.hash(), output.size()), "tetfarm");
  EXPECT_EQ(result.done().numbers().at("tets"), 7);
  EXPECT_EQ(result.done().texts().at("reason"), "none");
}

TEST_F(RunTask, what_breaks_its_contract_is_a_defect_of_ours_that_names_the_field) {
  give("subdomain", "a leaf");
  const auto body = [](TaskIo& io) { io.given<ExtractGiven>(); };
  const wire::Envelope lacks = run(body);
  EXPECT_EQ(lacks.failed().cause(), on_wire(FailureCause::for_good));
  EXPECT_EQ(lacks.failed().exit_code(), 1);
  EXPECT_EQ(lacks.failed().message(),
            "the task to extract cannot be done: the file 'mesh' is missing");
  give("mesh", "its tets");
  give("shared", "its neighbours");
  EXPECT_TRUE(run(body).has_done());
  give("spare", "what nobody asked for");
  EXPECT_THAT(run(body).failed().message(), HasSubstr("the file 'spare' is unknown"));
}

TEST_F(RunTask, what_a_task_makes_has_the_names_of_its_contract_beside_figures_for_people) {
  const wire::Envelope result = run([](TaskIo& io) {
    io.number("min_dihedral_deg", 9);
    io.made(MeshMade{io.publish("tets"), 3, 4});
  });
  const wire::Done& done = result.done();
  ASSERT_EQ(done.outputs_size(), 1);
  EXPECT_EQ(done.outputs(0).name(), "mesh");
  EXPECT_EQ(store_.read(done.outputs(0).hash(), done.outputs(0).size()), "tets");
  EXPECT_THAT(done.numbers(), UnorderedElementsAre(Pair("interior_nodes", 3), Pair("tets", 4),
                                                   Pair("min_dihedral_deg", 9)));
}

TEST_F(RunTask, bad_input_ends_the_job_with_its_exit_code_and_evidence) {
  const wire::Envelope result = run([](TaskIo&) {
    throw RefusedInput("open edge at (1, 2, 3)", {{"wing.defects.vtp", "<VTKFile/>"}});
  });
  ASSERT_TRUE(result.has_failed());
  const wire::Failed& failed = result.failed();
  EXPECT_EQ(failed.cause(), on_wire(FailureCause::for_good));
  EXPECT_EQ(failed.exit_code(), 3);
  EXPECT_THAT(failed.message(), HasSubstr("(1, 2, 3)"));
  ASSERT_EQ(failed.evidence_size(), 1);
  EXPECT_EQ(failed.evidence(0).name(), "wing.defects.vtp");
  EXPECT_EQ(store_.read(failed.evidence(0).hash(), failed.evidence(0).size()), "<VTKFile/>");
}

TEST_F(RunTask, a_surface_that_was_not_recovered_is_called_our_defect_with_a_file_to_send) {
  Subdomain subdomain;
  subdomain.path = {5};
  subdomain.vertices = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  subdomain.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (std::uint32_t i = 0; i < 4; ++i) subdomain.triangle_origin.push_back({0, i + 10});
  const wire::Envelope result = run([&](TaskIo& io) {
    throw unrecovered_subdomain(io, subdomain, "1 boundary triangles were not recovered", {2});
  });
  const wire::Failed& failed = result.failed();
  EXPECT_EQ(failed.cause(), on_wire(FailureCause::for_good));
  EXPECT_EQ(failed.exit_code(), 1);
  EXPECT_THAT(failed.message(), HasSubstr("sub-domain LR: 1 boundary"));
  EXPECT_THAT(failed.message(), HasSubstr("triangle 12 of the input at (0.333333"));
  EXPECT_THAT(failed.message(), HasSubstr("bug in Tetfarm"));
  ASSERT_EQ(failed.evidence_size(), 2);
  EXPECT_EQ(failed.evidence(0).name(), "subdomain_LR.defects.vtp");
  const wire::Artifact& to_send = failed.evidence(1);
  EXPECT_THAT(failed.message(), HasSubstr("send " + to_send.name()));
  const std::string file = folder_ + "/sent.off";
  std::ofstream(file) << store_.read(to_send.hash(), to_send.size());
  const SurfaceMesh sent = read_surface(file);
  EXPECT_EQ(sent.vertices, subdomain.vertices);
  EXPECT_EQ(sent.triangles, subdomain.triangles);
}

TEST_F(RunTask, a_wrong_job_file_is_not_tried_again) {
  const wire::Envelope result =
      run([](TaskIo&) { throw UsageError("unknown key", "job.toml:3:1"); });
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
  EXPECT_EQ(result.failed().exit_code(), 2);
}

TEST_F(RunTask, a_full_disk_and_lack_of_memory_are_no_crash) {
  const wire::Envelope disk = run([](TaskIo&) { throw IoError("write", "/x", ENOSPC); });
  EXPECT_EQ(disk.failed().cause(), on_wire(FailureCause::disk_full));
  EXPECT_EQ(disk.failed().exit_code(), 6);
  const wire::Envelope memory = run([](TaskIo&) { throw std::bad_alloc(); });
  EXPECT_EQ(memory.failed().cause(), on_wire(FailureCause::out_of_memory));
}

TEST_F(RunTask, any_other_exception_is_worth_another_try) {
  const wire::Envelope result = run([](TaskIo&) { throw std::runtime_error("odd"); });
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::error));
  EXPECT_EQ(result.failed().message(), "odd");
}

TEST_F(RunTask, missing_and_damaged_inputs_are_named) {
  const std::array<TaskFile, 2> inputs = {give("missing", "one"), give("damaged", "two")};
  std::filesystem::remove(store_.path_of(assign_.inputs(0).hash()));
  const std::filesystem::path damaged = store_.path_of(assign_.inputs(1).hash());
  std::filesystem::permissions(damaged, std::filesystem::perms::owner_all);
  std::ofstream(damaged) << "tow";
  for (const TaskFile& input : inputs) {
    for (const TaskBody& look : {TaskBody([&](TaskIo& io) { io.read(input); }),
                                 TaskBody([&](TaskIo& io) { io.path(input); })}) {
      const wire::Envelope result = run(look);
      EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::damaged_input));
      EXPECT_THAT(result.failed().damaged_inputs(), ElementsAre(input.hash));
    }
  }
}

TEST_F(RunTask, an_unknown_kind_fails) { EXPECT_TRUE(run(nullptr).has_failed()); }

TEST_F(RunTask, every_stage_is_told_once_however_often_it_is_said) {
  const wire::Envelope result = run([](TaskIo& io) {
    for (int round = 0; round < 100; ++round) {
      io.progress().begin(WorkStage::edges, 10);
      for (int i = 0; i < 10; ++i) io.progress().add();
      io.progress().begin(WorkStage::points, 10);
      for (int i = 0; i < 10; ++i) io.progress().add();
    }
  });
  ASSERT_GE(said_.size(), 2U);
  EXPECT_LT(said_.size(), 100U);
  EXPECT_EQ(said_[0], "edges");
  EXPECT_EQ(said_[1], "points");
}

TEST_F(RunTask, a_missing_store_is_a_failure_not_a_crash) {
  const wire::Envelope result = run_task_in(
      "/nowhere/at/all", assign_, [](TaskIo&) {}, [](const wire::Doing&) {});
  EXPECT_TRUE(result.has_failed());
}

TEST_F(RunTask, every_end_has_its_cause_its_exit_code_and_its_words) {
  struct Case {
    std::function<void()> end;
    FailureCause cause;
    int exit_code;
    const char* message;
  };
  const std::vector<Case> cases = {
      {[] { throw OwnDefect("ours", {}); }, FailureCause::for_good, 1, "ours"},
      {[] { throw RefusedInput("open", {}); }, FailureCause::for_good, 3, "open"},
      {[] { throw InvalidInput("no surface", "a.stl:7"); }, FailureCause::for_good, 3,
       "a.stl:7: no surface"},
      {[] { throw UsageError("unknown key", "job.toml:3:1"); }, FailureCause::for_good, 2,
       "job.toml:3:1: unknown key"},
      {[] { throw JobTooLarge("too large"); }, FailureCause::for_good, 6, "too large"},
      {[] { throw DamagedInput("it is damaged", "a hash"); }, FailureCause::damaged_input, 1,
       "it is damaged"},
      {[] { throw IoError("cannot write", "/x", EDQUOT); }, FailureCause::disk_full, 6,
       "/x: cannot write: Disk quota exceeded"},
      {[] { throw IoError("cannot map", "/x", ENOMEM); }, FailureCause::out_of_memory, 6,
       "/x: cannot map: Cannot allocate memory"},
      {[] { throw IoError("cannot read", "/x", EIO); }, FailureCause::error, 1,
       "/x: cannot read: Input/output error"},
      {[] { throw CorruptFile("is no file of ours", "/x"); }, FailureCause::error, 1,
       "/x: is no file of ours"},
      {[] { throw Error(ExitCode::failed, "odd"); }, FailureCause::error, 1, "odd"},
      {[] { throw Error(ExitCode::out_of_resources, "full"); }, FailureCause::disk_full, 6, "full"},
      {[] { throw std::bad_alloc(); }, FailureCause::out_of_memory, 6, "out of memory"},
      {[] { throw std::length_error("a vector"); }, FailureCause::error, 1, "a vector"}};
  for (const Case& one : cases) {
    const wire::Envelope result = run([&one](TaskIo&) { one.end(); });
    ASSERT_TRUE(result.has_failed()) << one.message;
    EXPECT_EQ(result.failed().cause(), on_wire(one.cause)) << one.message;
    EXPECT_EQ(result.failed().exit_code(), one.exit_code) << one.message;
    EXPECT_EQ(result.failed().message(), one.message);
  }
  assign_.set_kind(77);
  EXPECT_EQ(run(nullptr).failed().message(), "this worker cannot run tasks of kind 77");
}

TEST_F(RunTask, evidence_that_cannot_be_kept_does_not_hide_the_reason) {
  const wire::Envelope result = run([this](TaskIo&) {
    std::filesystem::remove_all(store_.scratch_folder());
    std::filesystem::remove_all(folder_ + "/artifacts");
    std::ofstream(folder_ + "/artifacts") << "no folder";
    throw RefusedInput("open edge", {{"a.vtp", "a"}, {"b.vtp", "b"}});
  });
  EXPECT_THAT(result.failed().message(),
              ::testing::MatchesRegex("open edge; a\\.vtp could not be kept: .*; b\\.vtp could not "
                                      "be kept: .*"));
  EXPECT_EQ(result.failed().cause(), on_wire(FailureCause::for_good));
  EXPECT_EQ(result.failed().evidence_size(), 0);
}

TEST_F(RunTask, a_store_that_is_there_is_worked_in_apart_or_not) {
  for (const bool apart : {false, true}) {
    const wire::Envelope result = run_task_in(
        folder_, assign_,
        [apart](TaskIo& io) {
          EXPECT_EQ(io.is_without_shared_store(), apart);
          io.publish("farm", "bytes");
        },
        [](const wire::Doing&) {}, apart);
    ASSERT_TRUE(result.has_done());
    EXPECT_TRUE(store_.has(result.done().outputs(0).hash(), 5));
  }
  const wire::Envelope missing = run_task_in(
      folder_ + "/nothing", assign_, [](TaskIo&) {}, [](const wire::Doing&) {});
  EXPECT_EQ(missing.failed().cause(), on_wire(FailureCause::error));
  EXPECT_EQ(missing.failed().exit_code(), 5) << "the store was not found";
}

}  // namespace
}  // namespace tetfarm
